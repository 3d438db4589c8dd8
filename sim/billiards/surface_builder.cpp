#include "sim/billiards/surface_builder.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "core/elementary.h"

namespace carom::sim::billiards {

SurfaceBuilder::SurfaceBuilder(std::string name, SurfacePart part) {
    surface_.name = std::move(name);
    surface_.part = part;
}

std::uint32_t SurfaceBuilder::add(const SurfaceVertex& vertex) {
    surface_.vertices.push_back(vertex.position);
    surface_.normals.push_back(vertex.normal);
    surface_.uv.push_back(vertex.uv);
    return static_cast<std::uint32_t>(surface_.vertices.size() - 1);
}

void SurfaceBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vec3& p = surface_.vertices[a];
    const Vec3& q = surface_.vertices[b];
    const Vec3& r = surface_.vertices[c];
    if (p == q || q == r || r == p) {
        return;
    }
    const Vec3 outward = surface_.normals[a] + surface_.normals[b] + surface_.normals[c];
    if ((q - p).cross(r - p).dot(outward) < 0) {
        std::swap(b, c);
    }
    surface_.triangles.push_back({a, b, c});
}

void SurfaceBuilder::add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const auto& p = surface_.vertices;
    if ((p[a] - p[c]).length2() <= (p[b] - p[d]).length2()) {
        add_triangle(a, b, c);
        add_triangle(a, c, d);
    } else {
        add_triangle(a, b, d);
        add_triangle(b, c, d);
    }
}

void SurfaceBuilder::add_grid(std::span<const std::vector<SurfaceVertex>> rows) {
    const auto first = static_cast<std::uint32_t>(surface_.vertices.size());
    for (const auto& row : rows) {
        for (const SurfaceVertex& vertex : row) {
            add(vertex);
        }
    }
    const auto width = static_cast<std::uint32_t>(rows[0].size());
    for (std::uint32_t row = 0; row + 1 < rows.size(); ++row) {
        for (std::uint32_t column = 0; column + 1 < width; ++column) {
            const std::uint32_t corner = first + row * width + column;
            add_quad(corner, corner + 1, corner + width + 1, corner + width);
        }
    }
}

void SurfaceBuilder::sweep(const PlanPath& path, const Profile& profile) {
    std::vector<std::vector<SurfaceVertex>> rows;
    for (const ProfilePoint& point : profile) {
        rows.push_back(row_along(path, point));
    }
    add_grid(rows);
}

void SurfaceBuilder::add_level(std::span<const Loop> loops, double z, bool faces_up, double spacing,
                               const Vec2& grain) {
    const Vec2 across(-grain.y, grain.x);
    const Triangulation region = triangulate(loops, spacing);
    const auto first = static_cast<std::uint32_t>(surface_.vertices.size());
    for (const Vec2& point : region.points) {
        add({{point.x, point.y, z},
             {0, 0, faces_up ? 1.0 : -1.0},
             {point.dot(grain), point.dot(across)}});
    }
    for (const auto& [a, b, c] : region.triangles) {
        add_triangle(first + a, first + b, first + c);
    }
}

void SurfaceBuilder::add_polygon(std::span<const Vec3> corners, const Vec3& normal) {
    // Axes of the plane, one of them horizontal.
    const Vec3 up = std::abs(normal.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    const Vec3 along = up.cross(normal).normalized();
    const Vec3 across = normal.cross(along);
    Loop loop;
    std::vector<Vec3> kept;
    for (const Vec3& corner : corners) {
        if (kept.empty() || (corner != kept.back() && corner != kept.front())) {
            kept.push_back(corner);
            loop.emplace_back(corner.dot(along), corner.dot(across));
        }
    }
    const Triangulation region = triangulate(std::span(&loop, 1), HUGE_VAL);
    const auto first = static_cast<std::uint32_t>(surface_.vertices.size());
    for (std::size_t index = 0; index < kept.size(); ++index) {
        add({kept[index], normal, loop[index]});
    }
    for (const auto& [a, b, c] : region.triangles) {
        add_triangle(first + a, first + b, first + c);
    }
}

Surface SurfaceBuilder::finish() && {
    return std::move(surface_);
}

std::vector<SurfaceVertex> row_along(const PlanPath& path, const ProfilePoint& point,
                                     const AdjustVertex& adjust) {
    std::vector<SurfaceVertex> row;
    for (std::size_t index = 0; index < path.size(); ++index) {
        const PathPoint& place = path[index];
        const Vec2 position = place.inside(point.inside);
        const auto add = [&](const Vec2& normal) {
            const Vec3 in_space(normal.x * point.normal_open, normal.y * point.normal_open,
                                point.normal_up);
            row.push_back({{position.x, position.y, point.z},
                           in_space.normalized(),
                           {place.length, point.length}});
            if (adjust) {
                adjust(place, row.back());
            }
        };
        const bool is_end = index == 0 || index + 1 == path.size();
        const bool is_sharp = (place.normal_in - place.normal_out).length() > 1e-6;
        if (is_sharp && !is_end) {
            add(place.normal_in);
        }
        add(index + 1 == path.size() ? place.normal_in : place.normal_out);
    }
    return row;
}

Loop inside_outline(const PlanPath& path, double distance) {
    Loop outline;
    for (const PathPoint& point : path) {
        const Vec2 position = point.inside(distance);
        if (outline.empty() || (position != outline.back() && position != outline.front())) {
            outline.push_back(position);
        }
    }
    return outline;
}

Profile straight_profile(ProfilePosition from, ProfilePosition to) {
    const double across = to.inside - from.inside;
    const double rise = to.z - from.z;
    const double length = std::sqrt(across * across + rise * rise);
    const double open = -rise / length;
    const double up = -across / length;
    return {{from.inside, from.z, open, up, 0}, {to.inside, to.z, open, up, length}};
}

Profile round_profile(ProfilePosition wall, ProfilePosition level) {
    constexpr int kSteps = 8;
    const double across = level.inside - wall.inside;
    const double rise = level.z - wall.z;
    Profile profile;
    for (int step = 0; step <= kSteps; ++step) {
        const double angle = 0.5 * std::numbers::pi * step / kSteps;
        // The ends are exact, so that neighbours share their points bit for bit.
        const SinCos at = sin_cos(angle);
        const double sine = step == kSteps ? 1 : at.sin;
        const double cosine = step == kSteps ? 0 : at.cos;
        const double inside = step == kSteps ? level.inside : wall.inside + across * (1 - cosine);
        const double z = step == kSteps ? level.z : wall.z + rise * sine;
        // The gradient of (x/across)^2 + (y/rise)^2, for a wall whose open side faces it.
        const double open = cosine / across;
        const double up = sine / rise;
        const double size = std::sqrt(open * open + up * up);
        profile.push_back({inside, z, open / size, up / size, std::abs(rise) * angle});
    }
    return profile;
}

std::vector<Vec3> profile_at(const PathPoint& point, std::span<const Profile> profiles) {
    std::vector<Vec3> places;
    for (const Profile& profile : profiles) {
        for (const ProfilePoint& place : profile) {
            const Vec2 position = point.inside(place.inside);
            const Vec3 in_space(position.x, position.y, place.z);
            if (places.empty() || places.back() != in_space) {
                places.push_back(in_space);
            }
        }
    }
    return places;
}

}  // namespace carom::sim::billiards
