#include "sim/billiards/drawn/drawn_table.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <utility>

#include "sim/billiards/drawn/drawn_parts.h"
#include "sim/billiards/parts.h"

namespace carom::sim::billiards {

namespace {

/// Removes triangles that are too thin to be seen: of sharp corners, and where pieces fold.
void remove_slivers(Surface& surface) {
    constexpr double kThinnest = 5e-6;  // m
    std::erase_if(surface.triangles, [&](const std::array<std::uint32_t, 3>& triangle) {
        const Vec3& a = surface.vertices[triangle[0]];
        const Vec3& b = surface.vertices[triangle[1]];
        const Vec3& c = surface.vertices[triangle[2]];
        const double longest2 = std::max({(b - a).length2(), (c - b).length2(), (a - c).length2()});
        return (b - a).cross(c - a).length2() < kThinnest * kThinnest * longest2;
    });
}

}  // namespace

std::vector<Surface> draw_table(const TableMeasures& measures, double ball_radius) {
    require_no_problems(measures);
    std::vector<Surface> surfaces;
    if (!measures.has_cushions) {
        surfaces.push_back(draw_open_cloth(measures));
        return surfaces;
    }
    const TableLayout layout = make_layout(measures, ball_radius);
    surfaces.push_back(draw_bed(layout));
    const auto append = [&](std::vector<Surface> parts) {
        std::ranges::move(parts, std::back_inserter(surfaces));
    };
    append(draw_marks(layout));
    append(draw_cushions(layout));
    append(draw_rails(layout).surfaces);
    for (const PocketLayout& pocket : layout.pockets) {
        draw_pocket(layout, pocket, surfaces);
    }
    append(draw_apron(layout));
    append(draw_legs(layout));
    if (std::optional<Surface> plate = draw_name_plate(layout)) {
        surfaces.push_back(std::move(*plate));
    }
    std::ranges::for_each(surfaces, remove_slivers);
    return surfaces;
}

}  // namespace carom::sim::billiards
