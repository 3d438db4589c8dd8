#include "sim/shape/polyhedron.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/length.h"

namespace carom::sim {
namespace {

using Corners = std::array<std::uint32_t, 3>;

struct Facet {
    Corners corners{};
    Vec3 normal{0, 0, 1};
    double offset = 0;  // normal . x on the plane

    [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p) - offset; }
};

/// Incremental convex hull: each point that sees facets replaces them by a cone from itself to
/// their outline (Preparata and Hong, Convex hulls of finite sets of points in two and three
/// dimensions, Comm. ACM 20, 1977). Without conflict lists it is quadratic, which is fine for a few
/// hundred points.
class HullBuilder {
  public:
    explicit HullBuilder(std::span<const Vec3> points) : points_(points) {
        Vec3 low = points.front();
        Vec3 high = points.front();
        for (const Vec3& p : points) {
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], p[axis]);
                high[axis] = std::max(high[axis], p[axis]);
            }
        }
        extent_ = length(high - low);
    }

    /// False if the points lie in a plane.
    bool build() {
        const std::optional<std::array<std::uint32_t, 4>> first = tetrahedron();
        if (!first) {
            return false;
        }
        const auto [a, b, c, d] = *first;
        inside_ = (points_[a] + points_[b] + points_[c] + points_[d]) * 0.25;
        add({a, b, c});
        add({a, b, d});
        add({a, c, d});
        add({b, c, d});
        for (std::uint32_t i = 0; i < points_.size(); ++i) {
            include(i);
        }
        return true;
    }

    [[nodiscard]] Polyhedron merged() const;

  private:
    [[nodiscard]] std::optional<std::array<std::uint32_t, 4>> tetrahedron() const;
    void add(Corners corners);
    void include(std::uint32_t point);
    [[nodiscard]] double flatness() const { return 1e-9 * extent_; }

    std::span<const Vec3> points_;
    double extent_ = 0;
    Vec3 inside_{0, 0, 0};
    std::vector<Facet> facets_;
};

template <class Measure>
std::uint32_t largest(std::size_t count, Measure measure) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < count; ++i) {
        if (measure(i) > measure(best)) {
            best = i;
        }
    }
    return best;
}

std::optional<std::array<std::uint32_t, 4>> HullBuilder::tetrahedron() const {
    constexpr double kThinnest = 1e-6;
    const std::size_t n = points_.size();
    if (n < 4) {
        return std::nullopt;
    }
    const Vec3& p0 = points_[0];
    const std::uint32_t b = largest(n, [&](std::uint32_t i) { return length(points_[i] - p0); });
    const Vec3 along = points_[b] - p0;
    const auto off_line = [&](std::uint32_t i) { return length((points_[i] - p0).cross(along)); };
    const std::uint32_t c = largest(n, off_line);
    const Vec3 normal = along.cross(points_[c] - p0);
    const auto off_plane = [&](std::uint32_t i) { return std::abs(normal.dot(points_[i] - p0)); };
    const std::uint32_t d = largest(n, off_plane);
    if (!(off_line(c) > kThinnest * extent_ * length(along)) ||
        !(off_plane(d) > kThinnest * extent_ * length(normal))) {
        return std::nullopt;
    }
    return std::array<std::uint32_t, 4>{0, b, c, d};
}

void HullBuilder::add(Corners corners) {
    const Vec3& p = points_[corners[0]];
    Vec3 normal = (points_[corners[1]] - p).cross(points_[corners[2]] - p);
    const double area = length(normal);
    if (area <= 0) {
        return;
    }
    normal /= area;
    if (normal.dot(inside_ - p) > 0) {
        std::swap(corners[1], corners[2]);
        normal = -normal;
    }
    facets_.push_back({corners, normal, normal.dot(p)});
}

void HullBuilder::include(std::uint32_t point) {
    const auto sees = [&](const Facet& f) { return f.height(points_[point]) > flatness(); };
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> outline;
    bool is_outside = false;
    for (const Facet& f : facets_) {
        if (!sees(f)) {
            continue;
        }
        is_outside = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = f.corners[i];
            const std::uint32_t to = f.corners[(i + 1) % 3];
            if (outline.erase({to, from}) == 0) {
                outline[{from, to}] = true;
            }
        }
    }
    if (!is_outside) {
        return;
    }
    std::erase_if(facets_, sees);
    for (const auto& [edge, unused] : outline) {
        add({edge.first, edge.second, point});
    }
}

/// The corners of the facets in one plane, in order around their outline.
std::vector<std::uint32_t> ordered(std::vector<std::uint32_t> corners, std::span<const Vec3> points,
                                   const Vec3& normal, double flatness) {
    Vec3 centre(0, 0, 0);
    for (const std::uint32_t i : corners) {
        centre += points[i] / static_cast<double>(corners.size());
    }
    // The next corner is the one with all others to its left.
    std::vector<std::uint32_t> loop{corners.front()};
    for (const std::uint32_t i : corners) {
        if (length(points[i] - centre) > length(points[loop.front()] - centre)) {
            loop.front() = i;
        }
    }
    while (loop.size() <= corners.size()) {
        const Vec3& from = points[loop.back()];
        std::optional<std::uint32_t> next;
        for (const std::uint32_t i : corners) {
            if (i == loop.back()) {
                continue;
            }
            if (!next) {
                next = i;
                continue;
            }
            const Vec3 best = points[*next] - from;
            const Vec3 other = points[i] - from;
            const double side = normal.dot(best.cross(other));
            const double straight = flatness * std::max(length(best), length(other));
            if (side < -straight || (side <= straight && length(other) > length(best))) {
                next = i;
            }
        }
        if (!next || *next == loop.front()) {
            break;
        }
        loop.push_back(*next);
    }
    return loop;
}

Polyhedron HullBuilder::merged() const {
    const double flat = 1e-7 * extent_;
    Polyhedron result;
    std::vector<bool> is_done(facets_.size(), false);
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        if (is_done[i]) {
            continue;
        }
        std::vector<std::uint32_t> corners;
        for (std::size_t j = i; j < facets_.size(); ++j) {
            const bool is_coplanar =
                facets_[i].normal.dot(facets_[j].normal) > 0.999 &&
                std::all_of(facets_[j].corners.begin(), facets_[j].corners.end(),
                            [&](std::uint32_t c) {
                                return std::abs(facets_[i].height(points_[c])) <= flat;
                            });
            if (is_done[j] || (j != i && !is_coplanar)) {
                continue;
            }
            is_done[j] = true;
            corners.insert(corners.end(), facets_[j].corners.begin(), facets_[j].corners.end());
        }
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        PolyhedronFace face;
        face.normal = facets_[i].normal;
        for (const std::uint32_t c : ordered(corners, points_, face.normal, flat)) {
            const auto [entry, is_new] =
                numbers.emplace(c, static_cast<std::uint32_t>(numbers.size()));
            if (is_new) {
                result.vertices.push_back(points_[c]);
            }
            face.corners.push_back(entry->second);
        }
        if (face.corners.size() >= 3) {
            result.faces.push_back(std::move(face));
        }
    }
    return result;
}

}  // namespace

std::optional<Polyhedron> convex_hull(std::span<const Vec3> points) {
    if (points.size() < 4) {
        return std::nullopt;
    }
    HullBuilder builder(points);
    if (!builder.build()) {
        return std::nullopt;
    }
    return builder.merged();
}

}  // namespace carom::sim
