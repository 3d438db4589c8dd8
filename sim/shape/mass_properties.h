// Volume, centre of mass and moments of inertia of solids of uniform density.
#pragma once

#include "core/vectors.h"
#include "sim/shape/polyhedron.h"

namespace carom::sim {

struct MassProperties {
    double volume = 0;      // m^3
    Vec3 centre{0, 0, 0};   // of mass
    Vec3 inertia{1, 1, 1};  // principal moments about the centre for a mass of 1 kg, m^2
    Quat principal{};       // turns the principal axes into the solid's own
};

/// Mirtich, Fast and accurate computation of polyhedral mass properties, J. Graphics Tools 1(2),
/// 1996, gives the integrals; here they are summed over tetrahedra from one point to all faces.
[[nodiscard]] MassProperties mass_properties(const Polyhedron& solid);

/// Moments for a mass of 1 kg about the centre; the axis is z.
[[nodiscard]] Vec3 box_inertia(const Vec3& size);
[[nodiscard]] Vec3 cylinder_inertia(double radius, double height);
/// `length`: between the centres of its round ends.
[[nodiscard]] Vec3 capsule_inertia(double radius, double length);

[[nodiscard]] double cylinder_volume(double radius, double height);
[[nodiscard]] double capsule_volume(double radius, double length);

}  // namespace carom::sim
