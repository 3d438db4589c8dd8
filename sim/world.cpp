#include "sim/world.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <fmt/core.h>

#include "core/finite.h"
#include "core/text.h"
#include "sim/limits.h"
#include "sim/shape/mass_properties.h"
#include "sim/timeline/surface.h"

namespace carom::sim {
namespace {

/// Collects problems. All sentences about one subject begin with the same prefix.
class ProblemCollector {
  public:
    explicit ProblemCollector(std::vector<Diagnostic>& list) : list_(list) {}

    void about_contact(const std::string& name) {
        subject_ = {Subject::Kind::contact, name};
        prefix_ = name + ": ";
    }
    void about_other_contact(const std::string& key, const std::string& names) {
        subject_ = {Subject::Kind::contact, key};
        prefix_ = "contact of " + names + ": ";
    }
    void about_body(const std::string& name) {
        subject_ = Subject::body(name);
        prefix_ = "body '" + name + "': ";
    }
    void about_event(std::size_t index, const std::string& object) {
        subject_ = Subject::event(index);
        prefix_ = fmt::format("event {} on '{}': ", index + 1, object);
    }
    void require(bool holds, const std::string& field, const std::string& sentence) {
        if (!holds) {
            list_.push_back({subject_, field, prefix_ + sentence});
        }
    }

