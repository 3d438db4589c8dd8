#include "render/sampling/distribution_2d.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/assert.h"

namespace carom::render {
namespace {

double usable(float weight) {
    return std::isfinite(weight) && weight > 0 ? weight : 0.0;
}

/// Writes the running sum of `values`, divided by their total, into `cdf` (one longer) and returns
/// the total. Without any weight the cdf is that of the uniform distribution.
template <class Values>
double accumulate(const Values& values, std::span<float> cdf) {
    double total = 0;
    for (const auto value : values) {
        total += value;
    }
    double running = 0;
    const std::size_t count = cdf.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        cdf[i] = static_cast<float>(
            total > 0 ? running / total : static_cast<double>(i) / static_cast<double>(count));
        running += values[i];
    }
    cdf[count] = 1;
    return total;
}

/// The cutpoint method (Chen and Asau, On generating random variates from an empirical
/// distribution, AIIE Transactions 6(2), 1974): for each of `cuts.size()` equal parts of [0, 1) the
/// cell in which the part begins. The search from there takes few steps, and the map stays
/// monotone, so that well-spread points stay well spread.
void set_cuts(std::span<const float> cdf, std::span<std::uint16_t> cuts) {
    std::size_t index = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const float u = static_cast<float>(i) / static_cast<float>(cuts.size());
        while (index + 2 < cdf.size() && cdf[index + 1] <= u) {
            ++index;
        }
        cuts[i] = static_cast<std::uint16_t>(index);
    }
}

}  // namespace

Distribution2D::Distribution2D(std::span<const float> weights, int width, int height)
    : width_(width), height_(height) {
    CAROM_ASSERT(width > 0 && width <= 0xffff && height > 0 && height <= 0xffff);
    const std::size_t columns = static_cast<std::size_t>(width);
    const std::size_t rows = static_cast<std::size_t>(height);
    CAROM_ASSERT(weights.size() == columns * rows);
    column_cdfs_.resize(rows * (columns + 1));
    row_cdf_.resize(rows + 1);
    std::vector<double> row_totals(rows);
    std::vector<double> row(columns);
    for (std::size_t y = 0; y < rows; ++y) {
        std::transform(weights.begin() + static_cast<std::ptrdiff_t>(y * columns),
                       weights.begin() + static_cast<std::ptrdiff_t>((y + 1) * columns),
                       row.begin(), usable);
        row_totals[y] =
            accumulate(row, std::span(column_cdfs_).subspan(y * (columns + 1), columns + 1));
    }
    mean_ = accumulate(row_totals, row_cdf_) / static_cast<double>(columns * rows);
    row_cuts_.resize(rows + 2);
    set_cuts(row_cdf_, std::span(row_cuts_).first(rows));
    column_cuts_.resize(weights.size() + 2);
    for (std::size_t y = 0; y < rows; ++y) {
        set_cuts(std::span(column_cdfs_).subspan(y * (columns + 1), columns + 1),
                 std::span(column_cuts_).subspan(y * columns, columns));
    }
    density_.resize(weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) {
        density_[i] = mean_ > 0 ? static_cast<float>(usable(weights[i]) / mean_) : 0.f;
    }
}

}  // namespace carom::render
