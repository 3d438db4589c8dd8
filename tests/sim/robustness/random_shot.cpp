#include "random_shot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/splitmix.h"
#include "sim/billiards/rack.h"

namespace carom::sim::test {
namespace {

using billiards::RackKind;
using billiards::TableKind;

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : random_(seed * 0xD1342543DE82EF95U + 1) {}

    std::uint64_t next() { return random_.next(); }
    double unit() { return random_.next_unit(); }
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
    bool one_in(int count) { return below(count) == 0; }
    Vec3 vector(double x, double y, double z) {
        Vec3 v;
        v.x = between(-x, x);
        v.y = between(-y, y);
        v.z = between(-z, z);
        return v;
    }

  private:
    SplitMix64 random_;
};

constexpr double kLargestSolid = 0.11;  // half its diagonal, m

struct Game {
    TableKind kind;
    const char* size;
    double radius, mass;
    std::array<RackKind, 2> racks;
};

const std::array<Game, 6> kGames{{
    {TableKind::pool, "9 ft", 0.028575, 0.170097, {RackKind::nine_ball, RackKind::eight_ball}},
    {TableKind::pool, "8 ft", 0.028575, 0.170097, {RackKind::ten_ball, RackKind::fifteen_ball}},
    {TableKind::pool, "7 ft", 0.028575, 0.170097, {RackKind::eight_ball, RackKind::nine_ball}},
    {TableKind::snooker, "12 ft", 0.02625, 0.14, {RackKind::snooker, RackKind::snooker}},
    {TableKind::carom, "10 ft", 0.03075, 0.21, {RackKind::carom, RackKind::carom}},
    {TableKind::cloth, "", 0.028575, 0.17, {RackKind::nine_ball, RackKind::fifteen_ball}},
}};

class ShotMaker {
  public:
    explicit ShotMaker(std::uint64_t number) : dice_(number), game_(kGames[number % 6]) {}

    WorldDescription make() {
        make_table();
        make_law();
        if (dice_.one_in(2)) {
            add_rack();
        }
        const int loose = 1 + dice_.below(4);
        for (int i = 0; i < loose; ++i) {
            add_ball("loose" + std::to_string(i));
        }
        if (dice_.one_in(8)) {
            add_solids();
        }
        if (dice_.one_in(3)) {
            set_in_motion();
        }
        const int count = 1 + dice_.below(4);
        for (int i = 0; i < count; ++i) {
            add_event();
        }
        if (dice_.one_in(3)) {
            strike_a_frozen_ball();
        }
        return world_;
    }

  private:
    void make_table() {
        world_.duration = dice_.between(1, 3);
        world_.step = dice_.one_in(4) ? dice_.between(1e-3, 0.02) : 1.0 / 240;
        world_.table = billiards::standard_table(game_.kind, game_.size);
        billiards::TableMeasures& table = *world_.table;
        if (!table.has_cushions) {
            return;
        }
        world_.floor_height = -table.height;
        if (!dice_.one_in(4)) {
            return;
        }
        table.kind = TableKind::custom;
        table.length *= dice_.between(0.5, 1.5);
        table.width = table.length * dice_.between(0.4, 0.7);
        if (dice_.one_in(2)) {
            table.side_pocket.reset();
        }
        if (dice_.one_in(3)) {
            table.corner_pocket.reset();
        }
    }

    void make_law() {
        ContactLaw& law = world_.contact_law;
        law.hop = dice_.one_in(4);
        if (dice_.one_in(2)) {
            return;
        }
        law.ball_ball.restitution = dice_.between(0.5, 1);
        law.ball_ball.friction = dice_.between(0, 0.3);
        if (dice_.one_in(2)) {
            law.ball_ball.friction_model = BallFriction::alciatore;
        }
        law.ball_cushion = usual_cushion(static_cast<CushionModel>(dice_.below(3)));
        law.ball_cloth.sliding_friction = dice_.between(0.05, 0.4);
        law.ball_cloth.rolling_friction = dice_.one_in(4) ? 0 : dice_.between(0, 0.03);
        law.ball_cloth.spinning_friction = dice_.one_in(4) ? 0 : dice_.between(0, 0.03);
        law.ball_cloth.restitution = dice_.between(0.2, 0.8);
    }

    Body sphere(const std::string& name, const Vec3& place) const {
        Body body;
        body.name = name;
        body.shape = Sphere{game_.radius};
        body.mass = game_.mass;
        body.pose.position = place;
        return body;
    }

