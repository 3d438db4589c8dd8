#include <algorithm>
#include <cmath>

#include "core/vectors.h"
#include "render/triangle/moller_trumbore.h"

namespace carom::render {
namespace {

/// The sides of the ray on which the edges are, by Plücker products (Jones 2000, "Intersecting a
/// ray and a triangle with Plücker coordinates", Ray Tracing News 13(1)): for the corners p and q
/// relative to the origin, d.((p + q) x (q - p)). Of two triangles with a common edge, one has
/// q - p where the other has p - q, so that the products are exactly opposite. Weights and distance
/// follow from them.
std::optional<TriangleHit> exact_hit(const Ray& ray, const V3f& a, const V3f& b, const V3f& c) {
    const Vec3 direction(ray.direction);
    const Vec3 origin(ray.origin);
    const auto product = [&](const V3f& from, const V3f& to) {
        const Vec3 p = Vec3(from) - origin;
        const Vec3 q = Vec3(to) - origin;
        return direction.dot((p + q).cross(Vec3(to) - Vec3(from)));
    };
    const double of_a = product(b, c);
    const double of_b = product(c, a);
    const double of_c = product(a, b);
    const auto [least, most] = std::minmax({of_a, of_b, of_c});
    const double sum = of_a + of_b + of_c;
    if ((least < 0 && most > 0) || sum == 0) {
        return std::nullopt;
    }
    const Vec3 normal = (Vec3(b) - Vec3(a)).cross(Vec3(c) - Vec3(a));
    const auto t = static_cast<float>(2 * normal.dot(Vec3(a) - origin) / sum);
    const TriangleHit hit{t, static_cast<float>(of_b / sum), static_cast<float>(of_c / sum), true};
    return t > ray.t_min && t < ray.t_max ? std::optional(hit) : std::nullopt;
}

}  // namespace

std::optional<TriangleHit> triangle_hit(const Ray& ray, const V3f& a, const V3f& b, const V3f& c) {
    using L = ScalarLanes<float>;
    const auto triangle = triangle::scalar::MollerTrumbore::prepare<L>({a, b, c});
    const auto size_of = triangle::scalar::sum_of_sizes<L>;
    const float edge = std::max(size_of(triangle.edge_b), size_of(triangle.edge_c));
    const float error =
        triangle::scalar::doubt<L>(size_of(ray.direction), edge, size_of(ray.origin - a));
    const auto [hit, is_doubtful] = triangle::scalar::sure_hit<L>(
        {ray.origin, ray.direction, ray.t_min, ray.t_max}, triangle, error);
    if (is_doubtful) {
        return exact_hit(ray, a, b, c);
    }
    return hit.valid ? std::optional(hit) : std::nullopt;
}

}  // namespace carom::render
