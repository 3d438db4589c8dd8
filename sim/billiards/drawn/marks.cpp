#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "sim/billiards/drawn/drawn_parts.h"
#include "sim/billiards/drawn/profiles.h"
#include "sim/billiards/parts.h"
#include "sim/billiards/spots.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

constexpr double kAbove = 0.00006;      // of lines above the cloth, m
constexpr double kSpotAbove = 0.0001;   // of spots, m
constexpr double kLineWidth = 0.0025;   // drawn with a pen or tailor's chalk; ours, m
constexpr double kSpotRadius = 0.0045;  // of a snooker table's spots; ours, m
constexpr double kPatchRadius = 0.014;  // of the patch on a pool table's foot spot; ours, m
constexpr double kCrossLength = 0.016;  // of the crosses on a carom table's spots; ours, m
constexpr double kCrossWidth = 0.0009;
// WPBSA, Official Rules of Snooker, section 1, rule 1.
constexpr double kBaulk = 0.737;  // from the baulk cushion's face, m
constexpr double kD = 0.292;      // radius of the D, m

void add_disc(SurfaceBuilder& builder, const Vec2& centre, double radius) {
    constexpr int kCorners = 24;
    Loop loop;
    for (int corner = 0; corner < kCorners; ++corner) {
        const SinCos at = sin_cos(2 * std::numbers::pi * corner / kCorners);
        loop.push_back(centre + radius * Vec2(at.cos, at.sin));
    }
    builder.add_level(std::span(&loop, 1), kSpotAbove, true, HUGE_VAL);
}

void add_strip(SurfaceBuilder& builder, const Vec2& from, const Vec2& to, double width) {
    const Vec2 along = (to - from).normalized();
    const Vec2 half = 0.5 * width * Vec2(-along.y, along.x);
    const Loop loop{from - half, to - half, to + half, from + half};
    builder.add_level(std::span(&loop, 1), kAbove, true, HUGE_VAL);
}

void add_half_ring(SurfaceBuilder& builder, const Vec2& centre, double radius, double width) {
    constexpr int kSteps = 64;
    Loop loop;
    for (const double side : {1.0, -1.0}) {
        for (int step = 0; step <= kSteps; ++step) {
            const int place = side > 0 ? step : kSteps - step;
            const SinCos at = sin_cos(std::numbers::pi * (0.5 + double(place) / kSteps));
            // The ring ends at the baulk line's edge.
            const Vec2 point = (radius + 0.5 * side * width) * Vec2(at.cos, at.sin);
            loop.push_back(centre + Vec2(std::min(point.x, -0.5 * width), point.y));
        }
    }
    builder.add_level(std::span(&loop, 1), kAbove, true, HUGE_VAL);
}

}  // namespace

std::vector<Surface> draw_marks(const TableLayout& layout) {
    const TableMeasures& measures = layout.measures;
    SurfaceBuilder lines("lines", SurfacePart::line);
    SurfaceBuilder spots("spots", SurfacePart::spot);
    std::vector<Surface> marks;
    if (measures.kind == TableKind::snooker) {
        const double x = kBaulk - 0.5 * measures.length;
        const double end = 0.5 * measures.width;
        add_strip(lines, {x, -end}, {x, end}, kLineWidth);
        add_half_ring(lines, {x, 0}, kD, kLineWidth);
        marks.push_back(std::move(lines).finish());
    }
    for (const Spot& spot : spots_of(measures)) {
        if (measures.kind == TableKind::snooker) {
            add_disc(spots, spot.place, kSpotRadius);
        } else if (measures.kind == TableKind::pool && spot.name == "foot") {
            add_disc(spots, spot.place, kPatchRadius);
        } else if (measures.kind == TableKind::carom) {
            const Vec2 along(0.5 * kCrossLength, 0);
            const Vec2 across(0, 0.5 * kCrossLength);
            const Vec2 beside(0, 0.5 * kCrossWidth);
            add_strip(spots, spot.place - along, spot.place + along, kCrossWidth);
            add_strip(spots, spot.place - across, spot.place - beside, kCrossWidth);
            add_strip(spots, spot.place + beside, spot.place + across, kCrossWidth);
        }
    }
    Surface all_spots = std::move(spots).finish();
    if (!all_spots.triangles.empty()) {
        marks.push_back(std::move(all_spots));
    }
    return marks;
}

std::optional<Surface> draw_name_plate(const TableLayout& layout) {
    constexpr double kHalfWidth = 0.042;
    constexpr double kHalfHeight = 0.011;
    constexpr double kProud = 0.0009;
    constexpr double kBevel = 0.0005;
    const TableMeasures& measures = layout.measures;
    const double top = drawn_rail_top(measures);
    const double wall_top = top - outer_edge_radius(measures, top);
    const double middle = 0.5 * (wall_top + kRailBottom);
    if (build_of(measures) == TableBuild::carom || wall_top - middle < kHalfHeight + 0.004 ||
        measures.width < 4 * kHalfWidth) {
        return {};
    }
    const SideFrame& side = layout.sides[3];
    const double face = measures.cushion_width + measures.rail_width;
    SurfaceBuilder builder("name_plate", SurfacePart::name_plate);
    const auto corners = [&](double inset, double proud) {
        std::vector<Vec3> ring;
        for (const Vec2& sign : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
            const Vec2 at = side.at(sign.x * (kHalfWidth - inset), face + proud);
            ring.emplace_back(at.x, at.y, middle + sign.y * (kHalfHeight - inset));
        }
        return ring;
    };
    const Vec3 outward(side.outward.x, side.outward.y, 0);
    const std::array<std::vector<Vec3>, 3> rings{
        {corners(0, -0.001), corners(0, kProud - kBevel), corners(kBevel, kProud)}};
    for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) {
        for (std::size_t edge = 0; edge < 4; ++edge) {
            const std::size_t next = (edge + 1) % 4;
            const Vec3& a = rings[ring][edge];
            const Vec3& b = rings[ring][next];
            const Vec3& c = rings[ring + 1][next];
            const Vec3 normal = (b - a).cross(c - a).normalized();
            const std::array<Vec3, 4> quad{a, b, c, rings[ring + 1][edge]};
            builder.add_polygon(quad, normal);
        }
    }
    builder.add_polygon(rings[2], outward);
    return std::move(builder).finish();
}

}  // namespace carom::sim::billiards
