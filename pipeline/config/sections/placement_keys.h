// The keys that lay a texture on a surface.
#pragma once

#include <string>

#include "pipeline/config/map_spec.h"
#include "pipeline/config/value_types.h"
#include "render/scene/material_description.h"

namespace carom::pipeline::config {

/// `planar`, `box` ...; Mapping::own has no word, because it is what counts without one.
[[nodiscard]] ValueType<render::Mapping> mapping_word();

/// What excludes `facing` beside another mapping than `planar`.
[[nodiscard]] Exclusion only_planar();

/// Makes `facing` a unit vector; a zero vector is a problem.
void check_facing(Reader& reader, const Node& texture, render::Placement& placement);

/// Adds `mapping`, `facing` and `rotate` to the keys of a texture. `without`: what counts without a
/// mapping, "`uv`"; `centre`: about what it is rotated.
template <class T>
void add_placement_keys(MapSpec<T>& spec, const std::string& without, const std::string& centre) {
    spec.key(
        "mapping", [](T& texture) -> render::Mapping& { return texture.placement.mapping; },
        mapping_word(),
        "how it is laid on the surface: `uv` by the surface's texture coordinates; the others "
        "project it in the object's axes: `planar` along `facing`, `box` along the axis that the "
        "surface faces most, `spherical` around the object's origin. The default is " +
            without);
    spec.key(
            "facing", [](T& texture) -> Vec3& { return texture.placement.facing; },
            vector3(Dimension::none, between(-1e6, 1e6)),
            "with `planar`: the side from which it is upright and not mirrored, in the object's "
            "axes")
        .goes_with({"mapping"})
        .excluded_by(only_planar());
    spec.key(
        "rotate", [](T& texture) -> double& { return texture.placement.rotation; }, angle(),
        "rotation, counter-clockwise about " + centre);
    spec.check([](Reader& reader, const Node& node, T& texture) {
        check_facing(reader, node, texture.placement);
    });
}

}  // namespace carom::pipeline::config
