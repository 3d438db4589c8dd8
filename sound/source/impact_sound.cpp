#include "sound/source/impact_sound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/elementary.h"
#include "sound/source/contact.h"
#include "sound/source/mode_sound.h"

namespace carom::sound {
namespace {

// Boxes touch with an edge, rounded by this radius, which moves like a third of the box's mass (a
// bar that is hit at its end has a quarter, one that is hit at its edge in the middle all of it).
constexpr double kEdgeRadius = 0.004;  // m
constexpr double kEdgeMass = 1.0 / 3;

constexpr double kBoxOnClothModes = 0.5;  // how much of its modes a box on cloth has

double sphere_radius(double volume) {
    return power(3 * volume / (4 * std::numbers::pi), 1.0 / 3);
}

/// The radius of the ball, or of the sphere with the same volume, m.
double radius_of(const SoundBody& body) {
    if (const auto* ball = std::get_if<BallShape>(&body.shape)) {
        return ball->radius;
    }
    if (const auto* box = std::get_if<BoxShape>(&body.shape)) {
        return sphere_radius(box->size.x * box->size.y * box->size.z);
    }
    return sphere_radius(std::get<OtherShape>(body.shape).volume);
}

bool is_ball(const SoundBody& body) {
    return std::holds_alternative<BallShape>(body.shape);
}

bool is_box(const SoundBody& body) {
    return std::holds_alternative<BoxShape>(body.shape);
}

/// `v` in the axes of a body with this orientation.
Vec3 to_body(const Quat& orientation, const Vec3& v) {
    const Vec3 axis = -orientation.v;
    const Vec3 t = axis.cross(v) * 2;
    return v + t * orientation.r + axis.cross(t);
}

double contact_mass(const SoundBody& body) {
    return is_box(body) ? body.mass * kEdgeMass : body.mass;
}

/// Two boxes touch with an edge on a face; a box is flat where anything else touches it.
double reduced_radius(const SoundBody& a, const SoundBody& b) {
    if (is_box(a) && is_box(b)) {
        return kEdgeRadius;
    }
    constexpr double kFlat = std::numeric_limits<double>::infinity();
    return reduced(is_box(a) ? kFlat : radius_of(a), is_box(b) ? kFlat : radius_of(b));
}

double pair_contact_time(const SoundBody& a, const SoundBody& b, double impulse) {
    const ContactPair pair{reduced(contact_mass(a), contact_mass(b)), reduced_radius(a, b),
                           reduced_modulus(a.material, b.material),
                           (a.material.restitution + b.material.restitution) / 2};
    return hertz_contact_time(pair, impulse);
}

void append(const std::vector<Mode>& modes, std::vector<Mode>& all) {
    all.insert(all.end(), modes.begin(), modes.end());
}

}  // namespace

ImpactSounds::ImpactSounds(const SoundShot& shot) : shot_(shot) {
    for (const SoundBody& body : shot.bodies) {
        entries_.emplace(body.name, Entry{&body, shot.timeline->find(body.name)});
    }
}

const ImpactSounds::Entry* ImpactSounds::entry(std::string_view name) const {
    const auto found = entries_.find(name);
    return found == entries_.end() ? nullptr : &found->second;
}

double ImpactSounds::longest_decay() const {
    double longest = 0;
    const auto include = [&longest](const std::vector<Mode>& modes) {
        for (const Mode& mode : modes) {
            longest = std::max(longest, -1 / mode_pole(mode).re);
        }
    };
    const Resonators& s = shot_.resonators;
    for (const Resonator* resonator :
         {&s.cushion, &s.bed, &s.stick, &s.pocket, &s.wood, &s.box_on_cloth}) {
        include(resonator->modes);
    }
    for (const SoundBody& body : shot_.bodies) {
        const auto* box = std::get_if<BoxShape>(&body.shape);
        if (box != nullptr && !std::isinf(body.mass)) {
            include(box_modes(box->size, body.mass, body.material, {1, 1, 1}));
        }
    }
    return longest;
}

std::optional<ImpactSound> ImpactSounds::sound_of(const sim::Event& event) const {
    if (event.kind == sim::EventKind::strike) {
        return of_strike(event);
    }
    if (event.kind != sim::EventKind::impact || !(event.normal_impulse > 0)) {
        return std::nullopt;
    }
    const Entry* a = entry(event.a);
    const Entry* b = entry(event.b);
    if (a == nullptr ||
        (std::isinf(a->body->mass) && (b == nullptr || std::isinf(b->body->mass)))) {
        return std::nullopt;
    }
    return b == nullptr ? of_surface(event, *a) : of_bodies(event, *a, *b);
}

/// The place of a strike is the ball's centre. A log that was made by hand may lack the impulse.
std::optional<ImpactSound> ImpactSounds::of_strike(const sim::Event& event) const {
    const Entry* struck = entry(event.a);
    const double speed = event.vector.length();
    if (struck == nullptr || !(speed > 0)) {
        return std::nullopt;
    }
    const double radius = radius_of(*struck->body);
    ImpactSound sound;
    sound.group = Group::stick;
    sound.place = event.place - event.vector * (radius / speed);
    sound.impulse = event.normal_impulse > 0 ? event.normal_impulse : struck->body->mass * speed;
    sound.contact_time =
        resonator_contact_time(shot_.resonators.stick, struck->body->mass, sound.impulse);
    sound.shape = PulseShape::soft;
    add_sphere(event.place, radius, event.vector, sound);
    append(shot_.resonators.stick.modes, sound.modes);
    return sound;
}

ImpactSound ImpactSounds::of_bodies(const sim::Event& event, const Entry& a, const Entry& b) const {
    ImpactSound sound;
    sound.group = is_ball(*a.body) && is_ball(*b.body) ? Group::balls : Group::objects;
    sound.place = event.place;
    sound.impulse = event.normal_impulse;
    sound.contact_time = pair_contact_time(*a.body, *b.body, event.normal_impulse);
    add_body(a, event, 1, 1, sound);
    add_body(b, event, -1, 1, sound);
    return sound;
}

ImpactSound ImpactSounds::of_surface(const sim::Event& event, const Entry& body) const {
    const Resonators& resonators = shot_.resonators;
    ImpactSound sound;
    const Resonator* resonator = &resonators.wood;
    double mode_factor = 1;
    const sim::Surface surface = event.surface();
    if (surface == sim::Surface::cushion) {
        resonator = &resonators.cushion;
        sound.group = Group::cushions;
    } else if (surface == sim::Surface::cloth) {
        resonator = is_ball(*body.body) ? &resonators.bed : &resonators.box_on_cloth;
        sound.group = Group::cloth;
        mode_factor = kBoxOnClothModes;
    } else if (surface == sim::Surface::pocket) {
        resonator = &resonators.pocket;
        sound.group = Group::pockets;
    } else {
        sound.group = surface == sim::Surface::rail ? Group::cushions : Group::objects;
    }
    if (!is_ball(*body.body)) {
        sound.group = Group::objects;
    }
    sound.place = event.place;
    sound.impulse = event.normal_impulse;
    sound.contact_time = resonator_contact_time(*resonator, body.body->mass, event.normal_impulse);
    sound.shape = PulseShape::soft;
    add_body(body, event, 1, mode_factor, sound);
    append(resonator->modes, sound.modes);
    return sound;
}

void ImpactSounds::add_body(const Entry& entry, const sim::Event& event, double sign,
                            double mode_factor, ImpactSound& sound) const {
    const SoundBody& body = *entry.body;
    if (std::isinf(body.mass)) {
        return;
    }
    const Vec3 velocity_step = event.normal * (sign * event.normal_impulse / body.mass);
    const double radius = radius_of(body);
    if (is_ball(body)) {
        add_sphere(event.place + event.normal * (sign * radius), radius, velocity_step, sound);
        return;
    }
    // The sphere that stands for the body is at the body's centre: laid against the contact it
    // could lie below the cloth.
    MotionState state{body.position, {}, {0, 0, 0}, {0, 0, 0}};
    if (entry.track != nullptr) {
        state = entry.track->sample(event.time);
    }
    add_sphere(state.position, radius, velocity_step, sound);
    if (const auto* box = std::get_if<BoxShape>(&body.shape)) {
        const Vec3 direction = to_body(state.orientation, event.normal);
        for (Mode mode : box_modes(box->size, body.mass, body.material, direction)) {
            mode.gain *= mode_factor;
            sound.modes.push_back(mode);
        }
    }
}

void ImpactSounds::add_sphere(const Vec3& centre, double radius, const Vec3& velocity_step,
                              ImpactSound& sound) const {
    sound.spheres.push_back({centre, radius, velocity_step, 1});
    if (shot_.has_bed && shot_.bed_reflection > 0 && centre.z > 0) {
        sound.spheres.push_back({Vec3(centre.x, centre.y, -centre.z), radius,
                                 Vec3(velocity_step.x, velocity_step.y, -velocity_step.z),
                                 shot_.bed_reflection});
    }
}

}  // namespace carom::sound
