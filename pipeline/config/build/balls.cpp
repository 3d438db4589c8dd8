#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pipeline/config/build/builder.h"
#include "pipeline/shot/ball_orientation.h"
#include "pipeline/shot/default_look.h"

namespace carom::pipeline::config {

namespace {

using sim::billiards::TableKind;

/// A ball of the rack or of `balls`.
struct Ball {
    std::string name;
    Vec3 position;  // NaN if the file does not give it, so that it overlaps nothing
    bool has_position = false;
    const BallSection* section = nullptr;  // null: only racked
    Place place;
};

BallSet set_of(const ShotFile& file) {
    if (file.ball_set.kind) {
        return *file.ball_set.kind;
    }
    const TableKind kind = file.table ? file.table->kind : TableKind::pool;
    if (kind == TableKind::snooker) {
        return BallSet::snooker;
    }
    return kind == TableKind::carom ? BallSet::carom : BallSet::pool;
}

double scaled_mass(double mass, double from_radius, double to_radius) {
    const double ratio = to_radius / from_radius;
    return mass * ratio * ratio * ratio;
}

std::vector<Ball> racked_balls(Builder& builder) {
    const Place place = builder.place_of({"rack"});
    std::vector<Ball> balls;
    for (const sim::billiards::PlacedBall& ball : place_rack(builder)) {
        balls.push_back({ball.name, ball.position, true, nullptr, place});
    }
    return balls;
}

void add_given_balls(Builder& builder, std::vector<Ball>& balls) {
    for (const Named<BallSection>& given : builder.file.balls) {
        auto ball = std::find_if(balls.begin(), balls.end(),
                                 [&](const Ball& b) { return b.name == given.name; });
        if (ball == balls.end()) {
            const Vec3 unknown(std::numeric_limits<double>::quiet_NaN());
            balls.push_back({given.name, unknown, false, nullptr, given.place});
            ball = balls.end() - 1;
        }
        ball->section = &given.value;
        ball->place = given.place;
        const Entry* section = builder.root.find("balls")->value.find(given.name);
        const bool has_position_key = section->value.find("at") != nullptr ||
                                      section->value.find("touching") != nullptr;  // valid or not
        if (!ball->has_position && !has_position_key) {
            builder.reader.error(given.place,
                                 "ball '" + given.name +
                                     "' needs the key 'at' or 'touching', since it is not racked");
        }
    }
}

sim::Body make_body(const Ball& ball, const Builder& builder) {
    const ShotFile& file = builder.file;
    static const BallSection kEmpty;
    const BallSection& section = ball.section != nullptr ? *ball.section : kEmpty;
    const BallMeasures set = measures_of_set(file);
    sim::Body body;
    body.name = ball.name;
    const double radius = section.radius.value_or(set.radius);
    body.shape = sim::Sphere{radius};
    body.mass = section.mass.value_or(scaled_mass(set.mass, set.radius, radius));
    body.material = "ball";
    body.pose.position = ball.position;
    if (section.at) {
        const Vec2 at = place_on_table(builder, *section.at);
        body.pose.position = {at.x, at.y, section.at->point.value.z};
    }
    if (!section.at || !section.at->point.has_z) {
        body.pose.position.z = radius;
    }
    body.pose.orientation =
        section.rotate.value_or(initial_ball_orientation(file.world.seed, ball.name));
    body.velocity = section.velocity ? section.velocity->value : Vec3(0, 0, 0);
    body.angular_velocity = section.spin.value_or(Vec3(0, 0, 0));
    return body;
}

void override_paint(render::BallTexture& texture, const BallLook& look) {
    texture.colour = look.colour.value_or(texture.colour);
    texture.white = look.white.value_or(texture.white);
    texture.striped = look.striped.value_or(texture.striped);
    texture.number = look.number.value_or(texture.number);
    texture.disc_radius = look.disc_radius.value_or(texture.disc_radius);
    texture.band_width = look.band_width.value_or(texture.band_width);
    texture.spots = look.spots.value_or(texture.spots);
}

/// The finish of the material "ball" with the ball's own paint.
render::MaterialDescription make_material(const Ball& ball, const Builder& builder) {
    render::MaterialDescription material;
    material.name = "ball/" + ball.name;
    for (const render::MaterialDescription& known : default_materials()) {
        if (known.name == "ball") {
            material.surface = known.surface;
        }
    }
    for (const Named<render::MaterialDescription>& given : builder.file.materials) {
        if (given.name == "ball") {
            material.surface = given.value.surface;
            material.phong = given.value.phong;
        }
    }
    render::BallTexture texture = ball_texture(set_of(builder.file), ball.name);
    if (ball.section != nullptr && ball.section->look) {
        override_paint(texture, *ball.section->look);
    }
    (material.phong ? material.phong->diffuse : material.surface.base) = texture;
    return material;
}

void add_to_scene(const Ball& ball, double radius, Builder& builder) {
    render::ObjectDescription object;
    object.name = ball.name;
    object.shape = render::SphereShape{radius};
    object.track = ball.name;
    if (ball.section != nullptr && ball.section->look && ball.section->look->material) {
        object.material = *ball.section->look->material;
    } else {
        render::MaterialDescription material = make_material(ball, builder);
        object.material = material.name;
        builder.shot.scene.materials.push_back(std::move(material));
    }
    builder.shot.scene.objects.push_back(std::move(object));
}

}  // namespace

BallMeasures measures_of_set(const ShotFile& file) {
    const BallMeasures usual = ball_measures(set_of(file));
    const double radius = file.ball_set.radius.value_or(usual.radius);
    return {radius, file.ball_set.mass.value_or(scaled_mass(usual.mass, usual.radius, radius))};
}

void build_balls(Builder& builder) {
    std::vector<Ball> balls = racked_balls(builder);
    add_given_balls(builder, balls);
    std::vector<sim::Body> bodies;
    bodies.reserve(balls.size());
    for (const Ball& ball : balls) {
        bodies.push_back(make_body(ball, builder));
    }
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Ball& ball = balls[i];
        if (!builder.claim_name(ball.name, ball.place, "ball")) {
            continue;
        }
        sim::Body& body = bodies[i];
        add_to_scene(ball, std::get<sim::Sphere>(body.shape).radius, builder);
        builder.balls.insert(ball.name);
        builder.bodies.insert(ball.name);
        builder.shot.world.bodies.push_back(std::move(body));
    }
}

}  // namespace carom::pipeline::config
