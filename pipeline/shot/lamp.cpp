#include "pipeline/shot/lamp.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "core/perpendicular.h"

namespace carom::pipeline {

namespace {

constexpr double kSheet = 0.002;        // m, of a shade
constexpr double kRise = 0.001;         // m, of its rim behind the opening
constexpr std::uint32_t kSides = 64;    // of a shade
constexpr int kRings = 12;              // of a shade with a bulge
constexpr double kFrame = 0.012;        // m, of a housing around its light
constexpr double kHousingDepth = 0.04;  // m
constexpr double kInset = 0.001;        // m, of a housing behind its light

/// Axes x, y and z at right angles with z along the unit `axis`, and their origin.
Mat44 placed_along(const Vec3& axis, const Vec3& x, const Vec3& origin) {
    const Vec3 y = axis.cross(x);
    return {x.x,    x.y,    x.z,    0, y.x,      y.y,      y.z,      0,
            axis.x, axis.y, axis.z, 0, origin.x, origin.y, origin.z, 1};
}

/// A circle around z of a surface of revolution, and its normal there: outwards and along z.
struct Ring {
    double radius = 0;
    double height = 0;
    Vec2 normal{1, 0};
};

/// Adds the surface between two rings. Followed upwards, its front is outside.
void add_band(const Ring& low, const Ring& high, render::MeshShape& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t side = 0; side <= kSides; ++side) {
        const SinCos turn = sin_cos(2 * std::numbers::pi * side / kSides);
        for (const Ring& ring : {low, high}) {
            mesh.vertices.emplace_back(ring.radius * turn.cos, ring.radius * turn.sin, ring.height);
            mesh.normals.emplace_back(ring.normal.x * turn.cos, ring.normal.x * turn.sin,
                                      ring.normal.y);
        }
    }
    for (std::uint32_t side = 0; side < kSides; ++side) {
        const std::uint32_t at = first + 2 * side;
        if (low.radius > 0) {
            mesh.triangles.push_back({at, at + 2, at + 3});
        }
        if (high.radius > 0) {
            mesh.triangles.push_back({at, at + 3, at + 1});
        }
    }
}

Ring ring_of(const render::ShadeShape& shape, double height) {
    const Vec3 squares = shape.squares();
    const double radius = shape.radius_at(height);
    // The slope of the radius, from that of its square.
    const double slope = (squares.y + 2 * height * squares.z) / (2 * std::max(radius, 1e-6));
    const Vec2 normal = Vec2(1, -slope).normalized();
    return {radius + kSheet, height, normal};
}

/// Rises along z. Its rim is a little higher than the opening, at z = 0, so that shadow rays, which
/// end there, never come into its bounds.
render::MeshShape outside_of(const render::ShadeShape& shape) {
    render::MeshShape mesh;
    const Vec2 down(0, -1);
    const Vec2 up(0, 1);
    add_band({shape.radius, kRise, down}, {shape.radius + kSheet, kRise, down}, mesh);
    const int rings = shape.bulge > 0 ? kRings : 1;
    for (int i = 0; i < rings; ++i) {
        const auto ring = [&](int number) {
            return ring_of(shape, kRise + (shape.height - kRise) * number / rings);
        };
        add_band(ring(i), ring(i + 1), mesh);
    }
    add_band({ring_of(shape, shape.height).radius, shape.height, up}, {0, shape.height, up}, mesh);
    return mesh;
}

}  // namespace

Lamp lamp_in_shade(const render::ShadeLight& light, const std::string& material) {
    Lamp lamp;
    lamp.light = {"", light};
    const Vec3 up = -light.normal;
    lamp.parts.push_back({"/shade", outside_of(light.shape),
                          placed_along(up, perpendicular(up), light.centre), "", material});
    return lamp;
}

Lamp lamp_in_housing(const render::RectangleLight& light) {
    Lamp lamp;
    lamp.light = {"", light};
    const Vec3 up = -light.normal;
    const Vec3 size(2 * (light.edge_u.length() + kFrame), 2 * (light.edge_v.length() + kFrame),
                    kHousingDepth);
    lamp.parts.push_back({"/housing", render::BoxShape{size},
                          placed_along(up, light.edge_u.normalized(),
                                       light.centre + (kInset + kHousingDepth / 2) * up),
                          "", kHousingMaterial});
    return lamp;
}

double Tube::area() const {
    return 2 * std::numbers::pi * radius * (length + 2 * radius);
}

Lamp lamp_of_tube(const Tube& tube) {
    Lamp lamp;
    render::StandardMaterial light;
    light.base = Vec3(0, 0, 0);
    light.specular = 0;
    light.emission = tube.radiance;
    lamp.materials.push_back({"/tube", light});
    lamp.parts.push_back({"/tube", render::CapsuleShape{tube.radius, tube.length},
                          placed_along(tube.axis, perpendicular(tube.axis), tube.centre), "",
                          "/tube"});
    return lamp;
}

void name_parts(Lamp& lamp, const std::string& name) {
    if (lamp.light) {
        lamp.light->name = name;
    }
    for (render::MaterialDescription& material : lamp.materials) {
        material.name = name + material.name;
    }
    for (render::ObjectDescription& part : lamp.parts) {
        part.name = name + part.name;
        if (part.material.starts_with('/')) {
            part.material = name + part.material;
        }
    }
}

}  // namespace carom::pipeline
