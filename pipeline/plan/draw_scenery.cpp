// Draws static objects that are not part of the table: props, walls, lamps.
#include <algorithm>

#include "pipeline/plan/footprint.h"
#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/scene_outline.h"

namespace carom::pipeline {

namespace {

constexpr double kOverhead = 0.3;   // m: objects above this height are drawn as an outline
constexpr double kBeneath = -0.05;  // m: objects below this height are hidden by the table

struct Extent {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

    explicit Extent(const std::vector<Vec3>& points) {
        for (const Vec3& p : points) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    }
};

/// Floors and ceilings that extend over the whole plan are not drawn, nor are objects under the
/// table.
bool is_shown(const PlanDrawing& plan, const Extent& extent) {
    const bool covers_all = extent.low.x <= plan.sheet.low.x && extent.low.y <= plan.sheet.low.y &&
                            extent.high.x >= plan.sheet.high.x &&
                            extent.high.y >= plan.sheet.high.y;
    return !covers_all && extent.high.z > kBeneath;
}

void draw_static_object(PlanDrawing& plan, const render::ObjectDescription& object) {
    const std::vector<Vec3> points = outline_points(object);
    const Extent extent(points);
    if (points.empty() || !is_shown(plan, extent)) {
        return;
    }
    std::vector<Vec2> corners;
    corners.reserve(points.size());
    for (const Vec3& point : points) {
        corners.push_back(plan.sheet.at(point));
    }
    const bool hangs = extent.low.z > kOverhead;
    plan.svg.open("g");
    plan.svg.text("title", object.name + (hangs ? ", overhead" : ""));
    plan.svg.leaf("path", {{"class", hangs ? "overhead" : "prop"},
                           {"fill", paint_of_material(plan.shot, object.material).colour},
                           {"d", svg_path(convex_outline(std::move(corners)), true)}});
    plan.svg.close();
}

}  // namespace

void draw_scenery(PlanDrawing& plan) {
    plan.svg.open("g", {{"class", "scenery"}});
    for (const render::ObjectDescription& object : plan.shot.scene.objects) {
        if (object.track.empty() && !object.name.starts_with("table/")) {
            draw_static_object(plan, object);
        }
    }
    plan.svg.close();
}

}  // namespace carom::pipeline
