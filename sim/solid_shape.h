// The convex bodies of the world in the form that the simulation uses.
#pragma once

#include <memory>
#include <optional>

#include "sim/spatial/aabb_tree.h"
#include "sim/spatial/convex_distance.h"
#include "sim/world.h"

namespace carom::sim {

struct SolidShape {
    std::shared_ptr<const ConvexShape> shape;  // along its principal axes
    Quat principal{};                          // turns the principal axes into the body's own
    Vec3 inertia{1, 1, 1};                     // principal moments for a mass of 1 kg, m^2
};

/// Empty for spheres and meshes.
[[nodiscard]] std::optional<SolidShape> solid_shape(const BodyShape& shape);

[[nodiscard]] Aabb bounds_of(const PlacedShape& solid);

}  // namespace carom::sim
