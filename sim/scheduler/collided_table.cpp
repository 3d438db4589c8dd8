#include "sim/scheduler/collided_table.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "core/lru_cache.h"

namespace carom::sim {
namespace {

// Pockets are lined with polygons with 96 corners on their circle. Balls fall over the circle
// inside that polygon (cos(pi / 96), a fortieth of a millimetre less), so that they do not hit its
// edge first.
constexpr double kInsideOfPolygon = 0.99946;

constexpr std::size_t kMaxKept = 4;

/// Material of a surface that balls in the air can hit; empty for others. The cloth itself is a
/// plane with holes.
std::optional<std::string> material_of(billiards::SurfacePart part) {
    switch (part) {
        case billiards::SurfacePart::cushion:
            return "cushion";
        case billiards::SurfacePart::rail:
            return "rail";
        case billiards::SurfacePart::pocket_liner:
        case billiards::SurfacePart::pocket_floor:
            return "pocket";
        default:  // only drawn
            break;
    }
    return std::nullopt;
}

CollidedTable build(const billiards::TableMeasures& measures, double ball_radius) {
    CollidedTable table;
    table.geometry = billiards::build_table(measures, ball_radius);
    for (std::size_t i = 0; i < table.geometry.surfaces.size(); ++i) {
        const billiards::Surface& surface = table.geometry.surfaces[i];
        const auto material = material_of(surface.part);
        if (material && !surface.triangles.empty()) {
            table.mesh.add(surface.vertices, surface.triangles,
                           static_cast<std::uint32_t>(table.parts.size()));
            table.parts.push_back({*material, i});
        }
    }
    for (billiards::Pocket& pocket : table.geometry.pockets) {
        pocket.radius *= kInsideOfPolygon;
        table.pocket_edges.push_back({Vec3(pocket.centre.x, pocket.centre.y, 0), pocket.radius});
    }
    return table;
}

}  // namespace

std::shared_ptr<const CollidedTable> collided_table(const billiards::TableMeasures& measures,
                                                    double ball_radius) {
    static LruCache<std::pair<billiards::TableMeasures, double>, CollidedTable> kept(kMaxKept);
    return kept.get({measures, ball_radius}, [&] { return build(measures, ball_radius); });
}

}  // namespace carom::sim
