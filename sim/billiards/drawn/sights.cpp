#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "sim/billiards/drawn/drawn_parts.h"
#include "sim/billiards/parts.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

// WPA, Tournament Table and Equipment Specifications, section 5 ("Rail and Cushion"): diamonds of
// 1 x 7/16 in to 1 1/4 x 5/8 in or discs of 7/16 to 1/2 in, their centre 3 11/16 in from the nose.
constexpr double kDiamondLength = 0.0254;
constexpr double kDiamondWidth = 0.0111125;
constexpr double kDiscRadius = 0.00635;
constexpr double kFromNose = 0.0936625;

Loop diamond(const Vec2& centre, const Vec2& axis) {
    const Vec2 across(-axis.y, axis.x);
    return {centre + 0.5 * kDiamondLength * axis, centre + 0.5 * kDiamondWidth * across,
            centre - 0.5 * kDiamondLength * axis, centre - 0.5 * kDiamondWidth * across};
}

Loop disc(const Vec2& centre) {
    constexpr int kCorners = 32;
    Loop loop;
    for (int corner = 0; corner < kCorners; ++corner) {
        const double angle = 2 * std::numbers::pi * corner / kCorners;
        const SinCos at = sin_cos(angle);
        loop.push_back(centre + kDiscRadius * Vec2(at.cos, at.sin));
    }
    return loop;
}

}  // namespace

std::vector<Loop> sight_outlines(const TableLayout& layout) {
    const TableMeasures& measures = layout.measures;
    std::vector<Loop> outlines;
    if (measures.kind == TableKind::snooker) {
        return outlines;
    }
    for (std::size_t index = 0; index < 4; ++index) {
        const SideFrame& side = layout.sides[index];
        const bool is_long = index % 2 == 0;
        // At eighths of the length and quarters of the width.
        const int count = is_long ? 4 : 2;
        const double step = is_long ? measures.length / 8 : measures.width / 4;
        for (int sight = 1 - count; sight < count; ++sight) {
            if (is_long && sight == 0 && measures.side_pocket) {
                continue;
            }
            const Vec2 centre = side.at(sight * step, kFromNose);
            outlines.push_back(measures.kind == TableKind::carom ? disc(centre)
                                                                 : diamond(centre, side.outward));
        }
    }
    return outlines;
}

}  // namespace carom::sim::billiards
