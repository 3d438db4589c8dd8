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

struct AddTextures {
    std::vector<PlacedTexture>& textures;

    void operator()(const render::ImageTexture& image) const { textures.push_back(placed(image)); }
    void operator()(const render::CheckerTexture& checker) const {
        if (const auto known = placed(checker)) {
            textures.push_back(*known);
        }
    }
    void operator()(const std::shared_ptr<const render::MixTexture>& mix) const {
        add_textures(mix->a, textures);
        add_textures(mix->b, textures);
        add_textures(mix->by, textures);
    }
    void operator()(const auto& /*without a place*/) const {}
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
    const Mapping mapping = checker.placement.mapping;
    if (mapping == Mapping::own) {
        return std::nullopt;
    }
    const double repeats = 1 / (2 * checker.size);
    return PlacedTexture{place_of(checker.placement, mapping, true),
                         {Vec2(repeats, repeats), Vec2(-kShift / 2, -kShift / 2)}};
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
    return a.place == b.place && ((is_whole(ratio.x) && is_whole(ratio.y)) ||
                                  (is_whole(1 / ratio.x) && is_whole(1 / ratio.y)));
}

std::optional<PlacedTexture> shared_texture(const std::vector<PlacedTexture>& textures) {
    if (textures.empty()) {
        return std::nullopt;
    }
    const auto is_picture = [](const PlacedTexture& t) { return t.image != nullptr; };
    const auto picture = std::ranges::find_if(textures, is_picture);
    PlacedTexture largest = picture != textures.end() ? *picture : textures.front();
    const auto repeats = [](const PlacedTexture& t) { return t.tile.repeats.x * t.tile.repeats.y; };
    for (const PlacedTexture& texture : textures) {
        if (fit_together(texture, largest) && repeats(texture) < repeats(largest)) {
            largest = texture;
        }
    }
    return largest;
}

}  // namespace carom::pipeline
