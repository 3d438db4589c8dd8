#include "render/geometry/specular_point.h"

#include <algorithm>
#include <cmath>

#include "core/elementary_float.h"
#include "render/geometry/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::One;
using scalar::sin_cos;
using SinCos = scalar::SinCosOf<One>;

constexpr int kMostSteps = 12;
constexpr float kTolerance = 1e-7f;  // rad

/// The angle of the solution between 0 and `between`, where the equation changes its sign once:
/// Newton's method, with bisection where a step leaves the bracket.
float mirror_angle(float between, float radius_over_a, float radius_over_b) {
    float low = 0;
    float high = between;
    float angle = between * (1 - radius_over_a) / (2 - radius_over_a - radius_over_b);
    for (int step = 0; step < kMostSteps; ++step) {
        const SinCos both = sin_cos<One>(2 * angle - between);
        const SinCos from_a = sin_cos<One>(angle);
        const SinCos from_b = sin_cos<One>(between - angle);
        const float value = both.sine - radius_over_b * from_a.sine + radius_over_a * from_b.sine;
        (value < 0 ? low : high) = angle;
        const float slope =
            2 * both.cosine - radius_over_b * from_a.cosine - radius_over_a * from_b.cosine;
        float next = angle - value / slope;
        if (!(next >= low && next <= high)) {
            next = 0.5f * (low + high);
        }
        const float change = std::abs(next - angle);
        angle = next;
        if (change < kTolerance) {
            break;
        }
    }
    return angle;
}

/// A unit vector perpendicular to the unit `axis`, towards `other`.
V3f across(const V3f& axis, const V3f& other) {
    const V3f side = other - axis * axis.dot(other);
    const float length2 = side.length2();
    return length2 > 1e-14f ? side / std::sqrt(length2) : scalar::basis_around<One>(axis).x;
}

}  // namespace

std::optional<SpecularPoint> specular_point(const V3f& a, const V3f& b, const V3f& centre,
                                            float radius) {
    const V3f to_a = a - centre;
    const V3f to_b = b - centre;
    const float distance_a = to_a.length();
    const float distance_b = to_b.length();
    if (distance_a <= radius || distance_b <= radius) {
        return std::nullopt;
    }
    const V3f axis = to_a / distance_a;
    const V3f other = to_b / distance_b;
    const V3f side = across(axis, other);
    const float between = arctangent2(side.dot(other), axis.dot(other));
    const float radius_over_a = radius / distance_a;
    const float radius_over_b = radius / distance_b;
    const float angle = mirror_angle(between, radius_over_a, radius_over_b);
    const SinCos from_a = sin_cos<One>(angle);
    if (from_a.cosine <= radius_over_a || sin_cos<One>(between - angle).cosine <= radius_over_b) {
        return std::nullopt;
    }
    SpecularPoint point;
    point.normal = axis * from_a.cosine + side * from_a.sine;
    point.position = centre + point.normal * radius;
    const V3f leg_a = a - point.position;
    const V3f leg_b = b - point.position;
    point.from = leg_a.length();
    point.to = leg_b.length();
    point.cosine = leg_a.dot(point.normal) / point.from;
    if (!(point.cosine > 0) || !(leg_b.dot(point.normal) > 0)) {
        return std::nullopt;
    }
    const float sum = point.from + point.to;
    const float product = 2 * point.from * point.to / radius;
    point.spread = 1 / ((sum + product / point.cosine) * (sum + product * point.cosine));
    return point;
}

}  // namespace carom::render
