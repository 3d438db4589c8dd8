// Finds balls that overlap each other or other objects.
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"
#include "sim/start_overlaps.h"

namespace carom::pipeline::config {

namespace {

struct Ball {
    const sim::Body* body = nullptr;
    double radius = 0;
};

std::vector<Ball> spheres(const Builder& builder) {
    std::vector<Ball> balls;
    for (const sim::Body& body : builder.shot.world.bodies) {
        if (const auto* sphere = std::get_if<sim::Sphere>(&body.shape)) {
            balls.push_back({&body, sphere->radius});
        }
    }
    return balls;
}

Place place_of_body(const Builder& builder, const sim::Body& body) {
    return builder.placed.at(body.name);
}

void check_pair(const Ball& a, const Ball& b, Builder& builder) {
    const Vec3 d = a.body->pose.position - b.body->pose.position;
    const double overlap = a.radius + b.radius - std::sqrt(d.dot(d));
    if (overlap > 1e-9 * (a.radius + b.radius)) {
        builder.reader.error(place_of_body(builder, *b.body),
                             quote(b.body->name) + " and " + quote(a.body->name) + " overlap by " +
                                 millimetres_text(std::max(overlap, 1e-5)));
    }
}

}  // namespace

void check_placement(Builder& builder) {
    const std::vector<Ball> balls = spheres(builder);
    for (std::size_t j = 0; j < balls.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            check_pair(balls[i], balls[j], builder);
        }
    }
    const bool has_cushions = builder.table_geometry && builder.shot.world.table->has_cushions;
    const auto overlaps = sim::find_start_overlaps(
        builder.shot.world, has_cushions ? builder.table_geometry.get() : nullptr);
    for (const sim::StartOverlap& overlap : overlaps) {
        builder.reader.error(builder.placed.at(overlap.body),
                             quote(overlap.body) + " " + overlap.sentence());
    }
    for (const Diagnostic& problem : sim::find_place_problems(
             builder.shot.world, has_cushions ? builder.table_geometry.get() : nullptr)) {
        builder.report(problem);
    }
}

}  // namespace carom::pipeline::config
