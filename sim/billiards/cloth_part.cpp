#include "sim/billiards/parts.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

constexpr double kUnderRail = 0.012;  // at least this far inside the rails' outer edge, m
constexpr double kBedSpacing = 0.1;   // m

Loop rectangle(const Vec2& half, double spacing) {
    const PlanPath path = PathBuilder(OpenSide::right, spacing)
                              .start({0, -half.y})
                              .line_to({half.x, -half.y})
                              .line_to({half.x, half.y})
                              .line_to({-half.x, half.y})
                              .line_to({-half.x, -half.y})
                              .finish_closed();
    return inside_outline(path, 0);
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

Surface build_cloth(const TableLayout& layout) {
    SurfaceBuilder builder("cloth", SurfacePart::cloth);
    // The square corners of the cloth stay inside the rounded corners of the rails.
    const double under_rail = kUnderRail + 0.3 * outer_corner_radius(layout);
    std::vector<Loop> loops{rectangle(layout.outer - Vec2(under_rail), kBedSpacing)};
    for (const PocketLayout& pocket : layout.pockets) {
        const PlanPath hole = circle_path(pocket.pocket.centre, pocket.pocket.radius);
        loops.push_back(inside_outline(hole, 0));
        builder.sweep(hole, straight_profile({0, 0}, {0, -kSlateEdge}));
    }
    builder.add_level(loops, 0, true, kBedSpacing);
    return std::move(builder).finish();
}

Surface build_open_cloth(const TableMeasures& measures) {
    SurfaceBuilder builder("cloth", SurfacePart::cloth);
    const double spacing = 0.1 * measures.length;
    const Loop loop = rectangle({0.5 * measures.length, 0.5 * measures.width}, spacing);
    builder.add_level(std::span(&loop, 1), 0, true, spacing);
    return std::move(builder).finish();
}

}  // namespace carom::sim::billiards
