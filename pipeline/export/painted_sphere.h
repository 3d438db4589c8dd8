// Divides the surface of a painted ball into fields of one colour.
#pragma once

#include <string>
#include <vector>

#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// A unit sphere whose triangles end at the borders between colours. They are sorted by field.
struct PaintedSphere {
    struct Field {
        std::string name;  // "", "white", "spots"
        Vec3 colour;
        std::size_t triangles = 0;
    };
    render::MeshShape mesh;
    std::vector<Field> fields;  // none is empty
};

/// Stripes, the number's disc and spots are where the renderer paints them; digits are omitted.
[[nodiscard]] PaintedSphere painted_sphere(const render::BallTexture& paint);

}  // namespace carom::pipeline