  private:
    std::vector<Diagnostic>& list_;
    Subject subject_;
    std::string prefix_;  // of every sentence about the subject
};

bool is_positive(double value) {
    return std::isfinite(value) && value > 0;
}
bool is_not_negative(double value) {
    return std::isfinite(value) && value >= 0;
}
bool is_fraction(double value) {
    return value >= 0 && value <= 1;
}
bool is_size(double value) {
    return value >= kMinSize && value <= kMaxSize;
}
bool is_speed(double value) {
    return value > 0 && value <= kMaxSpeed;
}
bool is_within(const Vec3& v, double most) {
    return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;
}

std::string size_range() {
    return fmt::format(" has to be in [{:g}, {:g}] m", kMinSize, kMaxSize);
}

std::string within(double most, const char* unit) {
    return fmt::format(" has to be within {:g} {} in each direction", most, unit);
}

void check_pair(const PairContact& pair, const std::string& key, const std::string& names,
                ProblemCollector& collector) {
    collector.about_other_contact(key, names);
    collector.require(is_fraction(pair.restitution), "restitution",
                      "restitution has to be in [0, 1]");
    collector.require(is_not_negative(pair.friction), "friction", "friction has to be 0 or more");
    collector.require(is_not_negative(pair.rolling_friction.value_or(0)), "rolling_friction",
                      "rolling_friction has to be 0 or more");
}

void check_contact_law(const ContactLaw& law, ProblemCollector& collector) {
    collector.about_contact("ball_cloth");
    collector.require(is_not_negative(law.ball_cloth.sliding_friction) &&
                          is_not_negative(law.ball_cloth.rolling_friction) &&
                          is_not_negative(law.ball_cloth.spinning_friction),
                      "friction", "friction has to be 0 or more");
    collector.require(is_fraction(law.ball_cloth.restitution), "restitution",
                      "restitution has to be in [0, 1]");
    collector.about_contact("ball_ball");
    collector.require(is_fraction(law.ball_ball.restitution), "restitution",
                      "restitution has to be in [0, 1]");
    collector.require(is_not_negative(law.ball_ball.friction), "friction",
                      "friction has to be 0 or more");
    collector.require(is_not_negative(law.ball_ball.friction_factor), "friction_factor",
                      "friction_factor has to be 0 or more");
    collector.about_contact("ball_cushion");
    collector.require(is_fraction(law.ball_cushion.restitution), "restitution",
                      "restitution has to be in [0, 1]");
    collector.require(is_not_negative(law.ball_cushion.friction), "friction",
                      "friction has to be 0 or more");
    const RestitutionFall& fall = law.ball_cushion.fall;
    collector.require(
        is_not_negative(fall.above) && is_not_negative(fall.slope) && is_fraction(fall.least),
        "restitution",
        "restitution has to fall above a speed of 0 or more, by 0 or more, to at least [0, 1]");
    check_pair(law.otherwise, "otherwise", "other materials", collector);
    for (const auto& [names, pair] : law.pairs) {
        check_pair(pair, "pairs", "'" + names.first + "' and '" + names.second + "'", collector);
    }
}

void check_hull(const ConvexHull& shape, ProblemCollector& collector) {
    for (const Vec3& point : shape.points) {
        if (!is_finite(point)) {
            return collector.require(false, "points",
                                     "every point of a convex hull has to be finite");
        }
    }
    const std::optional<Polyhedron> hull = convex_hull(shape.points);
    collector.require(hull.has_value(), "points",
                      "a convex hull needs at least four points that do not lie in a plane");
    if (!hull) {
        return;
    }
    const Vec3 centre = mass_properties(*hull).centre;
    double radius = 0;
    for (const Vec3& vertex : hull->vertices) {
        radius = std::max(radius, std::sqrt(vertex.dot(vertex)));
    }
    collector.require(std::sqrt(centre.dot(centre)) <= 1e-6 * radius, "points",
                      "the points of a convex hull have to be relative to its centre of mass");
}

void check_shape(const Body& body, ProblemCollector& collector) {
    if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
        collector.require(is_size(sphere->radius), "radius", "radius" + size_range());
    } else if (const auto* box = std::get_if<Box>(&body.shape)) {
        collector.require(is_size(box->size.x) && is_size(box->size.y) && is_size(box->size.z),
                          "size", "every edge of a box" + size_range());
    } else if (const auto* capsule = std::get_if<Capsule>(&body.shape)) {
        collector.require(is_size(capsule->radius) && is_size(capsule->length), "",
                          "each of the radius and the length of a capsule" + size_range());
    } else if (const auto* cylinder = std::get_if<Cylinder>(&body.shape)) {
        collector.require(is_size(cylinder->radius) && is_size(cylinder->height), "",
                          "each of the radius and the height of a cylinder" + size_range());
    } else if (const auto* hull = std::get_if<ConvexHull>(&body.shape)) {
        check_hull(*hull, collector);
    } else if (const auto* mesh = std::get_if<TriangleMesh>(&body.shape)) {
        collector.require(body.kind == BodyKind::fixed, "", "only a fixed body can be a mesh");
        bool vertices_are_finite = true;
        for (const Vec3& vertex : mesh->vertices) {
            vertices_are_finite = vertices_are_finite && is_finite(vertex);
        }
        collector.require(vertices_are_finite, "mesh", "every vertex has to be finite");
        bool indices_are_valid = true;
        for (const auto& triangle : mesh->triangles) {
            for (const std::uint32_t index : triangle) {
                indices_are_valid = indices_are_valid && index < mesh->vertices.size();
            }
        }
        collector.require(indices_are_valid, "mesh",
                          "a triangle refers to a vertex that the mesh does not have");
    }
}

void check_body(const Body& body, ProblemCollector& collector) {
    collector.about_body(body.name);
    collector.require(!body.name.empty(), "", "the name is empty");
    collector.require(!is_surface(body.name), "",
                      "this is the name of a surface; choose another one");
    check_shape(body, collector);
    if (body.kind == BodyKind::dynamic) {
        collector.require(is_positive(body.mass), "mass", "mass has to be greater than 0");
    }
    collector.require((body.kind == BodyKind::kinematic) == (body.path && body.path->track),
                      "motion", "a kinematic body needs a path, and no other body can have one");
    const Quat& q = body.pose.orientation;
    const double norm = std::sqrt(q.r * q.r + q.v.dot(q.v));
    collector.require(std::abs(norm - 1) < 1e-6, "rotate",
                      "the orientation has to be a unit quaternion");
    collector.require(is_finite(body.pose.position) && (!body.path || is_finite(body.path->centre)),
                      "at", "its position has to be finite");
    collector.require(is_within(body.velocity, kMaxSpeed), "velocity",
                      "its velocity" + within(kMaxSpeed, "m/s"));
    collector.require(is_within(body.angular_velocity, kMaxSpin), "spin",
                      "its spin" + within(kMaxSpin, "rad/s"));
}

void check_overlaps(const WorldDescription& world, ProblemCollector& collector) {
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        for (std::size_t j = i + 1; j < world.bodies.size(); ++j) {
            const auto* a = std::get_if<Sphere>(&world.bodies[i].shape);
            const auto* b = std::get_if<Sphere>(&world.bodies[j].shape);
            if (a == nullptr || b == nullptr) {
                continue;
            }
            const Vec3 d = world.bodies[i].pose.position - world.bodies[j].pose.position;
            const double depth = a->radius + b->radius - std::sqrt(d.dot(d));
            if (depth < 1e-9 * (a->radius + b->radius)) {
                continue;
            }
            collector.about_body(world.bodies[j].name);
            collector.require(false, "at",
                              "it overlaps '" + world.bodies[i].name + "' by " +
                                  millimetres_text(std::max(depth, 1e-5)) + " at the start");
        }
    }
}

