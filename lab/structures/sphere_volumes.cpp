#include "lab/structures/sphere_volumes.h"

#include <cmath>

#include "lab/structures/slab_volumes.h"

namespace carom::render {
namespace {

using Volume = SphereVolumes::Volume;

/// With a margin for the rounding of the test below, whose terms are of the size of the centre.
Volume widened(const V3f& centre, float radius) {
    const float far = std::abs(centre.x) + std::abs(centre.y) + std::abs(centre.z) + radius;
    return {centre, radius + volume_margin(far)};
}

/// The middle of the longest side of an obtuse triangle, the centre of the circle through the
/// corners of another: so the sphere is the least one (Ericson 2005, "Real-time collision
/// detection", section 4.3).
V3f middle_of_triangle(const V3f& a, const V3f& to_b, const V3f& to_c) {
    const float bb = to_b.length2();
    const float cc = to_c.length2();
    const float bc = to_b.dot(to_c);
    const float area = bb * cc - bc * bc;  // twice the triangle's, squared
    if (bc <= 0 || !(area > 0)) {
        return a + 0.5f * (to_b + to_c);
    }
    if (bc >= bb) {
        return a + 0.5f * to_c;
    }
    if (bc >= cc) {
        return a + 0.5f * to_b;
    }
    const float s = 0.5f * cc * (bb - bc) / area;
    const float t = 0.5f * bb * (cc - bc) / area;
    return a + s * to_b + t * to_c;
}

Volume around_both(const Volume& a, const Volume& b) {
    const V3f between = b.centre - a.centre;
    const float distance = between.length();
    if (distance + b.radius <= a.radius) {
        return a;
    }
    if (distance + a.radius <= b.radius) {
        return b;
    }
    const float radius = 0.5f * (distance + a.radius + b.radius);
    return widened(a.centre + between * ((radius - a.radius) / distance), radius);
}

}  // namespace

Volume SphereVolumes::around(const Outlines& outlines, std::uint32_t shape) {
    const Outline& outline = outlines[shape];
    const V3f centre = outline.form == Outline::Form::triangle
                           ? middle_of_triangle(outline.centre, outline.half[0], outline.half[1])
                           : outline.centre;
    return widened(centre, outlines.reach(shape, centre));
}

Volume SphereVolumes::around(const Outlines& outlines, std::span<const std::uint32_t> shapes,
                             const Volume& left, const Volume& right) {
    Imath::Box3f box;
    for (const std::uint32_t shape : shapes) {
        box.extendBy(outlines.box(shape));
    }
    float reach = 0;
    for (const std::uint32_t shape : shapes) {
        reach = std::max(reach, outlines.reach(shape, box.center()));
    }
    const Volume fresh = widened(box.center(), reach);
    const Volume joined = around_both(left, right);
    return fresh.radius < joined.radius ? fresh : joined;
}

SphereVolumes::Probe::Probe(const Ray& ray)
    : origin_(ray.origin), direction_(ray.direction), t_min_(ray.t_min), margin_(ray_margin(ray)) {}

/// The distance from the centre to the line is that between the centre and the line's nearest
/// point, which loses fewer digits than a difference of squares (Haines et al. 2019, "Precision
/// improvements for ray/sphere intersection", Ray Tracing Gems, chapter 7).
bool SphereVolumes::Probe::enters(const Volume& volume, float t_max, float& enter) const {
    const V3f to_centre = volume.centre - origin_;
    const float middle = to_centre.dot(direction_);
    const V3f apart = to_centre - middle * direction_;
    const float radius = volume.radius + margin_;
    const float inside = radius * radius - apart.length2();
    if (!(inside >= 0)) {
        return false;
    }
    const float half = std::sqrt(inside);
    // The margin also covers the rounding of the sum.
    enter = std::max(t_min_, middle - half - margin_);
    return enter <= std::min(t_max, middle + half + margin_);
}

}  // namespace carom::render
