#include "sim/billiards/triangulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/error.h"
#include "sim/billiards/ear_clipping.h"

namespace carom::sim::billiards {

namespace {

using Index = std::uint32_t;
constexpr Index kNone = ~Index{0};

/// Triangles with links to their neighbours. Edges of the region's outline have no neighbour, so
/// they are never flipped.
class Mesh {
  public:
    Mesh(std::vector<Vec2> points, const std::vector<std::array<Index, 3>>& triangles)
        : points_(std::move(points)) {
        std::map<std::pair<Index, Index>, std::pair<Index, int>> open;
        for (const auto& corners : triangles) {
            const auto index = static_cast<Index>(triangles_.size());
            triangles_.push_back({corners, {kNone, kNone, kNone}});
            for (int side = 0; side < 3; ++side) {
                const Index a = corners[next(side)];
                const Index b = corners[next(next(side))];
                if (const auto other = open.find({b, a}); other != open.end()) {
                    const auto [neighbour, its_side] = other->second;
                    triangles_[index].across[side] = neighbour;
                    triangles_[neighbour].across[its_side] = index;
                } else {
                    open[{a, b}] = {index, side};
                }
            }
        }
    }

    // Lawson, "Software for C1 surface interpolation", 1977: flip until every edge is Delaunay.
    // Each flip increases the smallest angle; the bound on passes is only needed for rounding.
    void make_delaunay() {
        for (int pass = 0; pass < 100; ++pass) {
            const std::size_t before = flip_count_;
            for (Index index = 0; index < triangles_.size(); ++index) {
                for (int side = 0; side < 3; ++side) {
                    legalize(index, side);
                }
            }
            if (flip_count_ == before) {
                return;
            }
        }
    }

    /// Adds an inner point unless it would create a sliver.
    void insert(const Vec2& point) {
        const Index index = triangle_at(point);
        if (index == kNone) {
            return;
        }
        const auto corners = triangles_[index].corners;
        for (int side = 0; side < 3; ++side) {
            const Vec2& a = points_[corners[next(side)]];
            const Vec2& b = points_[corners[next(next(side))]];
            if (doubled_area(a, b, point) < 1e-3 * (b - a).dot(b - a)) {
                return;
            }
        }
        split(index, point);
    }

    [[nodiscard]] Triangulation finish() && {
        Triangulation result;
        result.points = std::move(points_);
        for (const Triangle& triangle : triangles_) {
            result.triangles.push_back(triangle.corners);
        }
        return result;
    }

  private:
    struct Triangle {
        std::array<Index, 3> corners;
        std::array<Index, 3> across;  // across[i]: the neighbour opposite to corners[i]
    };

    static int next(int side) { return side == 2 ? 0 : side + 1; }

    [[nodiscard]] int side_towards(Index index, Index neighbour) const {
        const auto& across = triangles_[index].across;
        return across[0] == neighbour ? 0 : across[1] == neighbour ? 1 : 2;
    }

    void replace_neighbour(Index index, Index before, Index after) {
        if (index != kNone) {
            triangles_[index].across[side_towards(index, before)] = after;
        }
    }

    [[nodiscard]] bool is_in_circle(const Triangle& triangle, const Vec2& p) const {
        const Vec2 a = points_[triangle.corners[0]] - p;
        const Vec2 b = points_[triangle.corners[1]] - p;
        const Vec2 c = points_[triangle.corners[2]] - p;
        const double aa = a.dot(a);
        const double bb = b.dot(b);
        const double cc = c.dot(c);
        const double determinant = aa * (b.x * c.y - b.y * c.x) - bb * (a.x * c.y - a.y * c.x) +
                                   cc * (a.x * b.y - a.y * b.x);
        // Requires a clear margin; otherwise four points of one circle would be flipped forever.
        return determinant > 1e-10 * (aa * bb + bb * cc + cc * aa);
    }

    // Makes the edge opposite to a corner Delaunay, and then the edges that the flip may have
    // affected.
    void legalize(Index index, int side) {
        const Index other = triangles_[index].across[side];
        if (other == kNone) {
            return;
        }
        const int other_side = side_towards(other, index);
        if (!is_in_circle(triangles_[index], points_[triangles_[other].corners[other_side]])) {
            return;
        }
        flip(index, side, other, other_side);
        legalize(index, 0);
        legalize(index, 2);
        legalize(other, 0);
        legalize(other, 1);
    }

    // The diagonal (a, b) of the quadrilateral (p, a, q, b) becomes (p, q).
    void flip(Index index, int side, Index other, int other_side) {
        Triangle& first = triangles_[index];
        Triangle& second = triangles_[other];
        const Index p = first.corners[side];
        const Index a = first.corners[next(side)];
        const Index b = first.corners[next(next(side))];
        const Index q = second.corners[other_side];
        const Index across_pa = first.across[next(next(side))];
        const Index across_bp = first.across[next(side)];
        const Index across_qb = second.across[next(next(other_side))];
        const Index across_aq = second.across[next(other_side)];
        first = {{p, a, q}, {across_aq, other, across_pa}};
        second = {{p, q, b}, {across_qb, across_bp, index}};
        replace_neighbour(across_aq, other, index);
        replace_neighbour(across_bp, index, other);
        ++flip_count_;
    }

