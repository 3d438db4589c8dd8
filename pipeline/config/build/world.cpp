// Finds problems of the world that the checks of single keys cannot find.
#include <algorithm>
#include <string>
#include <vector>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"
#include "sim/timeline/surface.h"

namespace carom::pipeline::config {

namespace {

const sim::Body* body_named(const Builder& builder, const std::string& name) {
    const std::vector<sim::Body>& bodies = builder.shot.world.bodies;
    const auto found = std::find_if(bodies.begin(), bodies.end(),
                                    [&](const sim::Body& body) { return body.name == name; });
    return found != bodies.end() ? &*found : nullptr;
}

/// The key with the law of two materials that have their own; empty if `pairs` has it.
std::string own_key(const std::string& a, const std::string& b) {
    const std::string& other = a == "ball" ? b : a;
    const bool has_own = other == "ball" || other == "cloth" || other == "cushion";
    return (a == "ball" || b == "ball") && has_own ? "physics.ball_" + other : "";
}

/// A name in a pair that no object has as its physical material.
void report_unknown_material(Builder& builder, const Node& name,
                             const std::vector<std::string>& known) {
    const sim::Body* body = body_named(builder, name.text);
    if (body == nullptr) {
        builder.reader.error(name.place, "no object has the physical material " + quote(name.text) +
                                             hint(name.text, known));
    } else if (body->material == "ball") {
        builder.reader.error(name.place,
                             quote(name.text) +
                                 " is a ball, no physical material. A pair may name two "
                                 "balls; otherwise a ball's material is 'ball'");
    } else {
        builder.reader.error(
            name.place, quote(name.text) + " is an object, no physical material; its material is " +
                            quote(body->material));
    }
}

/// Refuses pairs of physical materials that have no effect.
void check_pairs(Builder& builder) {
    std::vector<std::string> known{"ball"};
    known.insert(known.end(), sim::surface_names().begin(), sim::surface_names().end());
    for (const sim::Body& body : builder.shot.world.bodies) {
        known.push_back(body.material);
    }
    const Entry* physics = builder.root.find("physics");
    const Entry* pairs = physics != nullptr ? physics->value.find("pairs") : nullptr;
    if (pairs == nullptr) {
        return;
    }
    for (const Node& pair : pairs->value.items) {
        const std::vector<Node>& names = pair.find("between")->value.items;
        const auto is_ball = [&](const Node& name) {
            const sim::Body* body = body_named(builder, name.text);
            return body != nullptr && body->material == "ball" &&
                   std::holds_alternative<sim::Sphere>(body->shape);
        };
        if (names[0].text != names[1].text && is_ball(names[0]) && is_ball(names[1])) {
            continue;  // the law of these two balls
        }
        for (const Node& name : names) {
            if (std::find(known.begin(), known.end(), name.text) == known.end()) {
                report_unknown_material(builder, name, known);
            }
        }
        const std::string key = own_key(names[0].text, names[1].text);
        if (!key.empty()) {
            builder.reader.error(names[0].place, quote(names[0].text) + " and " +
                                                     quote(names[1].text) + " follow '" + key +
                                                     "'; a pair has no effect on them");
        } else if (sim::is_surface(names[0].text) && sim::is_surface(names[1].text)) {
            builder.reader.error(names[0].place, quote(names[0].text) + " and " +
                                                     quote(names[1].text) +
                                                     " never move against each other");
        }
    }
}

}  // namespace

void check_world(Builder& builder) {
    if (builder.reader.has_error()) {
        return;  // the same problems would be reported twice
    }
    check_pairs(builder);
    for (const Diagnostic& problem : sim::find_problems(builder.shot.world)) {
        builder.report(problem);
    }
}

void check_events(Builder& builder) {
    if (builder.reader.has_error()) {
        return;
    }
    for (const Diagnostic& problem : sim::find_event_problems(builder.shot.world)) {
        builder.report(problem);
    }
}

}  // namespace carom::pipeline::config
