#include "pipeline/export/textures/picture_sampler.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "render/image_files/picture_light.h"

namespace carom::pipeline {

namespace {

using render::RawPicture;

std::vector<float> meanings_of_codes(const RawPicture& picture, bool is_linear) {
    std::vector<std::uint8_t> codes(256);
    std::iota(codes.begin(), codes.end(), std::uint8_t{0});
    const RawPicture all{256, 1, 1, false, std::move(codes), false, picture.gamma};
    std::vector<float> meanings;
    for (std::size_t i = 0; i < all.pixel_count(); ++i) {
        meanings.push_back(render::pixel_light(all, i, is_linear).colour.x);
    }
    return meanings;
}

int repeated(long long i, int count) {
    const long long rest = i % count;
    return static_cast<int>(rest < 0 ? rest + count : rest);
}

/// A number of pixels, as a whole number and the rest; what rounding left of a whole one is 0.
struct Split {
    long long whole;
    float rest;

    explicit Split(double x) {
        constexpr double kRounding = 1e-6;
        const double down = std::floor(x + kRounding);
        whole = static_cast<long long>(down);
        rest = x - down < kRounding ? 0 : static_cast<float>(x - down);
    }
};

}  // namespace

PictureSampler::PictureSampler(std::shared_ptr<const RawPicture> picture, bool is_linear)
    : picture_(std::move(picture)), is_linear_(is_linear) {
    if (std::holds_alternative<std::vector<std::uint8_t>>(picture_->values) &&
        !picture_->is_associated) {
        codes_ = meanings_of_codes(*picture_, is_linear);
    }
}

PictureSampler::Texel PictureSampler::pixel(int x, int y) const {
    const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_->width) +
                          static_cast<std::size_t>(x);
    if (codes_.empty()) {
        const render::PixelLight light = render::pixel_light(*picture_, i, is_linear_);
        return {light.colour, light.alpha};
    }
    const auto channels = static_cast<std::size_t>(picture_->channels);
    const std::uint8_t* code =
        std::get<std::vector<std::uint8_t>>(picture_->values).data() + i * channels;
    Texel texel;
    for (std::size_t c = 0; c < 3; ++c) {
        texel.colour[static_cast<int>(c)] = codes_[code[channels < 3 ? 0 : c]];
    }
    if (picture_->has_alpha()) {
        texel.alpha = static_cast<float>(code[channels - 1]) / 255;
        texel.colour *= texel.alpha;
    }
    return texel;
}

PictureSampler::Texel PictureSampler::at(const Vec2& place) const {
    const Split x(place.x * picture_->width - 0.5);
    const Split y((1 - place.y) * picture_->height - 0.5);
    Texel sum{{0, 0, 0}, 0};
    for (int row = 0; row < (y.rest > 0 ? 2 : 1); ++row) {
        for (int column = 0; column < (x.rest > 0 ? 2 : 1); ++column) {
            const Texel one = pixel(repeated(x.whole + column, picture_->width),
                                    repeated(y.whole + row, picture_->height));
            const float weight =
                (column == 0 ? 1 - x.rest : x.rest) * (row == 0 ? 1 - y.rest : y.rest);
            sum.colour += weight * one.colour;
            sum.alpha += weight * one.alpha;
        }
    }
    return sum;
}

}  // namespace carom::pipeline