class EventChecker {
  public:
    EventChecker(const WorldDescription& world, ProblemCollector& collector)
        : world_(world), collector_(collector) {}

    void check(const ForceEvent& event, std::size_t index) {
        collector_.about_event(index, event.object);
        collector_.require(is_dynamic(event.object), "", "no movable body has this name");
        collector_.require(is_not_negative(event.time), "at", "its time has to be 0 or more");
        collector_.require(is_not_negative(event.after), "after", "the delay has to be 0 or more");
        if (event.trigger) {
            check_trigger(*event.trigger);
        }
        object_ = &event.object;
        std::visit([this](const auto& action) { check_action(action); }, event.action);
    }

  private:
    [[nodiscard]] const Body* find(const std::string& name) const {
        for (const Body& body : world_.bodies) {
            if (body.name == name) {
                return &body;
            }
        }
        return nullptr;
    }
    [[nodiscard]] bool is_fixed(const std::string& name) const {
        const Body* body = find(name);
        return body != nullptr && body->kind == BodyKind::fixed;
    }
    [[nodiscard]] bool is_dynamic(const std::string& name) const {
        const Body* body = find(name);
        return body != nullptr && body->kind == BodyKind::dynamic;
    }

    void check_trigger(const Trigger& trigger) {
        collector_.require(trigger.nth >= 1, "when", "nth has to be 1 or more");
        const bool all_rest = trigger.kind == Trigger::Kind::resting && trigger.a.empty();
        collector_.require(all_rest || find(trigger.a) != nullptr, "when",
                           "its trigger names '" + trigger.a + "', which does not exist");
        if (trigger.kind == Trigger::Kind::contact) {
            collector_.require(find(trigger.b) != nullptr || is_surface(trigger.b), "when",
                               "its trigger names '" + trigger.b + "', which does not exist");
        }
        if (trigger.kind == Trigger::Kind::crossing) {
            const Vec2 line = trigger.to - trigger.from;
            const double length2 = line.dot(line);
            collector_.require(
                !is_fixed(trigger.a), "when",
                "it waits for '" + trigger.a + "' to cross a line, but that body is fixed");
            collector_.require(std::isfinite(length2) && length2 > 0, "when",
                               "the line of its trigger needs two different ends");
        }
    }

    void check_action(const Force& force) {
        collector_.require(is_within(force.newtons, kMaxForce), "newtons",
                           "the force" + within(kMaxForce, "N"));
        require_point(force.at_point);
        collector_.require(is_positive(force.duration), "duration",
                           "a force has to last longer than 0 s");
    }
    void check_action(const Torque& torque) {
        collector_.require(is_within(torque.newton_metres, kMaxTorque), "newton_metres",
                           "the torque" + within(kMaxTorque, "N m"));
        collector_.require(is_positive(torque.duration), "duration",
                           "a torque has to last longer than 0 s");
    }
    void check_action(const Impulse& impulse) {
        collector_.require(is_within(impulse.newton_seconds, kMaxImpulse), "newton_seconds",
                           "the impulse" + within(kMaxImpulse, "N s"));
        require_point(impulse.at_point);
    }
    void check_action(const SetVelocity& velocity) {
        collector_.require(is_within(velocity.linear.value_or(Vec3(0, 0, 0)), kMaxSpeed), "linear",
                           "the velocity" + within(kMaxSpeed, "m/s"));
        collector_.require(is_within(velocity.angular.value_or(Vec3(0, 0, 0)), kMaxSpin), "angular",
                           "the angular velocity" + within(kMaxSpin, "rad/s"));
    }
    void check_action(const Strike& strike) {
        const Body* body = find(*object_);
        collector_.require(body == nullptr || std::holds_alternative<Sphere>(body->shape), "",
                           "only a ball can be struck");
        const int aims = int{strike.toward.has_value()} + int{strike.toward_point.has_value()} +
                         int{strike.direction.has_value()};
        collector_.require(aims == 1, "toward",
                           "a strike needs exactly one of toward and direction");
        collector_.require(strike.speed.has_value() != strike.ball_speed.has_value(), "speed",
                           "a strike needs exactly one of speed and ball_speed");
        collector_.require(
            is_speed(strike.speed.value_or(1)) && is_speed(strike.ball_speed.value_or(1)), "speed",
            fmt::format("the speed of a strike has to be in (0, {:g}] m/s", kMaxSpeed));
        if (strike.toward) {
            collector_.require(find(*strike.toward) != nullptr, "toward",
                               "it aims at '" + *strike.toward + "', which does not exist");
            collector_.require(*strike.toward != *object_, "toward",
                               "a ball cannot be aimed at itself");
        }
        collector_.require(is_finite(strike.toward_point.value_or(Vec3(0, 0, 0))) &&
                               std::abs(strike.direction.value_or(0)) < 1e5,
                           "toward", "the aim has to be finite");
        collector_.require(strike.elevation >= 0 && strike.elevation < 1.5707963267948966,
                           "elevation", "elevation has to be in [0, 90) degrees");
        collector_.require(strike.tip.dot(strike.tip) < 1, "tip",
                           "the tip misses the ball: its offset has to be less than 1 ball radius");
        collector_.require(is_positive(strike.stick_mass), "stick_mass",
                           "stick_mass has to be greater than 0");
        collector_.require(is_positive(strike.end_mass_ratio), "end_mass_ratio",
                           "end_mass_ratio has to be greater than 0");
        collector_.require(strike.tip_restitution >= 0 && strike.tip_restitution <= 1,
                           "tip_restitution", "tip_restitution has to be in [0, 1]");
    }

