// Intersection of one ray with one shape in scalar code, for moving objects in their own axes and
// as the reference for the vectorised kernels. T is float or double.
//
// Every function returns distances in (t_min, t_max) along a direction of any length except zero,
// in units of that length.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/geometry/ray.h"
#include "render/geometry/scalar_kernels.h"

namespace carom::render {

template <class T>
using V3 = Imath::Vec3<T>;

/// A segment of a ray, in any axes.
template <class T>
struct RaySegment {
    V3<T> origin;
    V3<T> direction;
    T t_min = 0;
    T t_max = std::numeric_limits<T>::infinity();

    [[nodiscard]] bool contains(T t) const { return t > t_min && t < t_max; }
};

using UnitRay = RaySegment<float>;

/// The nearer of two distances (near <= far) that is on the segment.
template <class T>
[[nodiscard]] std::optional<T> first_on_segment(const RaySegment<T>& ray, T near, T far) {
    if (ray.contains(near)) {
        return near;
    }
    if (ray.contains(far)) {
        return far;
    }
    return std::nullopt;
}

/// Sphere around the origin, from outside or inside. The discriminant is computed from the distance
/// between centre and line, which is accurate far away (Haines, Günther and Akenine-Möller 2019,
/// "Precision improvements for ray/sphere intersection", Ray Tracing Gems, section 7.3).
template <class T>
[[nodiscard]] std::optional<T> intersect_sphere(const RaySegment<T>& ray, T radius) {
    const T a = ray.direction.dot(ray.direction);
    const T b = -ray.origin.dot(ray.direction) / a;  // distance of the closest approach
    const V3<T> closest = ray.origin + b * ray.direction;
    const T discriminant = radius * radius - closest.dot(closest);
    if (!(discriminant >= 0)) {
        return std::nullopt;
    }
    const T half_chord = std::sqrt(discriminant / a);
    return first_on_segment(ray, b - half_chord, b + half_chord);
}

/// 1 / x, with a huge finite value of the same sign in place of infinity: its product with zero is
/// zero instead of NaN.
template <class T>
[[nodiscard]] T finite_reciprocal(T x) {
    constexpr T kTiny = T(1e-30);
    return T(1) / (std::abs(x) < kTiny ? std::copysign(kTiny, x) : x);
}

/// Where a ray enters and leaves an axis-aligned box, and through which faces. Faces 0 to 5 are -x,
/// +x, -y, +y, -z, +z.
template <class T>
struct BoxCrossing {
    T enter, leave;
    int enter_face, leave_face;
};

/// The slab test of Kay and Kajiya 1986; empty if the line misses the box.
template <class T>
[[nodiscard]] std::optional<BoxCrossing<T>> cross_box(const V3<T>& origin,
                                                      const V3<T>& inverse_direction,
                                                      const V3<T>& low, const V3<T>& high) {
    constexpr T kHuge = std::numeric_limits<T>::max();
    BoxCrossing<T> crossing{-kHuge, kHuge, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
        T near = (low[axis] - origin[axis]) * inverse_direction[axis];
        T far = (high[axis] - origin[axis]) * inverse_direction[axis];
        const bool backwards = inverse_direction[axis] < 0;
        if (backwards) {
            std::swap(near, far);
        }
        if (near > crossing.enter) {
            crossing.enter = near;
            crossing.enter_face = 2 * axis + (backwards ? 1 : 0);
        }
        if (far < crossing.leave) {
            crossing.leave = far;
            crossing.leave_face = 2 * axis + (backwards ? 0 : 1);
        }
    }
    if (crossing.enter > crossing.leave) {
        return std::nullopt;
    }
    return crossing;
}

struct BoxHit {
    float t;
    int face;
};

/// The first face hit; from inside, the face through which the ray leaves.
[[nodiscard]] inline std::optional<BoxHit> intersect_box(const RaySegment<float>& ray,
                                                         const V3f& low, const V3f& high) {
    const V3f inverse(finite_reciprocal(ray.direction.x), finite_reciprocal(ray.direction.y),
                      finite_reciprocal(ray.direction.z));
    const auto crossing = cross_box(ray.origin, inverse, low, high);
    if (!crossing) {
        return std::nullopt;
    }
    if (ray.contains(crossing->enter)) {
        return BoxHit{crossing->enter, crossing->enter_face};
    }
    if (ray.contains(crossing->leave)) {
        return BoxHit{crossing->leave, crossing->leave_face};
    }
    return std::nullopt;
}

/// The plane z = 0; a ray within the plane misses it.
template <class T>
[[nodiscard]] std::optional<T> intersect_plane(const RaySegment<T>& ray) {
    if (ray.direction.z == 0) {
        return std::nullopt;
    }
    const T t = -ray.origin.z / ray.direction.z;
    return ray.contains(t) ? std::optional<T>(t) : std::nullopt;
}

/// |x| <= half_size.x, |y| <= half_size.y on the plane z = 0.
template <class T>
[[nodiscard]] std::optional<T> intersect_rectangle(const RaySegment<T>& ray,
                                                   const Imath::Vec2<T>& half_size) {
    const std::optional<T> t = intersect_plane(ray);
    if (!t) {
        return std::nullopt;
    }
    const T x = ray.origin.x + *t * ray.direction.x;
    const T y = ray.origin.y + *t * ray.direction.y;
    const bool inside = std::abs(x) <= half_size.x && std::abs(y) <= half_size.y;
    return inside ? t : std::nullopt;
}

/// x, y >= 0 and x + y <= 1 on the plane z = 0. The edges are widened by a few roundings, so that
/// adjacent triangles leave no gap.
template <class T>
[[nodiscard]] std::optional<T> intersect_unit_triangle(const RaySegment<T>& ray) {
    const std::optional<T> t = intersect_plane(ray);
    if (!t) {
        return std::nullopt;
    }
    const T x = ray.origin.x + *t * ray.direction.x;
    const T y = ray.origin.y + *t * ray.direction.y;
    const T margin = T(kTriangleMargin);
    const bool inside = x >= -margin && y >= -margin && x + y <= 1 + margin;
    return inside ? t : std::nullopt;
}

/// x^2 + y^2 <= 1 on the plane z = 0.
template <class T>
[[nodiscard]] std::optional<T> intersect_unit_disk(const RaySegment<T>& ray) {
    const std::optional<T> t = intersect_plane(ray);
    if (!t) {
        return std::nullopt;
    }
    const T x = ray.origin.x + *t * ray.direction.x;
    const T y = ray.origin.y + *t * ray.direction.y;
    return x * x + y * y <= 1 ? t : std::nullopt;
}

template <class T>
[[nodiscard]] std::optional<T> intersect_frustum(const RaySegment<T>& ray, T middle, T slope) {
    const auto crossings = scalar::cross_frustum<ScalarLanes<T>>(
        {scalar::three(ray.origin), scalar::three(ray.direction)}, middle, slope);
    std::optional<T> nearest;
    for (int face = 0; face < 4; ++face) {
        const T t = crossings.t[face];
        if (crossings.valid[face] && ray.contains(t) && (!nearest || t < *nearest)) {
            nearest = t;
        }
    }
    return nearest;
}

template <class T>
struct TriangleHit {
    T t;
    T u, v;  // barycentric weights of the second and third corner
};

/// Watertight test (Woop, Benthin and Wald 2013, "Watertight ray/triangle intersection"): no ray
/// passes between two triangles with a common edge, because both compute the same edge function for
/// it.
template <class T>
[[nodiscard]] std::optional<TriangleHit<T>> intersect_triangle(const RaySegment<T>& ray,
                                                               const V3<T>& a, const V3<T>& b,
                                                               const V3<T>& c) {
    const V3<T>& d = ray.direction;
    const V3<T> size(std::abs(d.x), std::abs(d.y), std::abs(d.z));
    const int kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int kx = (kz + 1) % 3;
    const int ky = (kz + 2) % 3;
    const T shear_x = d[kx] / d[kz];
    const T shear_y = d[ky] / d[kz];
    struct Sheared {
        T x, y, z;
    };
    const auto shear = [&](const V3<T>& corner) {
        const V3<T> p = corner - ray.origin;
        return Sheared{p[kx] - shear_x * p[kz], p[ky] - shear_y * p[kz], p[kz] / d[kz]};
    };
    const Sheared pa = shear(a);
    const Sheared pb = shear(b);
    const Sheared pc = shear(c);
    // Twice the signed areas over the three edges. Products of floats are exact in double, so that
    // the sign is right even where float would round to zero.
    const auto edge = [](const Sheared& p, const Sheared& q) {
        return static_cast<double>(p.x) * static_cast<double>(q.y) -
               static_cast<double>(p.y) * static_cast<double>(q.x);
    };
    const double wa = edge(pc, pb);
    const double wb = edge(pa, pc);
    const double wc = edge(pb, pa);
    const bool any_negative = wa < 0 || wb < 0 || wc < 0;
    const bool any_positive = wa > 0 || wb > 0 || wc > 0;
    const double sum = wa + wb + wc;
    if ((any_negative && any_positive) || sum == 0) {
        return std::nullopt;
    }
    const T u = static_cast<T>(wb / sum);
    const T v = static_cast<T>(wc / sum);
    const T t = static_cast<T>(wa / sum) * pa.z + u * pb.z + v * pc.z;
    return ray.contains(t) ? std::optional(TriangleHit<T>{t, u, v}) : std::nullopt;
}

}  // namespace carom::render