    void add_rack() {
        const billiards::RackOptions options{dice_.one_in(3) ? 0 : 3e-5, dice_.next()};
        const RackKind kind = game_.racks[static_cast<std::size_t>(dice_.below(2))];
        // A custom table may be too small for it.
        const Vec2 half(0.5 * world_.table->length, 0.5 * world_.table->width);
        for (const auto& placed : billiards::rack(kind, *world_.table, game_.radius, options)) {
            const Vec3& p = placed.position;
            const bool fits = std::abs(p.x) < half.x - 1.01 * game_.radius &&
                              std::abs(p.y) < half.y - 1.01 * game_.radius && is_free(p);
            if (fits) {
                world_.bodies.push_back(sphere(placed.name, p));
            }
        }
    }

    [[nodiscard]] bool is_free(const Vec3& place) const {
        return std::all_of(world_.bodies.begin(), world_.bodies.end(), [&](const Body& other) {
            const Vec3 d = other.pose.position - place;
            const bool is_ball = std::holds_alternative<Sphere>(other.shape);
            const double least_distance = game_.radius + (is_ball ? game_.radius : kLargestSolid);
            return d.dot(d) >= least_distance * least_distance;
        });
    }

    void add_ball(const std::string& name) {
        const Vec2 half(0.5 * world_.table->length - 1.001 * game_.radius,
                        0.5 * world_.table->width - 1.001 * game_.radius);
        for (int attempt = 0; attempt < 50; ++attempt) {
            Vec3 place = dice_.vector(half.x, half.y, 0);
            // Sometimes at a cushion, or in the air.
            if (dice_.one_in(10)) {
                place.x = place.x < 0 ? -half.x : half.x;
            }
            place.z = game_.radius + (dice_.one_in(8) ? dice_.between(0.05, 0.6) : 0);
            if (!is_free(place)) {
                continue;
            }
            world_.bodies.push_back(sphere(name, place));
            return;
        }
    }

    /// Strikes a new ball that touches another on the bed at the start, or a little later, when it
    /// may have been moved.
    void strike_a_frozen_ball() {
        const Vec2 half(0.5 * world_.table->length - 1.001 * game_.radius,
                        0.5 * world_.table->width - 1.001 * game_.radius);
        for (int attempt = 0; attempt < 50; ++attempt) {
            const Body& other = world_.bodies[static_cast<std::size_t>(
                dice_.below(static_cast<int>(world_.bodies.size())))];
            const double angle = dice_.between(-3.2, 3.2);
            const Vec3 place =
                other.pose.position + Vec3(std::cos(angle), std::sin(angle), 0) *
                                          (2 * game_.radius + dice_.between(1e-12, 3e-5));
            if (!std::holds_alternative<Sphere>(other.shape) || place.z != game_.radius ||
                std::abs(place.x) > half.x || std::abs(place.y) > half.y || !is_free(place)) {
                continue;
            }
            world_.bodies.push_back(sphere("frozen", place));
            ForceEvent event;
            event.object = "frozen";
            event.time = dice_.one_in(2) ? 0 : dice_.between(0, 0.2);
            event.action = strike(event.object);
            world_.events.push_back(std::move(event));
            return;
        }
    }

    /// A box, or another solid that fits into a box of that size and has its height.
    BodyShape solid(const Vec3& size) {
        const double radius = 0.5 * std::min({size.x, size.y, 0.9 * size.z});
        switch (dice_.below(6)) {
            case 0:
                return Capsule{radius, size.z - 2 * radius};
            case 1:
                return Cylinder{radius, size.z};
            case 2: {  // an octahedron
                ConvexHull hull;
                for (int axis = 0; axis < 3; ++axis) {
                    for (const double side : {-0.5, 0.5}) {
                        hull.points.emplace_back(0, 0, 0);
                        hull.points.back()[axis] = side * size[axis];
                    }
                }
                return hull;
            }
            default:
                return Box{size};
        }
    }

