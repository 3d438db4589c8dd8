#include "render/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/assert.h"

namespace carom::render {
namespace {

/// Comparisons for every file, which take about 1 s, and for each corner of its polygons. Outlines
/// of gears and letters with 1000 corners need about 50 for each.
constexpr std::size_t kWorkOfFile = 200'000'000;
constexpr std::size_t kWorkOfCorner = 200;

/// Up to so many corners all are compared with a triangle. Of larger polygons only those at which
/// the outline turns to the right, because one of these is in the triangle if any corner is.
constexpr std::size_t kFewCorners = 64;

/// Area of triangles of the wrong orientation that counts as none, in areas of the polygon.
constexpr double kNoArea = 1e-11;

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

/// The projection drops the axis along which the polygon is thinnest and keeps the orientation.
/// It rounds nothing, so corners that coincide still do.
std::vector<Vec2> flatten(std::span<const Vec3> corners) {
    const Vec3 n = area_vector(corners);
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

/// Twice the area of a triangle; positive if it is counter-clockwise.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).cross(c - a);
}

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

using Corners = std::array<Vec2, 3>;

/// What is left of a polygon while triangles are cut off.
class Clipper {
  public:
    Clipper(const std::vector<Vec2>& points, std::size_t& work)
        : points_(points), work_(work), size_(points.size()) {
        const auto count = static_cast<std::uint32_t>(size_);
        for (std::uint32_t i = 0; i < count; ++i) {
            previous_.push_back((i + count - 1) % count);
            next_.push_back((i + 1) % count);
        }
        is_left_.assign(size_, true);
        triangles_.reserve(size_ - 2);
    }

    /// Both return whether the work sufficed.
    bool clip_simple();
    bool clip_touching();

    [[nodiscard]] PolygonTriangles& triangles() { return triangles_; }

    /// Twice the area of those triangles that have the wrong orientation. If it is zero, the
    /// triangles cover the polygon exactly once, because their areas add up to the polygon's.
    [[nodiscard]] double wrong_area() const {
        double wrong = 0;
        double all = 0;
        for (const auto& t : triangles_) {
            const double area = turn(points_[t[0]], points_[t[1]], points_[t[2]]);
            wrong += std::max(0.0, -area);
            all += std::abs(area);
        }
        return wrong <= kNoArea * all ? 0 : wrong;
    }

  private:
    [[nodiscard]] Corners corners_at(std::uint32_t at) const {
        return {points_[previous_[at]], points_[at], points_[next_[at]]};
    }
    [[nodiscard]] double rotation_at(std::uint32_t at) const {
        return turn(points_[previous_[at]], points_[at], points_[next_[at]]);
    }

    /// Cuts off a corner and returns the next one.
    std::uint32_t clip(std::uint32_t at) {
        const std::uint32_t before = previous_[at];
        const std::uint32_t after = next_[at];
        triangles_.push_back({before, at, after});
        next_[before] = after;
        previous_[after] = before;
        is_left_[at] = false;
        --size_;
        if (by_x_.size() > 2 * size_) {
            std::erase_if(by_x_, [&](std::uint32_t one) { return !is_left_[one]; });
        }
        return after;
    }

    bool spend(std::size_t comparisons) {
        const bool suffices = comparisons <= work_;
        work_ -= suffices ? comparisons : work_;
        return suffices;
    }

    template <class IsCandidate>
    void sort_by_x(const IsCandidate& is_candidate) {
        for (std::uint32_t i = 0; i < points_.size(); ++i) {
            if (is_candidate(i)) {
                by_x_.push_back(i);
            }
        }
        std::sort(by_x_.begin(), by_x_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return points_[a].x != points_[b].x ? points_[a].x < points_[b].x : a < b;
        });
    }

