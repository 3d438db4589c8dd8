// Measurements of triangle meshes for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/billiards/table.h"

namespace carom::sim::billiards::test {

struct NamedTable {
    const char* name;
    TableKind kind;
    const char* size;
    double ball_radius;
};

inline constexpr std::array<NamedTable, 5> kTables{
    {{"pool_9ft", TableKind::pool, "9 ft", 0.028575},
     {"pool_8ft", TableKind::pool, "8 ft", 0.028575},
     {"pool_7ft", TableKind::pool, "7 ft", 0.028575},
     {"snooker_12ft", TableKind::snooker, "12 ft", 0.02625},
     {"carom_10ft", TableKind::carom, "10 ft", 0.03075}}};

inline std::vector<const Surface*> parts(const std::vector<Surface>& surfaces, SurfacePart part) {
    std::vector<const Surface*> found;
    for (const Surface& surface : surfaces) {
        if (surface.part == part) {
            found.push_back(&surface);
        }
    }
    return found;
}

inline Vec3 corner(const Surface& surface, std::size_t triangle, int index) {
    return surface.vertices[surface.triangles[triangle][static_cast<std::size_t>(index)]];
}

inline Vec3 area_vector(const Surface& surface, std::size_t triangle) {
    const Vec3 a = corner(surface, triangle, 0);
    return 0.5 * (corner(surface, triangle, 1) - a).cross(corner(surface, triangle, 2) - a);
}

/// The enclosed volume of a closed surface; positive if its triangles face outwards.
inline double volume(const Surface& surface) {
    double sum = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        sum += corner(surface, t, 0).dot(corner(surface, t, 1).cross(corner(surface, t, 2))) / 6;
    }
    return sum;
}

/// Number of edges without exactly one partner in the opposite direction; vertices within 0.1 um
/// are merged.
inline int unmatched_edges(const Surface& surface) {
    std::map<std::array<long long, 3>, int> ids;
    std::vector<int> id_of;
    for (const Vec3& v : surface.vertices) {
        const std::array<long long, 3> cell{std::llround(v.x * 1e7), std::llround(v.y * 1e7),
                                            std::llround(v.z * 1e7)};
        id_of.push_back(ids.emplace(cell, static_cast<int>(ids.size())).first->second);
    }
    std::map<std::pair<int, int>, int> count;
    for (const auto& triangle : surface.triangles) {
        for (std::size_t side = 0; side < 3; ++side) {
            ++count[{id_of[triangle[side]], id_of[triangle[(side + 1) % 3]]}];
        }
    }
    int unmatched = 0;
    for (const auto& [edge, times] : count) {
        const auto back = count.find({edge.second, edge.first});
        if (times != 1 || back == count.end() || back->second != 1) {
            ++unmatched;
        }
    }
    return unmatched;
}

inline double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 edge = b - a;
    const double s = std::clamp((p - a).dot(edge) / edge.dot(edge), 0.0, 1.0);
    return (p - (a + s * edge)).length();
}

inline double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const auto is_inside = [&](const Vec3& from, const Vec3& to) {
        return (to - from).cross(p - from).dot(normal) >= 0;
    };
    if (is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) {
        return std::abs((p - a).dot(normal));
    }
    return std::min(
        {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

inline double distance_to_surface(const Vec3& p, const Surface& surface) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        nearest =
            std::min(nearest, distance_to_triangle(p, corner(surface, t, 0), corner(surface, t, 1),
                                                   corner(surface, t, 2)));
    }
    return nearest;
}

/// The first hit of a vertical ray from far above.
struct Landing {
    const Surface* surface = nullptr;
    double z = 0;
};

inline std::optional<Landing> drop_at(const std::vector<Surface>& surfaces, const Vec2& place) {
    std::optional<Landing> highest;
    const auto side = [](const Vec3& a, const Vec3& b, const Vec2& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    for (const Surface& surface : surfaces) {
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            const Vec3 a = corner(surface, t, 0);
            const Vec3 b = corner(surface, t, 1);
            const Vec3 c = corner(surface, t, 2);
            const double wa = side(b, c, place);
            const double wb = side(c, a, place);
            const double wc = side(a, b, place);
            const double sum = wa + wb + wc;
            if (sum == 0 || wa * sum < 0 || wb * sum < 0 || wc * sum < 0) {
                continue;
            }
            const double z = (wa * a.z + wb * b.z + wc * c.z) / sum;
            if (!highest || z > highest->z) {
                highest = Landing{&surface, z};
            }
        }
    }
    return highest;
}

}  // namespace carom::sim::billiards::test