    void add_solids() {
        const int count = 1 + dice_.below(3);
        for (int i = 0; i < count; ++i) {
            Body body;
            body.name = "solid" + std::to_string(i);
            Vec3 size(0, 0, 0);
            for (int axis = 0; axis < 3; ++axis) {
                size[axis] = dice_.between(0.02, 0.12);
            }
            body.shape = solid(size);
            body.mass = dice_.between(0.05, 1);
            body.material = "wood";
            Vec3 place = dice_.vector(0.3 * world_.table->length, 0.3 * world_.table->width, 0);
            place.z = 0.5 * size.z + (dice_.one_in(2) ? 0 : dice_.between(0.05, 0.3));
            const double radius = 0.5 * size.length() + 0.05;
            const bool fits =
                std::all_of(world_.bodies.begin(), world_.bodies.end(), [&](const Body& other) {
                    const Vec3 d = other.pose.position - place;
                    return d.length() > radius + 0.12;
                });
            body.pose.position = place;
            if (fits) {
                world_.bodies.push_back(body);
            }
        }
    }

    /// Some balls move from the start.
    void set_in_motion() {
        for (Body& body : world_.bodies) {
            if (!std::holds_alternative<Sphere>(body.shape) || !dice_.one_in(3)) {
                continue;
            }
            body.velocity = dice_.vector(8, 8, dice_.one_in(4) ? 4 : 0);
            body.angular_velocity = dice_.vector(200, 200, 200);
        }
    }

    std::string any_ball() {
        std::string name;
        do {
            const auto index = dice_.below(static_cast<int>(world_.bodies.size()));
            const Body& body = world_.bodies[static_cast<std::size_t>(index)];
            if (std::holds_alternative<Sphere>(body.shape)) {
                name = body.name;
            }
        } while (name.empty());
        return name;
    }

    Strike strike(const std::string& object) {
        Strike strike;
        strike.speed = dice_.one_in(4) ? dice_.between(8, 15) : dice_.between(0.1, 8);
        const double offset = dice_.between(0, 0.65);
        const double angle = dice_.between(-3.2, 3.2);
        strike.tip = {offset * std::cos(angle), offset * std::sin(angle)};
        strike.elevation = dice_.one_in(2) ? dice_.between(0, 1.4) : 0.05;
        const std::string target = any_ball();
        if (target != object && !dice_.one_in(3)) {
            strike.toward = target;
        } else {
            strike.direction = dice_.between(-3.2, 3.2);
        }
        return strike;
    }

    void add_event() {
        ForceEvent event;
        event.object = any_ball();
        event.time = dice_.one_in(2) ? 0 : dice_.between(0, 0.8 * world_.duration);
        event.after = dice_.one_in(3) ? dice_.between(0, 0.3) : 0;
        if (dice_.one_in(3)) {
            event.trigger = trigger();
        }
        switch (dice_.below(8)) {
            case 0:
                event.action = Force{dice_.vector(20, 20, 20), dice_.between(1e-4, 0.2),
                                     dice_.vector(0.01, 0.01, 0.01),
                                     dice_.one_in(2) ? Axes::world : Axes::body};
                break;
            case 1:
                event.action = Torque{dice_.vector(0.02, 0.02, 0.02), dice_.between(1e-4, 0.2),
                                      dice_.one_in(2) ? Axes::world : Axes::body};
                break;
            case 2:
                event.action =
                    Impulse{dice_.vector(1, 1, 0.5), dice_.vector(0.02, 0.02, 0.02), Axes::world};
                break;
            case 3:
                event.action = SetVelocity{dice_.vector(10, 10, 4), dice_.vector(300, 300, 300)};
                break;
            default:
                event.action = strike(event.object);
        }
        world_.events.push_back(std::move(event));
    }

    Trigger trigger() {
        Trigger trigger;
        trigger.kind = static_cast<Trigger::Kind>(dice_.below(4));
        trigger.a = any_ball();
        if (trigger.kind == Trigger::Kind::contact) {
            trigger.b = any_ball();
            if (trigger.b == trigger.a) {
                trigger.b = "cushion";
            }
        }
        if (trigger.kind == Trigger::Kind::resting && dice_.one_in(2)) {
            trigger.a.clear();
        }
        if (trigger.kind == Trigger::Kind::crossing) {
            trigger.from = Vec2(dice_.between(-1, 1), -1);
            trigger.to = Vec2(dice_.between(-1, 1), 1);
        }
        return trigger;
    }

    Dice dice_;
    const Game& game_;
    WorldDescription world_;
};

}  // namespace

WorldDescription random_shot(std::uint64_t number) {
    return ShotMaker(number).make();
}

}  // namespace carom::sim::test