    void check_action(const PlaceBall& place) {
        require_ball("only a ball can be put down");
        collector_.require(world_.table.has_value(), "spot", "without a table a ball has no place");
        collector_.require(std::isfinite(place.at.x) && std::isfinite(place.at.y), "spot",
                           "its place has to be finite");
    }
    void check_action(const RemoveBall& /*remove*/) {
        require_ball("only a ball can be taken off");
        collector_.require(world_.table.has_value(), "",
                           "without a table a ball cannot be taken off");
    }
    void require_point(const Vec3& point) {
        collector_.require(is_finite(point), "at_point",
                           "the point on which it acts has to be finite");
    }
    void require_ball(const std::string& sentence) {
        const Body* body = find(*object_);
        collector_.require(body == nullptr || std::holds_alternative<Sphere>(body->shape), "",
                           sentence);
    }

    const WorldDescription& world_;
    ProblemCollector& collector_;
    const std::string* object_ = nullptr;
};

void check_table(const WorldDescription& world, ProblemCollector& collector,
                 std::vector<Diagnostic>& problems) {
    if (!world.table) {
        return;
    }
    for (Diagnostic& problem : billiards::find_problems(*world.table)) {
        problem.sentence = "table: " + problem.sentence;
        problems.push_back(std::move(problem));
    }
    if (!world.table->has_cushions) {
        return;
    }
    for (const Body& body : world.bodies) {
        const auto* sphere = std::get_if<Sphere>(&body.shape);
        if (sphere == nullptr || body.kind != BodyKind::dynamic) {
            continue;
        }
        collector.about_body(body.name);
        collector.require(world.table->nose_height < 2 * sphere->radius, "radius",
                          fmt::format("the cushion nose ({}) is higher than the ball (diameter {})",
                                      millimetres_text(world.table->nose_height),
                                      millimetres_text(2 * sphere->radius)));
    }
}

}  // namespace

std::vector<Diagnostic> find_problems(const WorldDescription& world) {
    std::vector<Diagnostic> problems;
    ProblemCollector collector(problems);
    collector.require(is_finite(world.gravity), "gravity", "gravity has to be finite");
    collector.require(is_positive(world.duration) && world.duration <= 3600, "duration",
                      "duration has to be in (0, 3600] s");
    collector.require(world.step >= 1e-5 && world.step <= 0.1, "step",
                      "step has to be in [1e-5, 0.1] s");
    collector.require(std::isfinite(world.floor_height.value_or(0)), "floor",
                      "the height of the floor has to be finite");
    collector.require(is_positive(world.key_reduction.position_error) &&
                          is_positive(world.key_reduction.orientation_error),
                      "key_reduction",
                      "the error limits of key reduction have to be greater than 0");
    check_contact_law(world.contact_law, collector);
    check_table(world, collector, problems);
    std::set<std::string> names;
    for (const Body& body : world.bodies) {
        check_body(body, collector);
        collector.require(names.insert(body.name).second, "", "another body has the same name");
    }
    check_overlaps(world, collector);
    if (world.respot && !(world.table && world.table->has_cushions)) {
        problems.push_back({{}, "respot", "respot needs a table with cushions"});
    }
    for (Diagnostic& problem : find_event_problems(world)) {
        problems.push_back(std::move(problem));
    }
    return problems;
}

std::vector<Diagnostic> find_event_problems(const WorldDescription& world) {
    std::vector<Diagnostic> problems;
    ProblemCollector collector(problems);
    EventChecker checker(world, collector);
    for (std::size_t i = 0; i < world.events.size(); ++i) {
        checker.check(world.events[i], i);
    }
    return problems;
}

}  // namespace carom::sim
