#include "pipeline/export/textures/texture_group.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"

namespace carom::pipeline {

namespace {

constexpr int kCheckerPixels = 64;  // of one repeat, two squares
constexpr int kPatchPixels = 512;   // of the part of a pattern that does not repeat

bool can_be_read(const std::vector<PlacedTexture>& textures, PictureStore& pictures) {
    try {
        for (const PlacedTexture& texture : textures) {
            if (texture.image != nullptr) {
                static_cast<void>(pictures.facts(texture.image->file));
            }
        }
    } catch (const Error&) {
        if (!pictures.limits().skips_unreadable) {
            throw;
        }
        return false;
    }
    return true;
}

}  // namespace

std::optional<TextureGroup> texture_group(std::vector<PlacedTexture> textures,
                                          const std::vector<TexturePlace>& places,
                                          PictureStore& pictures) {
    const std::optional<PlacedTexture> shared = shared_texture(textures);
    if (!shared) {
        return std::nullopt;
    }
    const auto place = std::ranges::find(places, shared->place);
    if (place == places.end() || !can_be_read(textures, pictures)) {
        return std::nullopt;
    }
    std::erase_if(textures, [&](const PlacedTexture& one) { return !fit_together(one, *shared); });
    return TextureGroup{std::move(textures), *shared,
                        static_cast<std::size_t>(place - places.begin())};
}

BakedGrid baked_grid(const TextureGroup& group, PictureStore& pictures) {
    BakedGrid grid{1, 1, group.shared.tile};
    const double most = std::min(pictures.limits().most_side, PictureStore::kAnySide);
    for (const PlacedTexture& texture : group.textures) {
        const Vec2 times = texture.tile.repeats / group.shared.tile.repeats;
        Vec2 size(texture.repeats ? kCheckerPixels : kPatchPixels);
        if (texture.image != nullptr) {
            const auto picture = pictures.picture(texture.image->file);
            size = Vec2(picture->width, picture->height);
        }
        const auto pixels = [&](double side) {
            return static_cast<int>(std::min(most, std::round(side)));
        };
        grid.width = std::max(grid.width, pixels(size.x * times.x));
        grid.height = std::max(grid.height, pixels(size.y * times.y));
    }
    return grid;
}

PictureFormat made_format(const TextureGroup& group, PictureStore& pictures) {
    const bool has_to_be_small = pictures.limits().most_side < PictureStore::kAnySide;
    const bool is_of_jpegs = std::ranges::all_of(group.textures, [&](const PlacedTexture& texture) {
        return texture.image != nullptr &&
               pictures.facts(texture.image->file).format == PictureFormat::jpeg;
    });
    return has_to_be_small && is_of_jpegs ? PictureFormat::jpeg : PictureFormat::png;
}

}  // namespace carom::pipeline
