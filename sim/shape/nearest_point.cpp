#include <algorithm>
#include <cmath>

#include "core/length.h"
#include "sim/shape/convex_shape.h"

namespace carom::sim {
namespace {

NearestPoint from_outside(const Vec3& point, const Vec3& on_solid) {
    const Vec3 d = point - on_solid;
    const double distance = length(d);
    return {on_solid, d / distance, distance};
}

NearestPoint nearest_on_capsule(const ConvexShape& shape, const Vec3& p) {
    const Vec3 axis_point(0, 0, std::clamp(p.z, -shape.half_length(), shape.half_length()));
    const Vec3 d = p - axis_point;
    const double distance = length(d);
    const Vec3 normal = distance > 1e-12 ? d / distance : Vec3(1, 0, 0);
    return {axis_point + normal * shape.radius(), normal, distance - shape.radius()};
}

NearestPoint nearest_on_cylinder(const ConvexShape& shape, const Vec3& p) {
    const double r = std::sqrt(p.x * p.x + p.y * p.y);
    const Vec3 outwards = r > 1e-12 ? Vec3(p.x / r, p.y / r, 0) : Vec3(1, 0, 0);
    const double beside = r - shape.radius();
    const double above = std::abs(p.z) - shape.half_length();
    const double up = p.z < 0 ? -1 : 1;
    if (beside <= 0 && above <= 0) {
        if (beside > above) {
            return {outwards * shape.radius() + Vec3(0, 0, p.z), outwards, beside};
        }
        return {Vec3(p.x, p.y, up * shape.half_length()), Vec3(0, 0, up), above};
    }
    const double on_radius = std::min(r, shape.radius());
    const double on_height = std::min(std::abs(p.z), shape.half_length());
    return from_outside(p, outwards * on_radius + Vec3(0, 0, up * on_height));
}

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
    const Vec3 along = b - a;
    const double t = std::clamp((p - a).dot(along) / along.dot(along), 0.0, 1.0);
    return a + along * t;
}

Vec3 nearest_on_face(const Polyhedron& solid, const PolyhedronFace& face, const Vec3& p) {
    const std::size_t count = face.corners.size();
    bool is_above = true;
    Vec3 best = solid.vertices[face.corners.front()];
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3& a = solid.vertices[face.corners[i]];
        const Vec3& b = solid.vertices[face.corners[(i + 1) % count]];
        if (face.normal.cross(b - a).dot(p - a) >= 0) {
            continue;
        }
        is_above = false;
        const Vec3 candidate = nearest_on_segment(a, b, p);
        if (length(p - candidate) < length(p - best)) {
            best = candidate;
        }
    }
    return is_above ? p - face.normal * face.normal.dot(p - best) : best;
}

NearestPoint nearest_on_solid(const Polyhedron& solid, const Vec3& p) {
    const auto height_over = [&](const PolyhedronFace& face) {
        return face.normal.dot(p - solid.vertices[face.corners.front()]);
    };
    const PolyhedronFace* highest = &solid.faces.front();
    double height = height_over(*highest);
    for (const PolyhedronFace& face : solid.faces) {
        if (height_over(face) > height) {
            height = height_over(face);
            highest = &face;
        }
    }
    if (height <= 1e-12) {
        return {p - highest->normal * height, highest->normal, height};
    }
    Vec3 best = nearest_on_face(solid, *highest, p);
    for (const PolyhedronFace& face : solid.faces) {
        if (height_over(face) <= 0) {
            continue;
        }
        const Vec3 candidate = nearest_on_face(solid, face, p);
        if (length(p - candidate) < length(p - best)) {
            best = candidate;
        }
    }
    return from_outside(p, best);
}

/// For a point inside, the nearest point lies on the nearest side.
NearestPoint nearest_on_box(const Vec3& half_size, const Vec3& p) {
    Vec3 on_box = p;
    for (int axis = 0; axis < 3; ++axis) {
        on_box[axis] = std::clamp(p[axis], -half_size[axis], half_size[axis]);
    }
    const Vec3 d = p - on_box;
    const double distance = length(d);
    if (distance >= 1e-12) {
        return {on_box, d / distance, distance};
    }
    int side = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (half_size[axis] - std::abs(p[axis]) < half_size[side] - std::abs(p[side])) {
            side = axis;
        }
    }
    Vec3 normal(0, 0, 0);
    normal[side] = p[side] >= 0 ? 1 : -1;
    Vec3 point = p;
    point[side] = normal[side] * half_size[side];
    return {point, normal, std::abs(p[side]) - half_size[side]};
}

}  // namespace

NearestPoint nearest_point(const ConvexShape& shape, const Vec3& point) {
    switch (shape.kind()) {
        case ConvexShape::Kind::box:
            return nearest_on_box(shape.half_size(), point);
        case ConvexShape::Kind::capsule:
            return nearest_on_capsule(shape, point);
        case ConvexShape::Kind::cylinder:
            return nearest_on_cylinder(shape, point);
        case ConvexShape::Kind::hull:
            break;
    }
    return nearest_on_solid(shape.solid(), point);
}

}  // namespace carom::sim
