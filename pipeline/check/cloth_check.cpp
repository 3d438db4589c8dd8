// Balls on a cloth without cushions, which is drawn as far as it was thought to be needed.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "pipeline/check/motion_check.h"

namespace carom::pipeline {

namespace {

constexpr double kInterval = 1.0 / 120;  // s, between two looks

/// Beyond the drawn square of the cloth.
bool is_beyond(const sim::billiards::TableMeasures& cloth, const Vec3& place) {
    return std::abs(place.x) > cloth.length / 2 || std::abs(place.y) > cloth.width / 2;
}

/// When the object is first seen beyond the cloth, s; empty if never, or from the start.
std::optional<double> leaves_at(const sim::billiards::TableMeasures& cloth, const sim::Track& track,
                                const sim::Timeline& timeline) {
    double inside = timeline.start_time;
    if (is_beyond(cloth, track.sample(inside).position)) {
        return std::nullopt;
    }
    const auto looks =
        static_cast<int>(std::ceil((timeline.end_time - timeline.start_time) / kInterval));
    for (int i = 1; i <= looks; ++i) {
        double beyond = std::min(timeline.start_time + i * kInterval, timeline.end_time);
        if (!is_beyond(cloth, track.sample(beyond).position)) {
            inside = beyond;
            continue;
        }
        for (int halving = 0; halving < 20; ++halving) {
            const double middle = (inside + beyond) / 2;
            (is_beyond(cloth, track.sample(middle).position) ? beyond : inside) = middle;
        }
        return beyond;
    }
    return std::nullopt;
}

Problem warning_of(const std::string& ball, double time, const sim::billiards::TableMeasures& cloth,
                   const ShotSource* source) {
    const std::string message = fmt::format(
        "'{}' leaves the cloth that is drawn, {:g} m square, at {:.3f} s; it rolls on over nothing",
        ball, cloth.length, time);
    if (source != nullptr) {
        return source->problem_at({"balls", ball}, Severity::warning, message);
    }
    Problem problem;
    problem.severity = Severity::warning;
    problem.message = message;
    return problem;
}

}  // namespace

std::vector<Problem> cloth_problems(const Shot& shot, const ShotSource* source,
                                    const sim::Timeline& timeline) {
    std::vector<Problem> problems;
    if (!shot.world.table || shot.world.table->has_cushions) {
        return problems;
    }
    for (const sim::Body& body : shot.world.bodies) {
        const sim::Track* track = timeline.find(body.name);
        const bool is_ball =
            body.material == "ball" && std::holds_alternative<sim::Sphere>(body.shape);
        if (!is_ball || track == nullptr) {
            continue;
        }
        if (const auto time = leaves_at(*shot.world.table, *track, timeline)) {
            problems.push_back(warning_of(body.name, *time, *shot.world.table, source));
        }
    }
    return problems;
}

}  // namespace carom::pipeline
