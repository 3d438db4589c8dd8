#include "sim/billiards/table.h"

#include <fmt/core.h>

#include "core/error.h"
#include "sim/billiards/parts.h"

namespace carom::sim::billiards {

TableGeometry build_table(const TableMeasures& measures, double ball_radius) {
    require_no_problems(measures);
    TableGeometry geometry;
    if (!measures.has_cushions) {
        return geometry;
    }
    const TableLayout layout = make_layout(measures, ball_radius);
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
    return geometry;
}

void require_no_problems(const TableMeasures& measures) {
    if (const auto problems = find_problems(measures); !problems.empty()) {
        throw Error(problems.front().sentence);
    }
}

}  // namespace carom::sim::billiards
