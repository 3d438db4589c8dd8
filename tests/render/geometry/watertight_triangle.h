// A test of one ray with one triangle that other code is compared with.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/render/geometry/intersect.h"

namespace carom::render {

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
