#include <array>
#include <cmath>

#include "pipeline/plan/camera_ruler.h"
#include "pipeline/plan/footprint.h"
#include "pipeline/plan/plan_drawing.h"

namespace carom::pipeline {

namespace {

constexpr double kText = 2.4;
constexpr double kBold = 1.15;  // width of bold letters relative to regular ones

/// The outline, seen from above, of the camera's view pyramid up to the target or the cloth,
/// whichever is nearer.
std::vector<Vec2> view_cone(const render::CameraState& camera, double aspect) {
    const Vec3 ahead = (camera.target - camera.position).normalized();
    const double reach = (camera.target - camera.position).length();
    Vec3 right = ahead.cross(camera.up).normalized();
    Vec3 up = right.cross(ahead);
    const Vec3 turned = std::cos(camera.roll) * right + std::sin(camera.roll) * up;
    up = std::cos(camera.roll) * up - std::sin(camera.roll) * right;
    right = turned;
    const double half = std::tan(camera.vertical_fov / 2);
    std::vector<Vec2> points{{camera.position.x, camera.position.y}};
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            const Vec3 ray = ahead + half * (x * aspect * right + y * up);
            double length = reach;
            if (ray.z < 0 && camera.position.z > 0) {
                length = std::min(length, camera.position.z / -ray.z);
            }
            const Vec3 end = camera.position + length * ray;
            points.emplace_back(end.x, end.y);
        }
    }
    return convex_outline(std::move(points));
}

void draw_cone(PlanDrawing& plan, const PlanRig& rig, const render::CameraState& state) {
    const double aspect =
        static_cast<double>(plan.shot.render.width) / static_cast<double>(plan.shot.render.height);
    std::vector<Vec2> outline;
    for (const Vec2& point : view_cone(state, aspect)) {
        outline.push_back(plan.sheet.at(point));
    }
    plan.svg.leaf("path", {{"class", "cone"},
                           {"fill", rig.colour},
                           {"stroke", rig.colour},
                           {"d", svg_path(outline, true)}});
}

/// Draws the path with a dot at its start and, if the camera moves, an arrowhead at its end.
void draw_camera_path(PlanDrawing& plan, const PlanRig& rig) {
    std::vector<Vec2> path;
    for (const render::CameraState& state : rig.states) {
        path.push_back(plan.sheet.at(state.position));
    }
    plan.svg.leaf("path", {{"class", "way"}, {"stroke", rig.colour}, {"d", svg_path(path, false)}});
    plan.svg.leaf("circle", {{"cx", svg_number(path.front().x)},
                             {"cy", svg_number(path.front().y)},
                             {"r", "0.95"},
                             {"fill", rig.colour}});
    const Vec2 last = path.back() - path[path.size() - 2];
    if (last.length() > 0.02) {
        const Vec2 on = last.normalized();
        const Vec2 across(-on.y, on.x);
        plan.svg.leaf("path", {{"fill", rig.colour},
                               {"d", svg_path({path.back() + 1.3 * on, path.back() - on + across,
                                               path.back() - on - across},
                                              true)}});
    }
    for (const Vec2& point : path) {
        plan.labels.keep_free({point - Vec2(0.6), point + Vec2(0.6)}, 0.5);
    }
}

}  // namespace

void draw_cameras(PlanDrawing& plan) {
    plan.svg.open("g", {{"id", "cameras"}});
    const std::optional<CameraRuler> ruler = camera_ruler(plan);
    for (const PlanRig& rig : plan.rigs) {
        plan.svg.open("g");
        plan.svg.text("title", "camera " + rig.rig->name);
        draw_cone(plan, rig, rig.states.front());
        draw_cone(plan, rig, rig.states.back());
        draw_camera_path(plan, rig);
        if (ruler) {
            draw_ruler(plan, rig, *ruler);
        }
        plan.svg.close();
    }
    for (const PlanRig& rig : plan.rigs) {
        const Vec2 size(kBold * text_width(rig.rig->name, kText), 3);
        const Vec2 corner =
            plan.labels.place(plan.sheet.at(rig.states.front().position), size, 1.5);
        plan.svg.text("text", rig.rig->name,
                      {{"x", svg_number(corner.x)},
                       {"y", svg_number(corner.y + 2.3)},
                       {"style", "font-weight:bold;font-size:2.4px;fill:" + rig.colour}});
    }
    plan.svg.close();
}

}  // namespace carom::pipeline
