#include "pipeline/export/textures/texture_place.h"

#include <algorithm>
#include <cmath>

namespace carom::pipeline {

namespace {

using render::Mapping;

TexturePlace place_of(const render::Placement& placement, Mapping mapping, bool by_length) {
    TexturePlace place;
    place.mapping = mapping;
    place.rotation = placement.rotation;
    if (mapping == Mapping::planar) {
        place.facing = placement.facing.normalized();
    }
    place.by_length = by_length && (mapping == Mapping::uv || mapping == Mapping::spherical);
    return place;
}

/// A flat pattern.
std::optional<PlacedTexture> placed_pattern(const render::Placement& placement,
                                            const TextureTile& tile, bool repeats) {
    if (placement.mapping == Mapping::own) {
        return std::nullopt;
    }
    return PlacedTexture{place_of(placement, placement.mapping, true), tile, nullptr, repeats};
}
const TextureTile kPatch{{1, 1}, {-0.5, -0.5}};  // of a pattern that does not repeat

struct AddTextures {
    std::vector<PlacedTexture>& textures;

    void operator()(const std::shared_ptr<const render::MixTexture>& mix) const {
        add_textures(mix->a, textures);
        add_textures(mix->b, textures);
        add_textures(mix->by, textures);
    }
    void operator()(const auto& texture) const {
        if constexpr (requires { placed(texture); }) {
            if (const std::optional<PlacedTexture> known = placed(texture)) {
                textures.push_back(*known);
            }
        }
    }
};

bool is_whole(double ratio) {
    constexpr double kTolerance = 1e-6;
    return ratio > 0.5 && std::abs(ratio - std::round(ratio)) <= kTolerance * ratio;
}

}  // namespace

PlacedTexture placed(const render::ImageTexture& image) {
    const Mapping wanted = image.placement.mapping;
    const Mapping mapping = wanted == Mapping::own ? Mapping::uv : wanted;
    const Vec2 repeats = image.size ? Vec2(1, 1) / *image.size : image.scale;
    return {place_of(image.placement, mapping, image.size.has_value()),
            {repeats, image.offset},
            &image};
}

std::optional<PlacedTexture> placed(const render::CheckerTexture& checker) {
    // render/texture/kernels/checker.h shifts the squares by this fraction of one.
    constexpr double kShift = 0.0137;
    const double repeats = 1 / (2 * checker.size);
    return placed_pattern(checker.placement,
                          {Vec2(repeats, repeats), Vec2(-kShift / 2, -kShift / 2)}, true);
}
std::optional<PlacedTexture> placed(const render::ClothTexture& cloth) {
    return placed_pattern(cloth.placement, kPatch, false);
}
std::optional<PlacedTexture> placed(const render::WoodTexture& wood) {
    return placed_pattern(wood.placement, kPatch, false);
}

void add_textures(const render::ColourSource& source, std::vector<PlacedTexture>& textures) {
    std::visit(AddTextures{textures}, source);
}

void add_textures(const render::NumberSource& source, std::vector<PlacedTexture>& textures) {
    if (const render::NumberTexture* texture = source.texture()) {
        add_textures(texture->pattern, textures);
    }
}

void add_textures(const render::Relief& relief, std::vector<PlacedTexture>& textures) {
    if (const auto* normal = std::get_if<render::NormalPicture>(&relief)) {
        textures.push_back(placed(normal->image));
    } else if (const auto* height = std::get_if<render::HeightTexture>(&relief)) {
        add_textures(height->number.pattern, textures);
    }
}

bool fit_together(const PlacedTexture& a, const PlacedTexture& b) {
    const Vec2 ratio = a.tile.repeats / b.tile.repeats;
    return a.place == b.place &&
           (!a.repeats || !b.repeats || (is_whole(ratio.x) && is_whole(ratio.y)) ||
            (is_whole(1 / ratio.x) && is_whole(1 / ratio.y)));
}

std::optional<PlacedTexture> shared_texture(const std::vector<PlacedTexture>& textures) {
    if (textures.empty()) {
        return std::nullopt;
    }
    // A picture, or what repeats, before what does not.
    const auto rank = [](const PlacedTexture& t) {
        return t.image != nullptr ? 0 : t.repeats ? 1 : 2;
    };
    PlacedTexture largest = *std::ranges::min_element(textures, {}, rank);
    const auto density = [](const PlacedTexture& t) { return t.tile.repeats.x * t.tile.repeats.y; };
    for (const PlacedTexture& texture : textures) {
        if (texture.repeats && fit_together(texture, largest) &&
            density(texture) < density(largest)) {
            largest = texture;
        }
    }
    return largest;
}

}  // namespace carom::pipeline
