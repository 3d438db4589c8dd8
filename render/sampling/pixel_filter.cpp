#include "render/sampling/pixel_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "sim/timeline/assert.h"

namespace carom::render {
namespace {

constexpr int kCells = 1024;       // of the tabulated density, over the whole width
constexpr int kStepsPerCell = 64;  // of the integration

}  // namespace

double filter_profile(PixelFilter filter, double x) {
    if (std::abs(x) > 0.5) {
        return 0;
    }
    switch (filter) {
        case PixelFilter::box:
            return 1;
        case PixelFilter::gaussian:
            return std::exp(-18 * x * x);
        case PixelFilter::blackman_harris: {
            const double angle = 2 * std::numbers::pi * x;  // the window's centre is at 0 here
            return 0.35875 + 0.48829 * std::cos(angle) + 0.14128 * std::cos(2 * angle) +
                   0.01168 * std::cos(3 * angle);
        }
    }
    return 0;
}

PixelFilterSampler::PixelFilterSampler(PixelFilter filter, double width)
    : filter_(filter), width_(width) {
    CAROM_ASSERT(width > 0);
    // Midpoint rule, cell by cell.
    std::vector<double> cumulative(kCells + 1, 0.0);
    const double step = 1.0 / (kCells * kStepsPerCell);
    for (int i = 0; i < kCells; ++i) {
        double mass = 0;
        for (int k = 0; k < kStepsPerCell; ++k) {
            mass += step * filter_profile(filter, (i * kStepsPerCell + k + 0.5) * step - 0.5);
        }
        cumulative[i + 1] = cumulative[i] + mass;
    }
    const double integral = cumulative.back();
    norm_ = 1 / (integral * width);
    if (filter == PixelFilter::box) {
        return;
    }
    cdf_.resize(kCells + 1);
    for (int i = 0; i <= kCells; ++i) {
        cdf_[i] = static_cast<float>(cumulative[i] / integral);
    }
    guide_.resize(kCells);
    std::uint16_t cell = 0;
    for (int g = 0; g < kCells; ++g) {
        while (cdf_[cell + 1] <= static_cast<float>(g) / kCells) {
            ++cell;
        }
        guide_[g] = cell;
    }
}

float PixelFilterSampler::offset(float u) const {
    if (cdf_.empty()) {
        return (u - 0.5f) * static_cast<float>(width_);
    }
    std::size_t cell = guide_[static_cast<std::size_t>(u * kCells)];
    while (cdf_[cell + 1] <= u) {
        ++cell;
    }
    const float share = (u - cdf_[cell]) / (cdf_[cell + 1] - cdf_[cell]);
    return ((static_cast<float>(cell) + share) / kCells - 0.5f) * static_cast<float>(width_);
}

double PixelFilterSampler::pdf_1d(double offset_pixels) const {
    return norm_ * filter_profile(filter_, offset_pixels / width_);
}

}  // namespace carom::render
