// A ball's paint as fields of one colour.
#pragma once

#include <string>
#include <vector>

#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// A unit sphere whose triangles end where the colours do: those of the first field come first.
struct PaintedSphere {
    struct Field {
        std::string name;  // "", "white", "spots"
        Vec3 colour;
        std::size_t triangles = 0;
    };
    render::MeshShape mesh;
    std::vector<Field> fields;  // none is empty
};

/// Stripes, the number's disc and spots where the renderer paints them; figures are left out.
[[nodiscard]] PaintedSphere painted_sphere(const render::BallTexture& paint);

}  // namespace carom::pipeline
