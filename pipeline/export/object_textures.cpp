#include "pipeline/export/object_textures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/export/textures/texture_coordinates.h"
#include "pipeline/export/textures/uv_lengths.h"
#include "render/geometry/affine.h"

namespace carom::pipeline {

namespace {

using render::Mapping;

/// Three digits, so that objects that are almost the same can share a picture.
double rounded(double length) {
    const double unit = std::pow(10, std::floor(std::log10(length)) - 2);
    return std::round(length / unit) * unit;
}

/// Over which coordinates of the relief grow by 1, m.
Vec2 relief_lengths(const ExportPart& part, const MaterialTextures& textures) {
    const auto* height = std::get_if<render::HeightTexture>(&textures.surface->relief);
    std::vector<PlacedTexture> reliefs;
    if (height != nullptr) {
        add_textures(textures.surface->relief, reliefs);
    }
    const auto shared = shared_texture(reliefs);
    const auto place =
        shared ? std::ranges::find(textures.places, shared->place) : textures.places.end();
    const bool is_in_metres = place == textures.places.end() || place->by_length ||
                              place->mapping == Mapping::planar || place->mapping == Mapping::box;
    if (is_in_metres) {
        return {1, 1};
    }
    const auto index = static_cast<std::size_t>(place - textures.places.begin());
    const Vec2 mean = mean_lengths(part.mesh, part.coordinates[index]);
    return {rounded(mean.x), rounded(mean.y)};
}

}  // namespace

MaterialTextures lay_textures(ExportPart& part, MaterialTextures textures,
                              const render::ObjectDescription& object,
                              const Mat44& object_from_mesh, bool keeps_uv) {
    std::vector<TexturePlace> places = textures.places;
    if (!textures.surface && keeps_uv && !part.mesh.uv.empty()) {
        places = {TexturePlace{}};
    }
    if (std::holds_alternative<render::SphereShape>(object.shape) && part.mesh.uv.empty()) {
        for (TexturePlace& place : places) {  // a painted ball; its uv are longitude and latitude
            place.mapping = place.mapping == Mapping::uv ? Mapping::spherical : place.mapping;
        }
    }
    if (!places.empty()) {
        Mat44 metres_from_object;
        metres_from_object.setScale(render::axis_scales(object.world_from_object));
        part.coordinates = texture_coordinates(
            part.mesh, places, {object.shape, object_from_mesh, metres_from_object});
    }
    part.mesh.uv.clear();
    if (textures.surface) {
        textures.relief_lengths = relief_lengths(part, textures);
    }
    return textures;
}

}  // namespace carom::pipeline
