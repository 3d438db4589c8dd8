#include "pipeline/sound/film_scene.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <variant>

#include "pipeline/video/sound_length.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/polyhedron.h"
#include "sound/source/defaults.h"

namespace carom::pipeline {
namespace {

constexpr double kFloorBelowBed = 0.8;  // m, of a table whose height is not known

using SoundShape = decltype(sound::SoundBody::shape);

struct ShapeOf {
    SoundShape operator()(const sim::Sphere& sphere) const {
        return sound::BallShape{sphere.radius};
    }
    SoundShape operator()(const sim::Box& box) const { return sound::BoxShape{box.size}; }
    SoundShape operator()(const sim::Capsule& capsule) const {
        return sound::OtherShape{sim::capsule_volume(capsule.radius, capsule.length)};
    }
    SoundShape operator()(const sim::Cylinder& cylinder) const {
        return sound::OtherShape{sim::cylinder_volume(cylinder.radius, cylinder.height)};
    }
    SoundShape operator()(const sim::ConvexHull& hull) const {
        const auto solid = sim::convex_hull(hull.points);
        return sound::OtherShape{solid ? sim::mass_properties(*solid).volume
                                       : sound::OtherShape{}.volume};
    }
    /// It never moves, so it makes no sound of its own.
    SoundShape operator()(const sim::TriangleMesh& /*mesh*/) const { return sound::OtherShape{}; }
};

void change(const SoundSettings& settings, std::string_view name, sound::Material& material) {
    for (const SoundMaterial& own : settings.materials) {
        if (own.name == name) {
            material.modulus = own.modulus.value_or(material.modulus);
            material.poisson = own.poisson.value_or(material.poisson);
            material.loss = own.loss.value_or(material.loss);
        }
    }
}

void change(const SoundSettings& settings, std::string_view name, sound::Resonator& resonator) {
    for (const SoundMaterial& own : settings.materials) {
        if (own.name == name) {
            resonator.contact = own.contact.value_or(resonator.contact);
            resonator.modes = own.modes.value_or(resonator.modes);
        }
    }
}

sound::SoundBody body_of(const sim::Body& body, const SoundSettings& settings,
                         const sim::ContactLaw& law) {
    sound::SoundBody result;
    result.name = body.name;
    result.shape = std::visit(ShapeOf{}, body.shape);
    result.mass =
        body.kind == sim::BodyKind::dynamic ? body.mass : std::numeric_limits<double>::infinity();
    result.material = sound::default_material(body.material);
    if (body.material == "ball") {
        result.material.restitution = law.ball_ball.restitution;
    }
    change(settings, body.material, result.material);
    result.position = body.pose.position;
    return result;
}

/// The mass of the shot's first ball.
double ball_mass(const sim::WorldDescription& world) {
    for (const sim::Body& body : world.bodies) {
        if (std::holds_alternative<sim::Sphere>(body.shape) && body.material == "ball") {
            return body.mass;
        }
    }
    return sim::Body{}.mass;
}

sound::Resonators resonators_of(const sim::WorldDescription& world, const SoundSettings& settings) {
    sound::Resonators resonators = sound::default_resonators(ball_mass(world));
    change(settings, "cushion", resonators.cushion);
    change(settings, "cloth", resonators.bed);
    change(settings, "tip", resonators.stick);
    change(settings, "pocket", resonators.pocket);
    change(settings, "wood", resonators.wood);
    return resonators;
}

}  // namespace

sound::SoundShot sound_shot(const Shot& shot, const sim::Timeline& timeline,
                            const ShownPart& part) {
    sound::SoundShot result;
    result.timeline = &timeline;
    const sim::WorldDescription& world = shot.world;
    for (const sim::Body& body : world.bodies) {
        result.bodies.push_back(body_of(body, shot.sound, world.contact_law));
    }
    result.has_bed = world.table.has_value();
    result.bed_reflection = shot.sound.bed_reflection;
    result.resonators = resonators_of(world, shot.sound);
    result.room = shot.sound.room;
    result.room.floor_centre.z =
        world.floor_height.value_or(result.has_bed ? -kFloorBelowBed : 0.0);
    if (!shot.sound.is_silent) {
        const double aspect = static_cast<double>(shot.render.width) / shot.render.height;
        result.clips = clips_of(shot.cameras, timeline, shot.sound, aspect, part);
    }
    return result;
}

sound::SoundScene film_scene(const Shot& shot, const sim::Timeline& timeline, std::int64_t first,
                             std::int64_t frames) {
    const Rational& fps = shot.timing.fps;
    const auto time = [&](std::int64_t frame) { return (Rational(frame) / fps).to_double(); };
    sound::SoundScene scene;
    scene.shots.push_back(sound_shot(shot, timeline, ShownPart{time(first), time(first + frames)}));
    scene.frames = first_sample(frames, fps);
    if (!shot.sound.is_silent) {
        scene.full_scale = shot.sound.full_scale;
        scene.loudness = shot.sound.loudness;
    }
    return scene;
}

}  // namespace carom::pipeline