    /// Whether `is_in_way` holds for a candidate in the box around a triangle.
    template <class IsInWay>
    bool any_near(const Corners& triangle, const IsInWay& is_in_way) {
        const auto& [a, b, c] = triangle;
        const Vec2 low(std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}));
        const Vec2 high(std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}));
        auto one = std::partition_point(by_x_.begin(), by_x_.end(),
                                        [&](std::uint32_t i) { return points_[i].x < low.x; });
        const auto begin = one;
        bool found = false;
        for (; one != by_x_.end() && !found && points_[*one].x <= high.x; ++one) {
            const Vec2& p = points_[*one];
            found = is_left_[*one] && p.y >= low.y && p.y <= high.y && is_in_way(*one);
        }
        has_work_ = spend(static_cast<std::size_t>(one - begin) + 1) && has_work_;
        return found;
    }

    bool is_ear(std::uint32_t at);
    bool is_clear(std::uint32_t at, double tolerance);
    [[nodiscard]] bool is_spike(std::uint32_t at) const;
    [[nodiscard]] bool is_in_way(std::uint32_t p, const Corners& triangle, double tolerance) const;
    template <class Predicate>
    std::uint32_t find(std::uint32_t from, const Predicate& is_wanted);
    [[nodiscard]] std::uint32_t flattest(std::uint32_t from);
    std::uint32_t find_touching_ear(std::uint32_t from, double extent);

    const std::vector<Vec2>& points_;
    std::size_t& work_;
    bool has_work_ = true;
    std::size_t size_;  // corners that are left
    std::vector<std::uint32_t> previous_, next_;
    std::vector<bool> is_left_;
    std::vector<std::uint32_t> by_x_;  // corners that may be in the way, and some that are cut off
    PolygonTriangles triangles_;
};

/// Whether no other corner is in the triangle at a corner, where those that coincide with its ends
/// do not count: right for all polygons that do not touch themselves.
bool Clipper::is_ear(std::uint32_t at) {
    const Corners triangle = corners_at(at);
    const auto& [a, b, c] = triangle;
    if (turn(a, b, c) <= 0) {
        return false;
    }
    return !any_near(triangle, [&, &a = a, &b = b, &c = c](std::uint32_t k) {
        const Vec2& p = points_[k];
        return k != at && p != a && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
               turn(c, a, p) >= 0;
    });
}

/// Goes round the polygon. If every corner is rejected, it is clipped at the current one.
bool Clipper::clip_simple() {
    sort_by_x(
        [&](std::uint32_t i) { return points_.size() <= kFewCorners || rotation_at(i) <= 0; });
    std::uint32_t at = 0;
    std::size_t tried = 0;
    while (size_ > 3 && has_work_) {
        if (!is_ear(at) && ++tried <= size_) {
            at = next_[at];
            continue;
        }
        tried = 0;
        at = clip(at);
    }
    triangles_.push_back({previous_[at], at, next_[at]});
    return has_work_;
}

/// Whether a corner of the polygon is inside of a triangle, or on its edge with an edge of the
/// polygon that leads into it.
bool Clipper::is_in_way(std::uint32_t p, const Corners& triangle, double tolerance) const {
    const auto side = [&](std::size_t edge, const Vec2& point) {
        return turn(triangle[edge], triangle[(edge + 1) % 3], point);
    };
    std::array<bool, 3> touches{};
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const double distance = side(edge, points_[p]);
        if (distance < -tolerance) {
            return false;
        }
        touches[edge] = distance <= tolerance;
    }
    const auto leads_inside = [&](std::uint32_t neighbour) {
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (touches[edge] && side(edge, points_[neighbour]) <= tolerance) {
                return false;
            }
        }
        return true;
    };
    const bool is_inside = !touches[0] && !touches[1] && !touches[2];
    return is_inside || leads_inside(previous_[p]) || leads_inside(next_[p]);
}

/// Whether the triangle at a corner can be cut off, also where the polygon touches itself.
bool Clipper::is_clear(std::uint32_t at, double tolerance) {
    const Corners triangle = corners_at(at);
    return rotation_at(at) > 0 &&
           !any_near(triangle, [&](std::uint32_t k) { return is_in_way(k, triangle, tolerance); });
}

/// Whether the outline returns the way it came, or a corner is repeated.
bool Clipper::is_spike(std::uint32_t at) const {
    const auto& [a, b, c] = corners_at(at);
    return turn(a, b, c) == 0 && (a - b).dot(c - b) >= 0;
}