    /// A side with the point beyond it, or -1 if the triangle contains the point.
    [[nodiscard]] int side_before(const Triangle& triangle, const Vec2& point) const {
        for (int side = 0; side < 3; ++side) {
            if (doubled_area(points_[triangle.corners[next(side)]],
                             points_[triangle.corners[next(next(side))]], point) < 0) {
                return side;
            }
        }
        return -1;
    }

    /// Walks towards the point from the last triangle found (Lawson 1977), which usually is near.
    /// Tests all triangles if a hole or the outline blocks the walk.
    [[nodiscard]] Index triangle_at(const Vec2& point) {
        Index index = last_found_;
        for (std::size_t step = 0; step < triangles_.size() && index != kNone; ++step) {
            const int side = side_before(triangles_[index], point);
            if (side < 0) {
                return last_found_ = index;
            }
            index = triangles_[index].across[side];
        }
        for (index = 0; index < triangles_.size(); ++index) {
            if (side_before(triangles_[index], point) < 0) {
                return last_found_ = index;
            }
        }
        return kNone;
    }

    void split(Index index, const Vec2& point) {
        const auto p = static_cast<Index>(points_.size());
        points_.push_back(point);
        const auto [a, b, c] = triangles_[index].corners;
        const auto [across_bc, across_ca, across_ab] = triangles_[index].across;
        const auto second = static_cast<Index>(triangles_.size());
        const Index third = second + 1;
        triangles_[index] = {{p, b, c}, {across_bc, second, third}};
        triangles_.push_back({{p, c, a}, {across_ca, third, index}});
        triangles_.push_back({{p, a, b}, {across_ab, index, second}});
        replace_neighbour(across_ca, index, second);
        replace_neighbour(across_ab, index, third);
        legalize(index, 0);
        legalize(second, 0);
        legalize(third, 0);
    }

    std::vector<Vec2> points_;
    std::vector<Triangle> triangles_;
    Index last_found_ = 0;
    std::size_t flip_count_ = 0;
};

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 span = b - a;
    const double s = std::clamp((p - a).dot(span) / span.dot(span), 0.0, 1.0);
    return (p - (a + s * span)).length();
}

/// Whether the point is farther than `distance` from the box of the segment.
bool is_outside_box(const Vec2& p, const Vec2& a, const Vec2& b, double distance) {
    return p.x < std::min(a.x, b.x) - distance || p.x > std::max(a.x, b.x) + distance ||
           p.y < std::min(a.y, b.y) - distance || p.y > std::max(a.y, b.y) + distance;
}

// A triangular grid over the bounding box, away from all edges. Points in holes find no triangle.
std::vector<Vec2> inner_points(std::span<const Loop> loops, double spacing) {
    Vec2 low = loops[0][0];
    Vec2 high = low;
    for (const Vec2& p : loops[0]) {
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    const double margin = 0.6 * spacing;
    const auto is_free = [&](const Vec2& point) {
        for (const Loop& loop : loops) {
            const Vec2* from = &loop.back();
            for (const Vec2& to : loop) {
                if (!is_outside_box(point, *from, to, margin) &&
                    distance_to_segment(point, *from, to) < margin) {
                    return false;
                }
                from = &to;
            }
        }
        return true;
    };
    std::vector<Vec2> points;
    const double row_height = spacing * 0.8660254037844386;  // sqrt(3)/2
    for (int row = 1; low.y + row * row_height < high.y; ++row) {
        for (int column = 0; low.x + column * spacing < high.x; ++column) {
            const Vec2 point(low.x + (column + (row % 2 == 0 ? 0.5 : 1.0)) * spacing,
                             low.y + row * row_height);
            if (is_free(point)) {
                points.push_back(point);
            }
        }
    }
    return points;
}

// Clipped ears always have the right orientation; the last triangle of a crossed outline does not.
void check_orientation(const std::vector<Vec2>& points,
                       const std::vector<std::array<Index, 3>>& triangles) {
    for (const auto& [a, b, c] : triangles) {
        if (!(doubled_area(points[a], points[b], points[c]) > 0)) {
            throw Error("an outline of the table crosses itself");
        }
    }
}

}  // namespace

Triangulation triangulate(std::span<const Loop> loops, double spacing) {
    std::vector<Vec2> points;
    for (const Loop& loop : loops) {
        if (loop.size() < 3) {
            throw Error("an outline of the table has fewer than three points");
        }
        points.insert(points.end(), loop.begin(), loop.end());
    }
    const auto triangles = clip_ears(loops);
    check_orientation(points, triangles);
    Mesh mesh(std::move(points), triangles);
    mesh.make_delaunay();
    for (const Vec2& point : inner_points(loops, spacing)) {
        mesh.insert(point);
    }
    mesh.make_delaunay();
    return std::move(mesh).finish();
}

}  // namespace carom::sim::billiards
