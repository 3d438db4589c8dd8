#include "sim/billiards/drawn/drawn_parts.h"
#include "sim/billiards/drawn/profiles.h"
#include "sim/billiards/parts.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

constexpr double kUnderRail = 0.012;  // at least this far inside the rails' outer edge, m
constexpr double kBedSpacing = 0.15;  // m
// Billiard Congress of America, Equipment Specifications: the slate's edge is rounded with 1/8 to
// 1/4 in. The rounding is outside of the hole's radius, over whose edge balls fall.
constexpr double kRimRadius = 0.0047625;

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

/// As the bed's, the texture's coordinates are the world's x and y.
void sweep_rim(SurfaceBuilder& builder, const PlanPath& hole, const Profile& profile) {
    std::vector<std::vector<SurfaceVertex>> rows;
    for (const ProfilePoint& point : profile) {
        rows.push_back(row_along(hole, point, [](const PathPoint&, SurfaceVertex& vertex) {
            vertex.uv = {vertex.position.x, vertex.position.y};
        }));
    }
    builder.add_grid(rows);
}

}  // namespace

Surface draw_bed(const TableLayout& layout) {
    SurfaceBuilder builder("cloth", SurfacePart::cloth);
    // The square corners of the cloth stay inside the rounded corners of the rails.
    const double under_rail = kUnderRail + 0.3 * outer_corner_radius(layout);
    std::vector<Loop> loops{rectangle(layout.outer - Vec2(under_rail), kBedSpacing)};
    for (const PocketLayout& pocket : layout.pockets) {
        const PlanPath hole = circle_path(pocket.pocket.centre, pocket.pocket.radius);
        loops.push_back(inside_outline(hole, kRimRadius));
        sweep_rim(builder, hole, thinned(round_profile({0, -kRimRadius}, {kRimRadius, 0})));
        sweep_rim(builder, hole, straight_profile({0, -kRimRadius}, {0, -kSlateEdge}));
    }
    builder.add_level(loops, 0, true, kBedSpacing);
    return std::move(builder).finish();
}

Surface draw_open_cloth(const TableMeasures& measures) {
    SurfaceBuilder builder("cloth", SurfacePart::cloth);
    const double spacing = 0.1 * measures.length;
    const Loop loop = rectangle({0.5 * measures.length, 0.5 * measures.width}, spacing);
    builder.add_level(std::span(&loop, 1), 0, true, spacing);
    return std::move(builder).finish();
}

}  // namespace carom::sim::billiards
