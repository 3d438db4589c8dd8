#include "pipeline/export/textures/baked_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/colour.h"
#include "core/elementary_float.h"
#include "render/image_files/format_module.h"
#include "render/image_files/png_file.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {

namespace {

using Imath::V3f;

constexpr int kCodes = 1 << 16;

std::uint8_t code_of(float value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
}

/// IEC 61966-2-1:1999, 5.2.
float srgb_encoded(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * power(linear, 1 / 2.4F) - 0.055F;
}

/// The codes of colours in steps that are small beside those of the codes.
const std::array<std::uint8_t, kCodes>& srgb_codes() {
    static const std::array<std::uint8_t, kCodes> codes = [] {
        std::array<std::uint8_t, kCodes> made{};
        for (std::size_t i = 0; i < made.size(); ++i) {
            made[i] = code_of(srgb_encoded(static_cast<float>(i) / (kCodes - 1)));
        }
        return made;
    }();
    return codes;
}

std::uint8_t srgb_code(float linear) {
    const float step = (kCodes - 1) * std::clamp(linear, 0.0F, 1.0F);
    return srgb_codes()[static_cast<std::size_t>(std::lround(step))];
}

/// `write(target, x, y)` writes the values of a pixel.
template <class Write>
BakedPicture baked(const BakedGrid& grid, int channels, const Write& write) {
    BakedPicture picture{grid.width, grid.height, channels, {}};
    const auto stride = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(channels);
    picture.values.resize(stride * static_cast<std::size_t>(grid.height));
    render::parallel_for(static_cast<std::size_t>(grid.height), [&](std::size_t y) {
        std::uint8_t* target = picture.values.data() + y * stride;
        for (int x = 0; x < grid.width; ++x, target += channels) {
            write(target, x, static_cast<int>(y));
        }
    });
    return picture;
}

}  // namespace

AlphaKind BakedPicture::alpha() const {
    AlphaKind kind = AlphaKind::opaque;
    for (std::size_t i = 3; channels == 4 && i < values.size(); i += 4) {
        if (values[i] != 0 && values[i] != 255) {
            return AlphaKind::varied;
        }
        kind = values[i] == 0 ? AlphaKind::cut_out : kind;
    }
    return kind;
}

BakedPicture bake_colour(const BakedGrid& grid, const ColourAt& colour, const NumberAt& alpha) {
    return baked(grid, alpha ? 4 : 3, [&](std::uint8_t* target, int x, int y) {
        const Vec2 centre = grid.centre(x, y);
        const V3f value = colour(centre);
        for (int c = 0; c < 3; ++c) {
            target[c] = srgb_code(value[c]);
        }
        if (alpha) {
            target[3] = code_of(alpha(centre));
        }
    });
}

float largest_value(const BakedGrid& grid, const ColourAt& colour) {
    float most = 0;
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            most = std::max(most, largest(colour(grid.centre(x, y))));
        }
    }
    return most;
}

BakedPicture bake_numbers(const BakedGrid& grid, const std::vector<NumberAt>& numbers) {
    return baked(grid, static_cast<int>(numbers.size()), [&](std::uint8_t* target, int x, int y) {
        const Vec2 centre = grid.centre(x, y);
        for (std::size_t c = 0; c < numbers.size(); ++c) {
            target[c] = numbers[c] ? code_of(numbers[c](centre)) : 255;
        }
    });
}

BakedPicture bake_normals(const BakedGrid& grid, const ColourAt& normal) {
    return baked(grid, 3, [&](std::uint8_t* target, int x, int y) {
        const V3f value = normal(grid.centre(x, y));
        for (int c = 0; c < 3; ++c) {
            target[c] = code_of(0.5F * value[c] + 0.5F);
        }
    });
}

EncodedPicture encode(const BakedPicture& picture, PictureFormat wanted) {
    const bool is_jpeg = wanted == PictureFormat::jpeg && picture.channels == 3;
    EncodedPicture result;
    result.format = is_jpeg ? PictureFormat::jpeg : PictureFormat::png;
    result.alpha = picture.alpha();
    result.bytes = is_jpeg ? render::format_module().encode(picture.values, picture.width,
                                                            picture.height, "picture.jpg", {})
                           : render::encode_png(picture.values, picture.width, picture.height, {});
    return result;
}

}  // namespace carom::pipeline
