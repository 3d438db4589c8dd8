#include "sim/billiards/table.h"

#include <fmt/core.h>

#include "core/error.h"
#include "sim/billiards/parts.h"

namespace carom::sim::billiards {

TableGeometry build_table(const TableMeasures& measures, double ball_radius, TableParts parts) {
    if (const auto problems = find_problems(measures); !problems.empty()) {
        throw Error(problems.front().sentence);
    }
    TableGeometry geometry;
    const bool all = parts == TableParts::all;
    if (!measures.has_cushions) {
        if (all) {
            geometry.surfaces.push_back(build_open_cloth(measures));
        }
        return geometry;
    }
    const TableLayout layout = make_layout(measures, ball_radius);
    if (all) {
        geometry.surfaces.push_back(build_cloth(layout));
    }
    int number = 0;
    for (const CushionLayout& cushion : layout.cushions) {
        add_faces(cushion, measures.cushion_width, geometry);
        geometry.surfaces.push_back(
            build_cushion(layout, cushion, fmt::format("cushion_{}", ++number)));
    }
    for (Surface& rail : build_rails(layout)) {
        geometry.surfaces.push_back(std::move(rail));
    }
    for (const PocketLayout& pocket : layout.pockets) {
        geometry.pockets.push_back(pocket.pocket);
        geometry.surfaces.push_back(build_pocket_liner(layout, pocket));
        geometry.surfaces.push_back(build_pocket_floor(pocket));
    }
    if (!all) {
        return geometry;
    }
    geometry.surfaces.push_back(build_apron(layout));
    for (Surface& leg : build_legs(layout)) {
        geometry.surfaces.push_back(std::move(leg));
    }
    if (std::optional<Surface> sights = build_sights(layout)) {
        geometry.surfaces.push_back(std::move(*sights));
    }
    return geometry;
}

}  // namespace carom::sim::billiards
