#include "pipeline/picture/lit_annotations.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "pipeline/picture/build_shapes.h"
#include "pipeline/picture/colours.h"
#include "pipeline/picture/contact.h"
#include "pipeline/picture/dashes.h"
#include "pipeline/picture/tube_mesh.h"

namespace carom::pipeline {
namespace {

constexpr double kBrightest = 0.85;  // albedo of a colour whose largest channel is 1

/// From above, for shapes that also have texts beside their lines.
Pinhole view_from_above() {
    PlannedFrame frame;
    frame.camera_open.position = {0, 0, 3};
    frame.camera_open.target = {0, 0, 0};
    frame.camera_open.up = {0, 1, 0};
    frame.camera_close = frame.camera_open;
    return {frame, 640, 360};
}

/// The tubes of one annotation.
class Tubes {
  public:
    explicit Tubes(double diameter) : radius_(0.5 * diameter) {}

    void add(const SceneLine& line) {
        colour_ = line.colour;
        StrongLine points;
        for (const Vec3& point : line.points) {
            points.push_back({raised(point)});
        }
        if (line.is_closed && line.dash == Dash::solid) {
            add_tube(positions(points), true, radius_, mesh_);
            return;
        }
        if (line.is_closed && !points.empty()) {
            points.push_back(points.front());
        }
        for (const StrongLine& piece : cut_into_dashes(points, line.dash, line.dash_size)) {
            add_tube(positions(piece), false, radius_, mesh_);
        }
    }
    void add(const SceneDot& dot) {
        constexpr double kOfLine = 2;  // diameters
        colour_ = dot.colour;
        add_ball(raised(dot.at), kOfLine * radius_, mesh_);
    }
    void add(const SceneArea& /*area*/) {}  // its edge is a line
    void add(const SceneText& /*text*/) {}  // is drawn on the picture

    [[nodiscard]] const Vec3& colour() const { return colour_; }
    [[nodiscard]] render::MeshShape take_mesh() { return std::move(mesh_); }

  private:
    [[nodiscard]] Vec3 raised(Vec3 point) const {
        point.z = std::max(point.z, radius_);
        return point;
    }
    static std::vector<Vec3> positions(const StrongLine& line) {
        std::vector<Vec3> result;
        for (const StrongPoint& point : line) {
            result.push_back(point.at);
        }
        return result;
    }

    double radius_;
    Vec3 colour_{1, 1, 1};
    render::MeshShape mesh_;
};

/// Three circles of the ghost ball, at right angles to each other.
SceneShapes circles_of(const GhostAnnotation& ghost, const Annotation& look,
                       const SceneMoment& moment) {
    const std::optional<Contact> contact = first_contact(moment.timeline, ghost.of, ghost.on);
    SceneShapes shapes;
    for (int axis = 0; contact && axis < 3; ++axis) {
        Vec3 normal(0, 0, 0);
        Vec3 start(0, 0, 0);
        normal[axis] = 1;
        start[(axis + 1) % 3] = moment.radius(ghost.of);
        SceneLine circle;
        circle.points = arc_points(contact->centre, start, normal, 2 * std::numbers::pi);
        circle.points.pop_back();
        circle.is_closed = true;
        circle.colour = look.colour.value_or(aim_colour());
        circle.dash = look.dash.value_or(Dash::solid);
        shapes.emplace_back(std::move(circle));
    }
    return shapes;
}

SceneShapes shapes_in_scene(const Annotation& annotation, const SceneMoment& moment) {
    const auto* ghost = std::get_if<GhostAnnotation>(&annotation.kind);
    return ghost != nullptr ? circles_of(*ghost, annotation, moment)
                            : shapes_of(annotation, moment);
}

void add_object(const std::string& name, Tubes& tubes, render::SceneDescription& scene) {
    render::MeshShape mesh = tubes.take_mesh();
    if (mesh.triangles.empty()) {
        return;
    }
    render::MaterialDescription material;
    material.name = name;
    material.surface.base = kBrightest * tubes.colour();
    scene.materials.push_back(std::move(material));
    render::ObjectDescription object;
    object.name = name;
    object.shape = std::move(mesh);
    object.material = name;
    scene.objects.push_back(std::move(object));
}

bool has_object(const render::SceneDescription& scene, const std::string& name) {
    return std::ranges::any_of(scene.objects,
                               [&](const auto& object) { return object.name == name; });
}

}  // namespace

void add_lit_annotations(Shot& shot, const sim::Timeline& timeline) {
    const Pinhole view = view_from_above();
    SceneMoment moment{shot, timeline, view, {}, timeline.end_time, 0, 1};
    for (std::size_t i = 0; i < shot.annotations.size(); ++i) {
        const Annotation& annotation = shot.annotations[i];
        const std::string name = fmt::format("annotations[{}]", i);
        if (annotation.lit > 0 && !has_object(shot.scene, name)) {
            Tubes tubes(annotation.lit);
            for (const SceneShape& shape : shapes_in_scene(annotation, moment)) {
                std::visit([&](const auto& one) { tubes.add(one); }, shape);
            }
            add_object(name, tubes, shot.scene);
        }
        moment.path_index += std::holds_alternative<PathAnnotation>(annotation.kind) ? 1 : 0;
    }
}

}  // namespace carom::pipeline
