// Warns of balls that leave the drawn part of a cloth without cushions.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "pipeline/check/motion_check.h"
#include "pipeline/check/placed_problem.h"

namespace carom::pipeline {

namespace {

constexpr double kSampleInterval = 1.0 / 120;  // s

/// Whether the position is outside the drawn square of the cloth.
bool is_outside(const sim::billiards::TableMeasures& cloth, const Vec3& position) {
    return std::abs(position.x) > cloth.length / 2 || std::abs(position.y) > cloth.width / 2;
}

/// The time at which the object leaves the cloth, s; empty if it never does or starts outside.
std::optional<double> find_exit_time(const sim::billiards::TableMeasures& cloth,
                                     const sim::Track& track, const sim::Timeline& timeline) {
    double inside = timeline.start_time;
    if (is_outside(cloth, track.sample(inside).position)) {
        return std::nullopt;
    }
    const auto samples =
        static_cast<int>(std::ceil((timeline.end_time - timeline.start_time) / kSampleInterval));
    for (int i = 1; i <= samples; ++i) {
        double outside = std::min(timeline.start_time + i * kSampleInterval, timeline.end_time);
        if (!is_outside(cloth, track.sample(outside).position)) {
            inside = outside;
            continue;
        }
        for (int bisection = 0; bisection < 20; ++bisection) {
            const double middle = (inside + outside) / 2;
            (is_outside(cloth, track.sample(middle).position) ? outside : inside) = middle;
        }
        return outside;
    }
    return std::nullopt;
}

Problem make_warning(const std::string& ball, double time,
                     const sim::billiards::TableMeasures& cloth, const ShotSource* source) {
    const std::string message = fmt::format(
        "'{}' leaves the drawn cloth at {:.3f} s: only a square of {:g} m is drawn, and the ball "
        "continues outside it",
        ball, time, cloth.length);
    return placed_problem(source, {"balls", ball}, Severity::warning, message);
}

}  // namespace

std::vector<Problem> cloth_problems(const Shot& shot, const ShotSource* source,
                                    const sim::Timeline& timeline) {
    std::vector<Problem> problems;
    if (!shot.world.table || shot.world.table->has_cushions || !shot.draws_table) {
        return problems;
    }
    for (const sim::Body& body : shot.world.bodies) {
        const sim::Track* track = timeline.find(body.name);
        const bool is_ball =
            body.material == "ball" && std::holds_alternative<sim::Sphere>(body.shape);
        if (!is_ball || track == nullptr) {
            continue;
        }
        if (const auto time = find_exit_time(*shot.world.table, *track, timeline)) {
            problems.push_back(make_warning(body.name, *time, *shot.world.table, source));
        }
    }
    return problems;
}

}  // namespace carom::pipeline
