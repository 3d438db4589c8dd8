#include "render/sampling/pixel_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/assert.h"
#include "core/elementary.h"

namespace carom::render {
namespace {

constexpr int kCells = 512;          // of the tabulated density, over the whole width
constexpr int kGuides = 4 * kCells;  // few guides span more than two cells
constexpr int kStepsPerCell = 128;   // of the numerical integration

}  // namespace

double filter_profile(PixelFilter filter, double x) {
    if (std::abs(x) > 0.5) {
        return 0;
    }
    switch (filter) {
        case PixelFilter::box:
            return 1;
        case PixelFilter::gaussian:
            return exponential(-18 * x * x);
        case PixelFilter::blackman_harris: {
            const double c = cosine(2 * std::numbers::pi * x);  // the window's centre is at 0 here
            const double twice = 2 * c * c - 1;                 // cosines of the multiple angles
            const double thrice = c * (2 * twice - 1);
            return 0.35875 + 0.48829 * c + 0.14128 * twice + 0.01168 * thrice;
        }
    }
    return 0;
}

PixelFilterSampler::PixelFilterSampler(PixelFilter filter, double width)
    : filter_(filter), width_(width) {
    CAROM_ASSERT(width > 0);
    // The midpoint rule in each cell.
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
    for (int i = 0; i <= kCells; ++i) {
        Cell cell;
        cell.cdf = static_cast<float>(cumulative[i] / integral);
        cell.start = static_cast<float>(width * (static_cast<double>(i) / kCells - 0.5));
        cell.slope = 0;
        if (i < kCells) {
            const double next =
                static_cast<double>(static_cast<float>(cumulative[i + 1] / integral));
            const double mass = next - static_cast<double>(cell.cdf);
            cell.slope = mass > 0 ? static_cast<float>(width / kCells / mass) : 0.f;
        }
        cells_.push_back(cell);
    }
    guide_.resize(kGuides);
    std::int32_t at = 0;
    for (int g = 0; g < kGuides; ++g) {
        while (cells_[at + 1].cdf <= static_cast<float>(g) / kGuides) {
            ++at;
        }
        guide_[g] = at;
    }
}

PixelFilterTables PixelFilterSampler::tables() const {
    static_assert(sizeof(Cell) == 3 * sizeof(float));
    return {cells_.empty() ? nullptr : &cells_[0].cdf, guide_.data(),
            static_cast<int>(guide_.size()), static_cast<float>(width_)};
}

double PixelFilterSampler::pdf_1d(double offset_pixels) const {
    return norm_ * filter_profile(filter_, offset_pixels / width_);
}

}  // namespace carom::render
