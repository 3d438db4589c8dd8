// An initial triangulation of a polygon with holes: valid, but with badly shaped triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/billiards/triangulation.h"

namespace carom::sim::billiards {

/// Twice the signed area of the triangle; positive if counter-clockwise.
[[nodiscard]] inline double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Counter-clockwise triangles over the points of all loops, by ear clipping (Meisters, "Polygons
/// have ears", 1975) after each hole is joined to the outside by a bridge.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> clip_ears(std::span<const Loop> loops);

}  // namespace carom::sim::billiards
