#include "render/geometry/polygon.h"

#include <cmath>
#include <cstddef>

#include "core/assert.h"

namespace carom::render {
namespace {

/// Newell's normal: twice the area vector, also for concave polygons.
Vec3 area_vector(std::span<const Vec3> corners) {
    Vec3 sum(0, 0, 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& a = corners[i];
        const Vec3& b = corners[(i + 1) % corners.size()];
        sum += (a - corners[0]).cross(b - corners[0]);
    }
    return sum;
}

std::vector<Vec2> flatten(std::span<const Vec3> corners) {
    const Vec3 n = area_vector(corners);
    // The projection drops the axis along which the polygon is thinnest and keeps the orientation.
    int drop = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(n[axis]) > std::abs(n[drop])) {
            drop = axis;
        }
    }
    const int x = (drop + 1) % 3;
    const int y = (drop + 2) % 3;
    const double sign = n[drop] < 0 ? -1 : 1;
    std::vector<Vec2> flat;
    flat.reserve(corners.size());
    for (const Vec3& corner : corners) {
        flat.emplace_back(sign * corner[x], corner[y]);
    }
    return flat;
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).cross(c - a);
}

bool contains(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

bool is_ear(const std::vector<Vec2>& points, const std::vector<std::uint32_t>& ring,
            std::size_t at) {
    const std::size_t n = ring.size();
    const Vec2& a = points[ring[(at + n - 1) % n]];
    const Vec2& b = points[ring[at]];
    const Vec2& c = points[ring[(at + 1) % n]];
    if (turn(a, b, c) <= 0) {
        return false;
    }
    for (std::size_t k = 2; k + 1 < n; ++k) {
        const Vec2& p = points[ring[(at + k) % n]];
        if (p != a && p != c && contains(a, b, c, p)) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners) {
    CAROM_ASSERT(corners.size() >= 3);
    const std::vector<Vec2> points = flatten(corners);
    std::vector<std::uint32_t> ring(corners.size());
    for (std::uint32_t i = 0; i < ring.size(); ++i) {
        ring[i] = i;
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(corners.size() - 2);
    std::size_t at = 0;
    std::size_t tried = 0;
    std::size_t n = ring.size();
    while (n > 3) {
        // If every corner is rejected, the polygon is degenerate and is clipped at the current
        // corner.
        if (!is_ear(points, ring, at) && ++tried <= n) {
            at = (at + 1) % n;
            continue;
        }
        tried = 0;
        triangles.push_back({ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
        n -= 1;
        at = at < n ? at : 0;
    }
    triangles.push_back({ring[0], ring[1], ring[2]});
    return triangles;
}

}  // namespace carom::render
