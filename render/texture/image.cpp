#include "render/texture/image.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include <Imath/half.h>
#include <fmt/core.h>

#include "core/assert.h"
#include "core/error.h"
#include "render/image_files/picture_light.h"
#include "render/image_files/read_picture.h"

namespace carom::render {
namespace {

/// Of a LinearImage: its users count in 32 bits.
constexpr std::size_t kMostPixels = std::size_t{1} << 29;

std::uint16_t half_of(float x) {
    return imath_float_to_half(std::min(x, 65504.0f));
}

/// In front of the background.
V3f colour_of(const PixelLight& light, const V3f& background) {
    return light.alpha < 1 ? light.colour + (1 - light.alpha) * background : light.colour;
}

/// What each code of a picture of integers means, as a half float has it.
std::vector<float> values_of_codes(const RawPicture& picture, bool is_linear) {
    const bool has_16_bits = std::holds_alternative<std::vector<std::uint16_t>>(picture.values);
    RawPicture all{has_16_bits ? 0x10000 : 0x100, 1, 1, false, {}, false, picture.gamma};
    std::vector<std::uint16_t> codes(all.pixel_count());
    std::iota(codes.begin(), codes.end(), std::uint16_t{0});
    if (has_16_bits) {
        all.values = std::move(codes);
    } else {
        all.values = std::vector<std::uint8_t>(codes.begin(), codes.end());
    }
    std::vector<float> values;
    for (std::size_t code = 0; code < all.pixel_count(); ++code) {
        values.push_back(
            HalfNumberCodec::decode(half_of(pixel_light(all, code, is_linear).colour.x)));
    }
    return values;
}

/// Whether the finest level is kept as the integers of the file.
bool has_codes(const RawPicture& picture) {
    return !picture.has_alpha() && !std::holds_alternative<std::vector<float>>(picture.values) &&
           picture.pixel_count() > 1;  // another level follows
}

/// As MipPyramid halves sizes.
int half_size(int size) {
    return (size + 1) / 2;
}

}  // namespace

LinearImage read_linear_image(const std::string& path, bool is_linear, const V3f& background) {
    const RawPicture picture = read_picture(path);
    const std::size_t count = picture.pixel_count();
    LinearImage image{picture.width, picture.height, {}};
    if (count > kMostPixels) {
        throw Error(fmt::format("image '{}' is {} x {} pixels; at most {} are read", path,
                                picture.width, picture.height, kMostPixels));
    }
    image.pixels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const PixelLight light = pixel_light(picture, i, is_linear);
        image.clamped += light.is_clamped ? 1 : 0;
        image.transparent += light.alpha < 1 ? 1 : 0;
        image.pixels.push_back(colour_of(light, background));
    }
    return image;
}

ColourWithAlpha HalfColourCodec::decode(const Texel& texel) {
    const auto first = std::uint32_t{texel.r} | std::uint32_t{texel.g} << 16;
    const auto second = std::uint32_t{texel.b} | std::uint32_t{texel.alpha} << 16;
    const V3f colour = scalar::half_colour<scalar::One>(first, second);
    return {colour.x, colour.y, colour.z, scalar::half_colour<scalar::One, true>(first, second).x};
}

HalfColourCodec::Texel HalfColourCodec::encode(const Value& value) {
    return {half_of(value.x), half_of(value.y), half_of(value.z), half_of(value.w)};
}

HalfNumberCodec::Texel HalfNumberCodec::encode(Value value) {
    return half_of(value);
}

bool ImagePyramid::fits(const RawPicture& picture) {
    int width = picture.width;
    int height = picture.height;
    if (has_codes(picture)) {
        const bool has_16_bits = std::holds_alternative<std::vector<std::uint16_t>>(picture.values);
        if ((picture.value_count() + kReadBeyond) * (has_16_bits ? 2 : 1) >
            std::numeric_limits<std::int32_t>::max()) {
            return false;
        }
        width = half_size(width);
        height = half_size(height);
    }
    return picture.channels == 1 ? MipPyramid<HalfNumberCodec>::fits(width, height)
                                 : ColourPyramid::fits(width, height);
}

namespace {

std::size_t code_at(const RawPicture& picture, std::size_t i) {
    const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&picture.values);
    return bytes != nullptr ? (*bytes)[i] : std::get<std::vector<std::uint16_t>>(picture.values)[i];
}

