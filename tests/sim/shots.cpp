#include "shots.h"

#include <cmath>
#include <stdexcept>

#include "sim/billiards/rack.h"

namespace carom::sim::test {

Body ball(const std::string& name, double x, double y, const Vec3& velocity, const Vec3& spin) {
    Body body;
    body.name = name;
    body.shape = Sphere{kRadius};
    body.mass = kMass;
    body.pose.position = {x, y, kRadius};
    body.velocity = velocity;
    body.angular_velocity = spin;
    return body;
}

Vec3 rolling_spin(const Vec3& velocity, double radius) {
    return Vec3(0, 0, 1).cross(velocity) / radius;
}

ContactLaw constant_law() {
    ContactLaw law;
    law.ball_ball = {0.95, 0.05, BallFriction::constant};
    law.ball_cushion = {CushionModel::han2005, 0.85, 0.2};
    return law;
}

BallCushion constant_cushion(CushionModel model) {
    BallCushion law = usual_cushion(model);
    law.fall = {};
    return law;
}

WorldDescription cloth_world(double duration) {
    WorldDescription world;
    world.contact_law = constant_law();
    world.duration = duration;
    world.table.emplace();
    world.table->kind = billiards::TableKind::cloth;
    world.table->has_cushions = false;
    return world;
}

WorldDescription walled_world(double duration) {
    WorldDescription world;
    world.contact_law = constant_law();
    world.duration = duration;
    world.table = billiards::standard_table(billiards::TableKind::pool, "9 ft");
    world.table->corner_pocket.reset();
    world.table->side_pocket.reset();
    return world;
}

WorldDescription nine_ball_world(double duration) {
    WorldDescription world;
    world.contact_law = constant_law();
    world.duration = duration;
    world.table = billiards::standard_table(billiards::TableKind::pool, "9 ft");
    world.bodies.push_back(ball("cue", -0.75, 0.12));
    for (const billiards::PlacedBall& placed :
         billiards::rack(billiards::RackKind::nine_ball, *world.table, kRadius,
                         billiards::RackOptions{3e-5, 7})) {
        world.bodies.push_back(ball(placed.name, placed.position.x, placed.position.y));
    }
    return world;
}

ForceEvent strike_towards(const std::string& object, const std::string& target, double speed,
                          double time, Vec2 tip, double elevation) {
    Strike strike;
    strike.speed = speed;
    strike.toward = target;
    strike.tip = tip;
    strike.elevation = elevation;
    ForceEvent event;
    event.object = object;
    event.time = time;
    event.action = strike;
    return event;
}

MotionState state_at(const Timeline& timeline, const std::string& name, double time) {
    const Track* track = timeline.find(name);
    if (track == nullptr) {
        throw std::runtime_error("no track " + name);
    }
    return track->sample(time);
}

const Event* find_event(const Timeline& timeline, EventKind kind, const std::string& a,
                        const std::string& b) {
    for (const Event& event : timeline.events) {
        if (event.kind == kind && event.a == a && (b.empty() || event.b == b)) {
            return &event;
        }
    }
    return nullptr;
}

std::vector<std::string> sentences_of(const std::vector<Diagnostic>& diagnostics) {
    std::vector<std::string> sentences;
    for (const Diagnostic& diagnostic : diagnostics) {
        sentences.push_back(diagnostic.sentence);
    }
    return sentences;
}

std::vector<std::string> problem_sentences(const WorldDescription& world) {
    return sentences_of(find_problems(world));
}

int count_events(const Timeline& timeline, EventKind kind) {
    int count = 0;
    for (const Event& event : timeline.events) {
        count += event.kind == kind ? 1 : 0;
    }
    return count;
}

Key key_at(const Timeline& timeline, const std::string& name, double time) {
    for (const Key& key : timeline.find(name)->keys()) {
        if (std::abs(key.time - time) < 1e-9) {
            return key;
        }
    }
    throw std::runtime_error("no key of " + name);
}

}  // namespace carom::sim::test
