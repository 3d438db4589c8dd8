#include "render/denoise/denoise.h"

#include <algorithm>

#include "core/assert.h"
#include "core/error.h"
#include "render/denoise/band.h"

namespace carom::render {
namespace {

// A band's rows and 38 around them are in memory; half of those are also computed again. Narrow
// pictures have higher bands, which take no more memory than those of a wide one.
constexpr int kLeastBandRows = 128;
constexpr int kBandPixels = 1920 * kLeastBandRows;

}  // namespace

DenoisedPicture denoise(const DenoiseInput& input, const WorkContext& context) {
    CAROM_ASSERT(input.width > 0 && input.height > 0);
    CAROM_ASSERT(input.features.size() % 3 == 0 &&
                 input.features.size() <= DenoiseInput::kMostFeatures);
    const std::size_t pixels =
        static_cast<std::size_t>(input.width) * static_cast<std::size_t>(input.height);
    DenoisedPicture result;
    result.rgb.resize(3 * pixels);
    result.error.resize(pixels);
    const int band_rows = std::max(kLeastBandRows, kBandPixels / input.width);
    for (int row = 0; row < input.height; row += band_rows) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        const RowRange rows{row, std::min(row + band_rows, input.height)};
        Band(input, rows).denoise(result);
        if (context.progress) {
            context.progress(static_cast<double>(rows.end) / input.height);
        }
    }
    return result;
}

}  // namespace carom::render