/// The first corner from `from` on for which the predicate holds, or kNone.
template <class Predicate>
std::uint32_t Clipper::find(std::uint32_t from, const Predicate& is_wanted) {
    std::uint32_t at = from;
    do {
        if (is_wanted(at)) {
            return at;
        }
        at = next_[at];
    } while (at != from && has_work_);
    return kNone;
}

/// The corner with the smallest triangle.
std::uint32_t Clipper::flattest(std::uint32_t from) {
    has_work_ = spend(size_) && has_work_;
    std::uint32_t best = from;
    for (std::uint32_t at = next_[from]; at != from; at = next_[at]) {
        best = std::abs(rotation_at(at)) < std::abs(rotation_at(best)) ? at : best;
    }
    return best;
}

/// The next corner to cut off: one that can be cut off cleanly, else one without an area, else one
/// that rounding has put in the way of another, and at last the smallest.
std::uint32_t Clipper::find_touching_ear(std::uint32_t from, double extent) {
    constexpr std::array kTolerances = {0.0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6};  // of the extent
    for (const double relative : kTolerances) {
        const double tolerance = relative * extent;
        const std::uint32_t ear =
            find(from, [&](std::uint32_t at) { return is_clear(at, tolerance); });
        if (ear != kNone || !has_work_) {
            return ear;
        }
        const std::uint32_t flat = flattest(from);
        if (std::abs(rotation_at(flat)) <= tolerance) {
            return flat;
        }
    }
    return flattest(from);
}

bool Clipper::clip_touching() {
    double extent = 0;  // squared
    for (const Vec2& point : points_) {
        extent = std::max(extent, (point - points_[0]).length2());
    }
    sort_by_x([](std::uint32_t /*all*/) { return true; });
    std::uint32_t at = 0;
    std::uint32_t spike = kNone;
    bool may_have_spikes = true;
    while (size_ > 3 && has_work_) {
        // Only the neighbours of a corner that was cut off can become spikes.
        spike = may_have_spikes ? find(at, [&](std::uint32_t i) { return is_spike(i); }) : kNone;
        may_have_spikes = spike != kNone;
        const std::uint32_t corner = spike != kNone ? spike : find_touching_ear(at, extent);
        if (corner != kNone) {
            const std::uint32_t before = previous_[corner];
            at = clip(corner);
            may_have_spikes = may_have_spikes || is_spike(before) || is_spike(at);
        }
    }
    triangles_.push_back({previous_[at], at, next_[at]});
    return has_work_;
}

}  // namespace

std::optional<PolygonTriangles> triangulate(std::span<const Vec3> corners, std::size_t& work) {
    CAROM_ASSERT(corners.size() >= 3);
    if (corners.size() == 3) {
        return PolygonTriangles{{0, 1, 2}};
    }
    const std::vector<Vec2> points = flatten(corners);
    Clipper simple(points, work);
    if (!simple.clip_simple()) {
        return std::nullopt;
    }
    if (simple.wrong_area() == 0) {
        return std::move(simple.triangles());
    }
    Clipper touching(points, work);
    if (!touching.clip_touching()) {
        return std::nullopt;
    }
    return std::move(touching.wrong_area() < simple.wrong_area() ? touching.triangles()
                                                                 : simple.triangles());
}

PolygonCutter::PolygonCutter(std::size_t corner_count)
    : work_(kWorkOfFile + kWorkOfCorner * corner_count) {}

bool PolygonCutter::cut(std::span<const Vec3> vertices, std::span<const std::uint32_t> polygon,
                        PolygonTriangles& triangles) {
    if (polygon.size() == 3) {
        triangles.push_back({polygon[0], polygon[1], polygon[2]});
        return true;
    }
    corners_.clear();
    for (const std::uint32_t vertex : polygon) {
        corners_.push_back(vertices[vertex]);
    }
    const auto cut = triangulate(corners_, work_);
    if (!cut) {
        return false;
    }
    for (const auto& t : *cut) {
        triangles.push_back({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
    }
    return true;
}

}  // namespace carom::render
