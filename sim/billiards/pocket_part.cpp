#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "sim/billiards/parts.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

constexpr double kRimAboveRail = 0.001;  // m
constexpr double kBelowFloor = 0.002;    // of the liner, below the pocket's floor, m
constexpr double kWingLength = 0.018;    // m
constexpr double kWingProud = 0.0004;    // by which a wing stands out from the rail's edge, m
constexpr double kFloorSpacing = 0.02;   // m

// The liner's cross-section: down its inside, along its foot, up its outside, over its rim.
std::vector<Profile> wall_profile(double bottom, double top) {
    constexpr int kSteps = 8;
    const double half = 0.5 * kLinerThickness;
    Profile rim;
    for (int step = kSteps; step >= 0; --step) {
        const double angle = std::numbers::pi * step / kSteps;
        const SinCos at = sin_cos(angle);
        const double open = step == kSteps ? -1 : at.cos;
        const double up = step == kSteps ? 0 : at.sin;
        rim.push_back({half * (1 - open), top - half + half * up, open, up, -half * angle});
    }
    const ProfilePosition inner{0, bottom};
    const ProfilePosition outer{kLinerThickness, bottom};
    return {straight_profile({0, top - half}, inner), straight_profile(inner, outer),
            straight_profile(outer, {kLinerThickness, top - half}), rim};
}

// Adds a thin plate to the liner that hides the rail, which is visible under the end of an undercut
// jaw.
void add_wing(SurfaceBuilder& builder, const SideFrame& side, double from, double to,
              const TableMeasures& measures) {
    const double front = measures.cushion_width - kWingProud;
    const PlanPath path = PathBuilder(OpenSide::left, kLongestStep)
                              .start(side.at(std::min(from, to), front))
                              .line_to(side.at(std::max(from, to), front))
                              .finish();
    const ProfilePosition top{0, 0.9 * measures.nose_height};
    const ProfilePosition foot{0, -0.5 * kSlateEdge};
    const ProfilePosition back_foot{kWingProud + kLinerThickness, foot.z};
    const ProfilePosition back_top{back_foot.inside, top.z};
    const std::vector<Profile> profiles{
        straight_profile(top, foot), straight_profile(foot, back_foot),
        straight_profile(back_foot, back_top), straight_profile(back_top, top)};
    for (const Profile& profile : profiles) {
        builder.sweep(path, profile);
    }
    const auto add_end = [&](const PathPoint& point, const Vec2& facing) {
        builder.add_polygon(profile_at(point, profiles), {facing.x, facing.y, 0});
    };
    add_end(path.front(), -side.along);
    add_end(path.back(), side.along);
}

}  // namespace

PlanPath circle_path(const Vec2& centre, double radius) {
    const Vec2 right = centre + Vec2(radius, 0);
    const Vec2 left = centre - Vec2(radius, 0);
    return PathBuilder(OpenSide::left, kLongestStep)
        .start(right)
        .arc_to(left, centre, true)
        .arc_to(right, centre, true)
        .finish_closed();
}

PocketOpening pocket_opening(const TableLayout& layout, const PocketLayout& pocket, double radius) {
    PocketOpening opening;
    for (std::size_t index = 0; index < 4; ++index) {
        const SideFrame& side = layout.sides[index];
        if (pocket.is_corner
                ? pocket.axis.dot(side.outward) > 0.5 && pocket.axis.dot(side.along) > 0.5
                : pocket.axis.dot(side.outward) > 0.5) {
            opening.first = &side;
            opening.last = pocket.is_corner ? &layout.sides[(index + 1) % 4] : &side;
        }
    }
    const Vec2 centre = pocket.pocket.centre;
    const double inner_edge = layout.measures.cushion_width;
    const auto on_circle = [&](const SideFrame& side, bool is_end) {
        const Vec2 cut = side.at(cut_in_rail(layout, pocket, side, is_end), inner_edge);
        return centre + radius * (cut - centre).normalized();
    };
    opening.enter = cut_in_rail(layout, pocket, *opening.first, false);
    opening.leave = cut_in_rail(layout, pocket, *opening.last, true);
    const Vec2 begin = on_circle(*opening.first, false);
    const Vec2 end = on_circle(*opening.last, true);
    opening.arc =
        PathBuilder(OpenSide::left, kLongestStep).start(begin).arc_to(end, centre, true).finish();
    return opening;
}

void add_wings(SurfaceBuilder& builder, const TableLayout& layout, const PocketOpening& opening) {
    add_wing(builder, *opening.first, opening.enter - kWingLength, opening.enter, layout.measures);
    add_wing(builder, *opening.last, opening.leave, opening.leave + kWingLength, layout.measures);
}

Surface build_pocket_liner(const TableLayout& layout, const PocketLayout& pocket) {
    SurfaceBuilder builder("pocket_liner_" + pocket.pocket.name, SurfacePart::pocket_liner);
    const Vec2 centre = pocket.pocket.centre;
    const double radius = pocket.pocket.radius - kLinerInset;

    // Below the cloth the liner is a full circle.
    const PlanPath circle = circle_path(centre, radius);
    for (const Profile& profile :
         wall_profile(-pocket.pocket.drop - kBelowFloor, -0.5 * kSlateEdge)) {
        builder.sweep(circle, profile);
    }

    // Above the cloth it exists only where the pocket is cut into wood.
    const PocketOpening opening = pocket_opening(layout, pocket, radius);
    add_wings(builder, layout, opening);
    const PlanPath& arc = opening.arc;
    const std::vector<Profile> wall =
        wall_profile(-0.6 * kSlateEdge, layout.measures.rail_height + kRimAboveRail);
    for (const Profile& profile : wall) {
        builder.sweep(arc, profile);
    }
    const auto add_end = [&](const PathPoint& point, double sign) {
        const Vec2 radial = (point.position - centre).normalized();
        builder.add_polygon(profile_at(point, wall), {sign * radial.y, -sign * radial.x, 0});
    };
    add_end(arc.front(), 1);
    add_end(arc.back(), -1);
    return std::move(builder).finish();
}

Surface build_pocket_floor(const PocketLayout& pocket) {
    SurfaceBuilder builder("pocket_floor_" + pocket.pocket.name, SurfacePart::pocket_floor);
    const Loop rim = inside_outline(circle_path(pocket.pocket.centre, pocket.pocket.radius), 0);
    builder.add_level(std::span(&rim, 1), -pocket.pocket.drop, true, kFloorSpacing);
    return std::move(builder).finish();
}

}  // namespace carom::sim::billiards
