#include "sim/shape/convex_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/length.h"

namespace carom::sim {
namespace {

/// Depth of a core below the surface (m), and its limit as a fraction of the solid's size.
constexpr double kSkin = 1e-3;
constexpr double kMaxSkinFraction = 0.05;
/// A cylinder's cap, not its side, faces directions with at least this cosine to the axis.
constexpr double kCapFacingCosine = 0.7;

double sign(double x) {
    return x < 0 ? -1 : 1;
}

/// Unit horizontal part of `v`; an arbitrary horizontal direction if `v` has none.
Vec3 level_direction(const Vec3& v) {
    const double r = std::sqrt(v.x * v.x + v.y * v.y);
    return r > 1e-12 * length(v) ? Vec3(v.x / r, v.y / r, 0) : Vec3(1, 0, 0);
}

Polyhedron box_solid(const Vec3& h) {
    Polyhedron box;
    for (int i = 0; i < 8; ++i) {
        box.vertices.emplace_back((i & 1) != 0 ? h.x : -h.x, (i & 2) != 0 ? h.y : -h.y,
                                  (i & 4) != 0 ? h.z : -h.z);
    }
    box.faces = {{{0, 4, 6, 2}, {-1, 0, 0}}, {{1, 3, 7, 5}, {1, 0, 0}},  {{0, 1, 5, 4}, {0, -1, 0}},
                 {{2, 6, 7, 3}, {0, 1, 0}},  {{0, 2, 3, 1}, {0, 0, -1}}, {{4, 5, 7, 6}, {0, 0, 1}}};
    return box;
}

/// The sixteen corners of a regular polygon on the unit circle, which is accurate enough for a
/// cap's outline and gives the same values on every platform.
const std::array<Vec2, 16>& circle() {
    static const std::array<Vec2, 16> corners = [] {
        const double a = std::sqrt(0.5);
        const double b = std::sqrt(0.5 + 0.25 * std::sqrt(2.0));  // cos 22.5 degrees
        const double c = std::sqrt(0.5 - 0.25 * std::sqrt(2.0));
        const std::array<Vec2, 4> quarter{Vec2(1, 0), Vec2(b, c), Vec2(a, a), Vec2(c, b)};
        std::array<Vec2, 16> all;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec2& q = quarter[i];
            all[i] = q;
            all[i + 4] = {-q.y, q.x};
            all[i + 8] = {-q.x, -q.y};
            all[i + 12] = {q.y, -q.x};
        }
        return all;
    }();
    return corners;
}

}  // namespace

ConvexShape ConvexShape::box(const Vec3& half_size) {
    ConvexShape shape(Kind::box);
    shape.half_size_ = half_size;
    shape.solid_ = box_solid(half_size);
    shape.bounding_radius_ = length(half_size);
    const double least = std::min({half_size.x, half_size.y, half_size.z});
    shape.core_skin_ = std::min(kSkin, kMaxSkinFraction * least);
    return shape;
}

ConvexShape ConvexShape::capsule(double radius, double half_length) {
    ConvexShape shape(Kind::capsule);
    shape.radius_ = radius;
    shape.half_size_.z = half_length;
    shape.bounding_radius_ = radius + half_length;
    return shape;
}

ConvexShape ConvexShape::cylinder(double radius, double half_height) {
    ConvexShape shape(Kind::cylinder);
    shape.radius_ = radius;
    shape.half_size_.z = half_height;
    shape.bounding_radius_ = std::sqrt(radius * radius + half_height * half_height);
    shape.core_skin_ = std::min(kSkin, kMaxSkinFraction * std::min(radius, half_height));
    return shape;
}

ConvexShape ConvexShape::hull(Polyhedron solid) {
    ConvexShape shape(Kind::hull);
    double nearest_side = 1e300;
    for (const PolyhedronFace& face : solid.faces) {
        nearest_side =
            std::min(nearest_side, face.normal.dot(solid.vertices[face.corners.front()]));
    }
    for (const Vec3& v : solid.vertices) {
        shape.bounding_radius_ = std::max(shape.bounding_radius_, length(v));
    }
    if (nearest_side > 0) {
        shape.core_skin_ = std::min(kSkin, kMaxSkinFraction * nearest_side);
        shape.core_shrinkage_ = shape.core_skin_ / nearest_side;
    }
    shape.solid_ = std::move(solid);
    return shape;
}