/// A colour, or a number of a grey picture.
template <class Value>
Value value_of(const V3f& colour, float alpha) {
    if constexpr (std::is_same_v<Value, float>) {
        return colour.x;
    } else {
        return {colour.x, colour.y, colour.z, alpha};
    }
}

}  // namespace

/// The levels behind the finest one, from the codes.
template <class Codec>
MipPyramid<Codec> ImagePyramid::levels_behind(const RawPicture& picture) const {
    const auto channels = static_cast<std::size_t>(picture.channels);
    const auto from = [&](int x, int y) {
        const std::size_t first = place(x, y) * channels;
        V3f colour;
        for (std::size_t c = 0; c < 3; ++c) {
            colour[static_cast<int>(c)] = values_[code_at(picture, first + c % channels)];
        }
        return colour;
    };
    return {half_size(width_), half_size(height_), Wrap::repeat, [&](int x, int y) {
                const int x1 = std::min(2 * x + 1, width_ - 1);
                const int y1 = std::min(2 * y + 1, height_ - 1);
                const V3f mean = mean_of_four(from(2 * x, 2 * y), from(x1, 2 * y), from(2 * x, y1),
                                              from(x1, y1));
                return Codec::encode(value_of<typename Codec::Value>(mean, 1));
            }};
}

ImagePyramid::ImagePyramid(RawPicture picture, bool is_linear)
    : width_(picture.width), height_(picture.height), has_alpha_(picture.has_alpha()) {
    CAROM_ASSERT(fits(picture));
    const auto set_levels = [&]<class Codec>(Codec) {
        if (!values_.empty()) {
            levels_ = levels_behind<Codec>(picture);
            return;
        }
        levels_ = MipPyramid<Codec>(width_, height_, Wrap::repeat, [&](int x, int y) {
            const PixelLight light = pixel_light(picture, place(x, y), is_linear);
            return Codec::encode(value_of<typename Codec::Value>(light.colour, light.alpha));
        });
    };
    if (has_codes(picture)) {
        values_ = values_of_codes(picture, is_linear);
    }
    if (picture.channels == 1) {
        set_levels(HalfNumberCodec());
    } else {
        set_levels(HalfColourCodec());
    }
    if (!values_.empty()) {
        codes_ = std::move(picture.values);
        std::visit([](auto& codes) { codes.resize(codes.size() + kReadBeyond); }, codes_);
    }
}

ImageTables ImagePyramid::tables() const {
    ImageTables tables;
    tables.levels = std::visit([](const auto& levels) { return levels.tables(); }, levels_);
    tables.is_grey = std::holds_alternative<MipPyramid<HalfNumberCodec>>(levels_);
    tables.has_alpha = has_alpha_;
    tables.width = width_;
    tables.height = height_;
    if (!values_.empty()) {
        tables.codes = std::visit([](const auto& codes) { return bytes_of(codes); }, codes_);
        tables.values = List<float>(values_);
        tables.has_16_bits = std::holds_alternative<std::vector<std::uint16_t>>(codes_);
    }
    return tables;
}

void check_fits(const std::string& path, const RawPicture& picture, bool fits) {
    if (!fits) {
        throw Error(fmt::format(
            "image '{}' is {} x {} pixels, which as a texture would take more than 2 GiB; make it "
            "smaller",
            path, picture.width, picture.height));
    }
}

namespace {

/// Without an alpha that is 1 all over, as many programs write it.
RawPicture without_opaque_alpha(RawPicture picture) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    const auto strip = [&](auto& values) {
        using Value = typename std::remove_reference_t<decltype(values)>::value_type;
        const auto one =
            std::is_floating_point_v<Value> ? Value{1} : std::numeric_limits<Value>::max();
        for (std::size_t i = channels - 1; i < values.size(); i += channels) {
            if (values[i] < one) {
                return;
            }
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < picture.value_count(); ++i) {
            if (i % channels != channels - 1) {
                values[kept++] = values[i];
            }
        }
        values.resize(kept);
        picture.channels -= 1;
    };
    if (picture.has_alpha()) {
        std::visit(strip, picture.values);
    }
    return picture;
}

}  // namespace

std::shared_ptr<const ImagePyramid> load_image_pyramid(const std::string& path, bool is_linear,
                                                       const ReadPicture& read) {
    RawPicture picture = without_opaque_alpha(read(path));
    check_fits(path, picture, ImagePyramid::fits(picture));
    return std::make_shared<const ImagePyramid>(std::move(picture), is_linear);
}

}  // namespace carom::render
