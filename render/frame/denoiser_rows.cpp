#include "render/frame/denoiser_rows.h"

#include <algorithm>
#include <span>

namespace carom::render {

template <class Use>
void DenoiserRows::for_pixels(int y, const Use& use) const {
    std::vector<DenoiserPixel> pixels;
    const int most = static_cast<int>(DenoiserValues::kMost);
    for (int first = 0; first < part_.width; first += most) {
        pixels.clear();
        for (int x = first; x < std::min(first + most, part_.width); ++x) {
            const auto at = part_.pixel(x, y);
            const int tile = tiles_.tile_of(at.first, at.second);
            const TileSums& sums = sums_[static_cast<std::size_t>(tile)];
            pixels.push_back({&sums, &sums.traced, tiles_.area(tile).pixel(at.first, at.second)});
        }
        use(first, std::span<const DenoiserPixel>(pixels));
    }
}

DenoiseShape DenoiserRows::shape() const {
    return {part_.width, part_.height, PixelFeatures::kCount, true, true};
}

void DenoiserRows::colours(int y, const ColourRows& rows) const {
    for_pixels(y, [&](int first, std::span<const DenoiserPixel> pixels) {
        DenoiserValues values;
        values.set_colours(pixels);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const int x = first + static_cast<int>(i);
            write_colour(x, y, pixels[i], values, i, rows);
        }
    });
}

void DenoiserRows::features(int y, const FeatureRows& rows) const {
    for_pixels(y, [&](int first, std::span<const DenoiserPixel> pixels) {
        DenoiserValues values;
        values.set_features(pixels);
        const auto copy = [&](const DenoiserValues::Values& from, float* to) {
            std::copy_n(from.begin(), pixels.size(), to + first);
        };
        for (std::size_t f = 0; f < PixelFeatures::kCount; ++f) {
            copy(values.exact(f), rows.exact[f]);
            copy(values.error(f), rows.error[f]);
            copy(values.difference(f), rows.difference[f]);
        }
        copy(values.share(), rows.share);
    });
}

void DenoiserRows::write_colour(int x, int y, const DenoiserPixel& pixel,
                                const DenoiserValues& values, std::size_t i,
                                const ColourRows& rows) const {
    V3f mean = pixel.sums->mean(pixel.pixel);
    V3f added(0, 0, 0);
    if (!pictures_.empty()) {
        const V3f a = pictures_[0].at(x, y);
        const V3f b = pictures_[1].at(x, y);
        mean += 0.5F * a;
        mean += 0.5F * b;
        added = 0.5F * (a - b);
    }
    for (int c = 0; c < 3; ++c) {
        rows.mean[c][x] = mean[c];
        rows.difference[c][x] = with_added_colour(
            values.difference_of_colour(static_cast<std::size_t>(c))[i], added[c]);
    }
    rows.variance[x] = values.variance()[i];
}

}  // namespace carom::render