Vec3 ConvexShape::support(const Vec3& d) const {
    switch (kind_) {
        case Kind::box:
            return {sign(d.x) * half_size_.x, sign(d.y) * half_size_.y, sign(d.z) * half_size_.z};
        case Kind::capsule:
            return Vec3(0, 0, sign(d.z) * half_size_.z) + d * (radius_ / length(d));
        case Kind::cylinder:
            return level_direction(d) * radius_ + Vec3(0, 0, sign(d.z) * half_size_.z);
        case Kind::hull:
            break;
    }
    const Vec3* best = &solid_.vertices.front();
    double most = best->dot(d);
    for (const Vec3& v : solid_.vertices) {
        const double height = v.dot(d);
        if (height > most) {
            most = height;
            best = &v;
        }
    }
    return *best;
}

Vec3 ConvexShape::core_support(const Vec3& d, double depth) const {
    switch (kind_) {
        case Kind::box: {
            const Vec3 h = half_size_ - Vec3(depth * core_skin_);
            return {sign(d.x) * h.x, sign(d.y) * h.y, sign(d.z) * h.z};
        }
        case Kind::capsule:
            return {0, 0, sign(d.z) * half_size_.z};
        case Kind::cylinder:
            return level_direction(d) * (radius_ - depth * core_skin_) +
                   Vec3(0, 0, sign(d.z) * (half_size_.z - depth * core_skin_));
        case Kind::hull:
            break;
    }
    return support(d) * (1 - depth * core_shrinkage_);
}

const PolyhedronFace& ConvexShape::facing_side(const Vec3& d) const {
    const PolyhedronFace* best = &solid_.faces.front();
    for (const PolyhedronFace& face : solid_.faces) {
        if (face.normal.dot(d) > best->normal.dot(d)) {
            best = &face;
        }
    }
    return *best;
}

/// A cap as a polygon, beginning with the corner farthest along `direction`.
FacingFeature ConvexShape::cap_polygon(const Vec3& direction) const {
    const Vec3 u = level_direction(direction);
    const double up = sign(direction.z);
    FacingFeature feature;
    feature.normal = {0, 0, up};
    for (const Vec2& c : circle()) {
        // Counter-clockwise seen from outside, so the order is reversed on the lower cap.
        const double s = c.y * up;
        feature.points.emplace_back(radius_ * (u.x * c.x - u.y * s),
                                    radius_ * (u.y * c.x + u.x * s), up * half_size_.z);
    }
    return feature;
}

FacingFeature ConvexShape::facing(const Vec3& direction) const {
    const Vec3 d = direction / length(direction);
    FacingFeature feature;
    if (kind_ == Kind::capsule) {
        if (half_size_.z == 0) {  // a ball
            feature.points = {d * radius_};
            return feature;
        }
        feature.points = {Vec3(0, 0, -half_size_.z) + d * radius_,
                          Vec3(0, 0, half_size_.z) + d * radius_};
        return feature;
    }
    if (kind_ == Kind::cylinder) {
        if (std::abs(d.z) > kCapFacingCosine) {
            return cap_polygon(d);
        }
        const Vec3 side = level_direction(d) * radius_;
        feature.points = {side - Vec3(0, 0, half_size_.z), side + Vec3(0, 0, half_size_.z)};
        return feature;
    }
    const PolyhedronFace& face = facing_side(d);
    feature.normal = face.normal;
    for (const std::uint32_t corner : face.corners) {
        feature.points.push_back(solid_.vertices[corner]);
    }
    return feature;
}

std::optional<Vec3> ConvexShape::facing_normal(const Vec3& direction) const {
    if (kind_ == Kind::capsule) {
        return std::nullopt;
    }
    if (kind_ == Kind::cylinder) {
        return Vec3(0, 0, sign(direction.z));
    }
    return facing_side(direction).normal;
}

void ConvexShape::resting_points(const Vec3& down, std::vector<Vec3>& points) const {
    if (kind_ == Kind::box || kind_ == Kind::hull) {
        points = solid_.vertices;
        return;
    }
    points.clear();
    if (kind_ == Kind::capsule) {
        for (const double end : {-1.0, 1.0}) {
            points.push_back(Vec3(0, 0, end * half_size_.z) + down * radius_);
        }
        return;
    }
    const Vec3 u = level_direction(down) * radius_;
    for (const double end : {-1.0, 1.0}) {
        for (const Vec2& c : circle()) {
            points.emplace_back(u.x * c.x - u.y * c.y, u.y * c.x + u.x * c.y, end * half_size_.z);
        }
    }
}

}  // namespace carom::sim
