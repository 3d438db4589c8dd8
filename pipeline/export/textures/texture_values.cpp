#include "pipeline/export/textures/texture_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/colour.h"
#include "pipeline/export/plain_colour.h"
#include "pipeline/export/textures/picture_sampler.h"

namespace carom::pipeline {

namespace {

using Imath::V3f;
using render::PictureChannel;

/// In front of the background, or if it `is_bare`, the colour of what is opaque.
V3f shown_colour(const PictureSampler::Texel& texel, const V3f& background, bool is_bare) {
    constexpr float kInvisible = 1e-4F;
    if (is_bare) {
        return texel.alpha > kInvisible ? texel.colour / texel.alpha : texel.colour;
    }
    return texel.colour + (1 - texel.alpha) * background;
}

ColourAt picture_values(const render::ImageTexture& image, PictureStore& pictures, bool is_linear,
                        bool is_bare) {
    const PictureSampler sampler(pictures.picture(image.file), is_linear);
    const V3f background(image.background.value_or(render::kTransparentColour));
    return [sampler, background, tint = V3f(image.tint), tile = placed(image).tile,
            shows_parts = is_bare && !image.background](const Vec2& c) {
        return shown_colour(sampler.at(tile.in_texture(c)), background, shows_parts) * tint;
    };
}

struct ColourValues {
    const PlacedTexture& shared;
    PictureStore& pictures;
    bool is_bare;

    ColourAt operator()(const render::ImageTexture& image) const {
        if (!fit_together(placed(image), shared)) {
            return constant(image);
        }
        return picture_values(image, pictures, image.is_linear, is_bare);
    }
    ColourAt operator()(const render::CheckerTexture& checker) const {
        const auto known = placed(checker);
        if (!known || !fit_together(*known, shared)) {
            return constant(checker);
        }
        return
            [tile = known->tile, even = V3f(checker.even), odd = V3f(checker.odd)](const Vec2& c) {
                const Vec2 t = tile.in_texture(c);
                const bool is_left = t.x - std::floor(t.x) < 0.5;
                const bool is_low = t.y - std::floor(t.y) < 0.5;
                return is_left == is_low ? even : odd;
            };
    }
    ColourAt operator()(const std::shared_ptr<const render::MixTexture>& mix) const {
        const ColourValues parts{shared, pictures, is_bare || mix->by.texture() != nullptr};
        return [a = std::visit(parts, mix->a), b = std::visit(parts, mix->b),
                by = number_values(mix->by, shared, pictures, NumberUse::mask)](const Vec2& c) {
            const float weight = std::clamp(by(c), 0.0F, 1.0F);
            return a(c) * (1 - weight) + b(c) * weight;
        };
    }
    ColourAt operator()(const auto& other) const { return constant(other); }

  private:
    static ColourAt constant(const render::ColourSource& source) {
        return [colour = V3f(plain_colour(source))](const Vec2&) { return colour; };
    }
};

float part_of(const V3f& colour, PictureChannel channel) {
    switch (channel) {
        case PictureChannel::red:
            return colour.x;
        case PictureChannel::green:
            return colour.y;
        case PictureChannel::blue:
            return colour.z;
        default:
            return luminance(colour);
    }
}

NumberAt pattern_values(const render::ColourSource& pattern, const PlacedTexture& shared,
                        PictureStore& pictures, NumberUse use) {
    const auto* image = std::get_if<render::ImageTexture>(&pattern);
    if (image != nullptr && !fit_together(placed(*image), shared)) {
        const float value = luminance(V3f(plain_colour(pattern)));
        return [value](const Vec2&) { return value; };
    }
    const PictureChannel channel = image == nullptr
                                       ? PictureChannel::luminance
                                       : channel_of(*image, pictures.facts(image->file), use);
    if (channel == PictureChannel::alpha) {
        const PictureSampler sampler(pictures.picture(image->file), true);
        return [sampler, tile = placed(*image).tile](const Vec2& c) {
            return sampler.at(tile.in_texture(c)).alpha;
        };
    }
    const ColourAt colour = image == nullptr ? colour_values(pattern, shared, pictures)
                                             : picture_values(*image, pictures, true, false);
    return [colour, channel](const Vec2& c) { return part_of(colour(c), channel); };
}

}  // namespace

PictureChannel channel_of(const render::ImageTexture& image, const PictureFacts& facts,
                          NumberUse use) {
    if (image.channel != PictureChannel::automatic) {
        return image.channel;
    }
    return use == NumberUse::mask && facts.has_alpha() ? PictureChannel::alpha
                                                       : PictureChannel::luminance;
}

bool is_as_stored(const render::ImageTexture& image, PictureChannel channel,
                  const PictureFacts& facts) {
    return channel == PictureChannel::alpha ||
           (facts.alpha == AlphaKind::opaque && image.tint == Vec3(1, 1, 1));
}

ColourAt colour_values(const render::ColourSource& source, const PlacedTexture& shared,
                       PictureStore& pictures, bool is_bare) {
    return std::visit(ColourValues{shared, pictures, is_bare}, source);
}

NumberAt number_values(const render::NumberTexture& texture, const PlacedTexture& shared,
                       PictureStore& pictures, NumberUse use) {
    return [pattern = pattern_values(texture.pattern, shared, pictures, use),
            from = static_cast<float>(texture.range.x), to = static_cast<float>(texture.range.y)](
               const Vec2& c) { return from + (to - from) * pattern(c); };
}

NumberAt number_values(const render::NumberSource& source, const PlacedTexture& shared,
                       PictureStore& pictures, NumberUse use) {
    if (const render::NumberTexture* texture = source.texture()) {
        return number_values(*texture, shared, pictures, use);
    }
    return [value = static_cast<float>(source.constant_or(0))](const Vec2&) { return value; };
}

ColourAt normal_values(const render::NormalPicture& picture, PictureStore& pictures) {
    const PictureSampler sampler(pictures.picture(picture.image.file), true);
    return [sampler, tile = placed(picture.image).tile](const Vec2& c) {
        return 2.0F * sampler.at(tile.in_texture(c)).colour - V3f(1);
    };
}

}  // namespace carom::pipeline
