#include "pipeline/studio/shot_state.h"

#include <algorithm>
#include <variant>

#include <Imath/ImathMatrixAlgo.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/pocket_names.h"
#include "pipeline/studio/camera_paths.h"
#include "pipeline/studio/triple.h"
#include "pipeline/studio/value_places.h"
#include "sim/billiards/layout.h"
#include "sim/billiards/spots.h"
#include "sim/timeline/surface.h"

namespace carom::studio {

namespace {

Film film_message(const pipeline::Shot& shot) {
    Film film;
    film.width = shot.render.width;
    film.height = shot.render.height;
    film.fps = shot.timing.fps.to_double();
    film.frames = pipeline::frame_count(shot.cameras, shot.timing);
    film.duration = static_cast<double>(film.frames) / film.fps;
    film.samples = shot.render.samples;
    return film;
}

std::array<double, 2> pair(const Vec2& v) {
    return {v.x, v.y};
}

/// By how much the rounding at a jaw shortens the nose.
double lip_length(const std::optional<sim::billiards::Jaw>& jaw) {
    return jaw ? jaw->lip_tangent_length : 0;
}

std::optional<Table> table_message(const pipeline::Shot& shot,
                                   const std::vector<SceneObject>& objects) {
    const auto& table = shot.world.table;
    if (!table || !table->has_cushions) {
        return std::nullopt;
    }
    const auto ball = std::ranges::find(objects, "ball", &SceneObject::kind);
    return Table{table->length, table->width, table->nose_height,
                 ball == objects.end() ? sim::Sphere{}.radius : ball->radius};
}

/// The cushions and pockets of the table.
void add_plan(const sim::billiards::TableMeasures& table, ShotState& state) {
    const auto layout = sim::billiards::make_layout(table, state.table->ball_radius);
    for (const sim::billiards::CushionLayout& cushion : layout.cushions) {
        const double from = cushion.from + lip_length(cushion.jaw_from);
        const double to = cushion.to - lip_length(cushion.jaw_to);
        state.noses.push_back({pair(cushion.side.at(from, layout.nose_inset)),
                               pair(cushion.side.at(to, layout.nose_inset))});
    }
    for (const sim::billiards::PocketLayout& pocket : layout.pockets) {
        state.pockets.push_back(
            {pocket.pocket.name, pair(pocket.pocket.centre), pocket.pocket.radius});
    }
}

Names names_of(const pipeline::Shot& shot, const std::vector<SceneObject>& objects) {
    Names names;
    for (const SceneObject& object : objects) {
        if (object.kind != "table") {
            (object.kind == "ball" ? names.balls : names.objects).push_back(object.name);
        }
    }
    for (const render::MaterialDescription& material : shot.scene.materials) {
        names.materials.push_back(material.name);
    }
    for (const render::LightDescription& light : shot.scene.lights) {
        names.lights.push_back(light.name);
    }
    for (const pipeline::CameraRig& camera : shot.cameras) {
        names.cameras.push_back(camera.name);
    }
    names.surfaces.assign(sim::surface_names().begin(), sim::surface_names().end());
    if (shot.world.table) {
        for (const auto& spot : sim::billiards::spots_of(*shot.world.table)) {
            names.spots.push_back(spot.name);
        }
        names.pockets = pipeline::config::pocket_names(*shot.world.table);
        for (std::string& name : pipeline::config::players_pocket_names(*shot.world.table)) {
            names.pockets.push_back(std::move(name));
        }
    }
    return names;
}

/// The colour with its largest component 1.
Triple hue_of(const Vec3& colour) {
    const double largest = std::max({colour.x, colour.y, colour.z});
    return largest > 0 ? triple(colour / largest) : Triple{0, 0, 0};
}

/// The rotation from the world's axes to those of a light with two edges.
Turn orientation_of(const Vec3& edge_u, const Vec3& normal) {
    const Vec3 u = edge_u.normalized();
    const Vec3 v = normal.cross(u);
    const Vec3& n = normal;
    const Imath::M44d rows(u.x, u.y, u.z, 0, v.x, v.y, v.z, 0, n.x, n.y, n.z, 0, 0, 0, 0, 1);
    const Quat turn = Imath::extractQuat(rows).normalized();
    return {turn.r, turn.v.x, turn.v.y, turn.v.z};
}

/// What the page draws: whatever the description has of a light's usual parts. A kind for which the
/// page has no figure is shown as a dot at its place.
template <class Light>
void fill(const Light& light, SceneLight& message) {
    message.kind = Light::kKind;
    if constexpr (requires { light.centre; }) {
        message.position = triple(light.centre);
    } else if constexpr (requires { light.position; }) {
        message.position = triple(light.position);
    }
    if constexpr (requires { light.normal; }) {
        message.facing = triple(light.normal);
    } else if constexpr (requires { light.direction; }) {
        message.facing = triple(light.direction.normalized());
    }
    if constexpr (requires { light.radiance; }) {
        message.colour = hue_of(light.radiance);
    } else if constexpr (requires { light.intensity; }) {
        message.colour = hue_of(light.intensity);
    } else {
        message.colour = hue_of(light.irradiance);
    }
    if constexpr (requires { light.edge_u; }) {
        message.orientation = orientation_of(light.edge_u, light.normal);
        message.size = {2 * light.edge_u.length(), 2 * light.edge_v.length()};
    } else if constexpr (requires { light.radius; }) {
        message.size = {light.radius};
    } else if constexpr (requires { light.shape.radius; }) {
        message.size = {light.shape.radius};
    } else if constexpr (requires { light.inner_angle; }) {
        message.size = {light.inner_angle, light.outer_angle};
    }
}

}  // namespace

std::vector<SceneLight> light_messages(const pipeline::Shot& shot) {
    std::vector<SceneLight> messages;
    for (const render::LightDescription& light : shot.scene.lights) {
        SceneLight message;
        message.name = light.name;
        message.path = {"lights", light.name};
        std::visit([&](const auto& described) { fill(described, message); }, light.light);
        messages.push_back(std::move(message));
    }
    return messages;
}

ShotState shot_state(const pipeline::Shot& shot, const pipeline::ShotSource& source,
                     const sim::Timeline& timeline, const std::string& root) {
    ShotState state;
    state.name = shot.name;
    state.film = film_message(shot);
    state.objects = object_messages(shot, source, timeline);
    state.table = table_message(shot, state.objects);
    if (state.table) {
        add_plan(*shot.world.table, state);
    }
    state.lights = light_messages(shot);
    state.cameras = camera_messages(shot, source, timeline);
    state.events = event_messages(shot, timeline);
    state.annotations = annotation_messages(shot, timeline);
    state.names = names_of(shot, state.objects);
    state.places = value_places(source, root);
    return state;
}

}  // namespace carom::studio
