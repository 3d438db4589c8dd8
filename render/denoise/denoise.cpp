#include "render/denoise/denoise.h"

#include <algorithm>

#include <Imath/half.h>

#include "core/assert.h"
#include "core/error.h"
#include "render/denoise/band.h"

namespace carom::render {
namespace {

// A band's rows and 38 around them are in memory; half of those are also computed again. Narrow
// pictures have higher bands, which take no more memory than those of a wide one. If only the error
// is wanted, the sums of all samples are in memory, too, and bands are lower.
constexpr int kLeastBandRows = 128;
constexpr int kLeastErrorRows = 64;

/// `has_picture`: whether the result has colours.
DenoisedPicture denoise_all(const DenoiseSource& source, bool has_picture,
                            const WorkContext& context) {
    const DenoiseShape shape = source.shape();
    CAROM_ASSERT(shape.width > 0 && shape.height > 0);
    CAROM_ASSERT(shape.features % 3 == 0 && shape.features <= DenoiseInput::kMostFeatures);
    const std::size_t pixels =
        static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height);
    DenoisedPicture result;
    result.rgb.resize(has_picture ? 3 * pixels : 0);
    result.error.resize(pixels);
    const int least_rows = has_picture ? kLeastBandRows : kLeastErrorRows;
    const int band_rows = std::max(least_rows, 1920 * least_rows / shape.width);
    for (int row = 0; row < shape.height; row += band_rows) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        const RowRange rows{row, std::min(row + band_rows, shape.height)};
        Band(source, rows).denoise(result);
        if (context.progress) {
            context.progress(static_cast<double>(rows.end) / shape.height);
        }
    }
    return result;
}

}  // namespace

DenoiseShape PlaneSource::shape() const {
    return {input_.width, input_.height, input_.features.size(), !input_.variance.empty(),
            !input_.share_of_samples.empty()};
}

void PlaneSource::read(const PlaneView& view, int y, float* row) const {
    const std::ptrdiff_t before = std::ptrdiff_t{y} * input_.width;
    if (view.halves != nullptr) {
        std::transform(view.halves + before, view.halves + before + input_.width, row,
                       imath_half_to_float);
        return;
    }
    const float* first = view.first + before * view.step;
    for (std::ptrdiff_t x = 0; x < input_.width; ++x) {
        row[x] = first[x * view.step];
    }
}

void PlaneSource::colours(int y, const ColourRows& rows) const {
    for (std::size_t c = 0; c < 3; ++c) {
        read(input_.colour[c].mean, y, rows.mean[c]);
        read(input_.colour[c].difference, y, rows.difference[c]);
    }
    if (rows.variance != nullptr) {
        read(input_.variance, y, rows.variance);
    }
}

void PlaneSource::features(int y, const FeatureRows& rows) const {
    for (std::size_t f = 0; f < input_.features.size(); ++f) {
        read(input_.features[f].exact, y, rows.exact[f]);
        read(input_.features[f].error, y, rows.error[f]);
        read(input_.features[f].difference, y, rows.difference[f]);
    }
    if (rows.share != nullptr) {
        read(input_.share_of_samples, y, rows.share);
    }
}

DenoisedPicture denoise(const DenoiseInput& input, const WorkContext& context) {
    return denoise_all(PlaneSource(input), true, context);
}

std::vector<float> error_after_denoising(const DenoiseSource& source, const WorkContext& context) {
    return denoise_all(source, false, context).error;
}

}  // namespace carom::render
