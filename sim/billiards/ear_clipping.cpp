#include "sim/billiards/ear_clipping.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace carom::sim::billiards {

namespace {

using Index = std::uint32_t;

constexpr double kSmallestArea = 1e-14;  // doubled, m^2: below it three points are collinear

double signed_area(const Loop& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        sum += doubled_area({0, 0}, loop[i], loop[(i + 1) % loop.size()]);
    }
    return sum;
}

bool do_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return doubled_area(a, b, c) * doubled_area(a, b, d) < 0 &&
           doubled_area(c, d, a) * doubled_area(c, d, b) < 0;
}

/// The outline of the region as one closed walk, which passes bridges in both directions.
class Outline {
  public:
    explicit Outline(std::span<const Loop> loops) {
        for (std::size_t i = 0; i < loops.size(); ++i) {
            std::vector<Index> ring;
            for (const Vec2& point : loops[i]) {
                ring.push_back(static_cast<Index>(points_.size()));
                points_.push_back(point);
            }
            // Material is on the left: the outside runs counter-clockwise, holes clockwise.
            if ((signed_area(loops[i]) > 0) != (i == 0)) {
                std::reverse(ring.begin(), ring.end());
            }
            rings_.push_back(std::move(ring));
        }
        walk_ = rings_[0];
        for (std::size_t i = 1; i < rings_.size(); ++i) {
            join(rings_[i]);
        }
    }

    [[nodiscard]] std::vector<std::array<Index, 3>> clip() {
        std::vector<std::array<Index, 3>> triangles;
        std::size_t corner = 0;
        std::size_t failures = 0;
        while (walk_.size() > 3) {
            const std::size_t count = walk_.size();
            const std::size_t before = (corner + count - 1) % count;
            const std::size_t after = (corner + 1) % count;
            if (is_ear(before, corner, after)) {
                triangles.push_back({walk_[before], walk_[corner], walk_[after]});
                walk_.erase(walk_.begin() + static_cast<std::ptrdiff_t>(corner));
                failures = 0;
                // Continue after the cut, so that triangles do not all share one point.
                corner = (corner + 1) % walk_.size();
                continue;
            }
            if (++failures > count) {
                throw Error("an outline of the table crosses itself");
            }
            corner = after;
        }
        triangles.push_back({walk_[0], walk_[1], walk_[2]});
        return triangles;
    }

  private:
    [[nodiscard]] bool is_blocked(const Vec2& a, const Vec2& b) const {
        for (const std::vector<Index>& ring : rings_) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                if (do_cross(a, b, points_[ring[i]], points_[ring[(i + 1) % ring.size()]])) {
                    return true;
                }
            }
        }
        return false;
    }

    // Joins the ring to the walk by the shortest free bridge.
    void join(const std::vector<Index>& ring) {
        std::size_t best_ring = 0;
        std::size_t best_walk = 0;
        double best = HUGE_VAL;
        for (std::size_t r = 0; r < ring.size(); r += 4) {
            for (std::size_t w = 0; w < walk_.size(); ++w) {
                const Vec2 span = points_[walk_[w]] - points_[ring[r]];
                const double distance = span.dot(span);
                if (distance < best && !is_blocked(points_[ring[r]], points_[walk_[w]])) {
                    best = distance;
                    best_ring = r;
                    best_walk = w;
                }
            }
        }
        if (best == HUGE_VAL) {
            throw Error("an outline of the table crosses itself");
        }
        std::vector<Index> detour;
        for (std::size_t i = 0; i <= ring.size(); ++i) {
            detour.push_back(ring[(best_ring + i) % ring.size()]);
        }
        detour.push_back(walk_[best_walk]);
        walk_.insert(walk_.begin() + static_cast<std::ptrdiff_t>(best_walk) + 1, detour.begin(),
                     detour.end());
    }

    [[nodiscard]] bool is_ear(std::size_t before, std::size_t corner, std::size_t after) const {
        const Vec2& a = points_[walk_[before]];
        const Vec2& b = points_[walk_[corner]];
        const Vec2& c = points_[walk_[after]];
        if (doubled_area(a, b, c) <= kSmallestArea) {
            return false;
        }
        const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
        const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
        for (const Index index : walk_) {
            const Vec2& p = points_[index];
            if (p.x < low_x || p.x > high_x || p.y < low_y || p.y > high_y || p == a || p == b ||
                p == c) {
                continue;
            }
            if (doubled_area(a, b, p) >= 0 && doubled_area(b, c, p) >= 0 &&
                doubled_area(c, a, p) >= 0) {
                return false;
            }
        }
        return true;
    }

    std::vector<Vec2> points_;
    std::vector<std::vector<Index>> rings_;
    std::vector<Index> walk_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> clip_ears(std::span<const Loop> loops) {
    return Outline(loops).clip();
}

}  // namespace carom::sim::billiards
