#include "pipeline/plan/motion_phases.h"

#include <algorithm>
#include <cmath>

#include "pipeline/plan/simplify_line.h"

namespace carom::pipeline {

namespace {

constexpr double kRate = 240;        // samples per second
constexpr int kMaxSamples = 2400;    // between two keys
constexpr double kAirHeight = 1e-3;  // m
constexpr double kSlip = 0.01;       // m/s, of the contact point
constexpr double kStill = 1e-3;      // m/s

Motion motion_of(const MotionState& state, std::optional<double> radius) {
    if (state.velocity.length() < kStill) {
        return Motion::at_rest;
    }
    if (!radius) {
        return Motion::moving;
    }
    if (std::abs(state.position.z - *radius) > kAirHeight) {
        return Motion::airborne;
    }
    // v + omega x (0, 0, -R)
    const Vec2 slip(state.velocity.x - state.angular_velocity.y * *radius,
                    state.velocity.y + state.angular_velocity.x * *radius);
    return slip.length() > kSlip ? Motion::sliding : Motion::rolling;
}

Vec2 top_view(const Vec3& place) {
    return {place.x, place.y};
}

}  // namespace

std::vector<MotionPhase> motion_phases(const sim::Track& track, std::optional<double> radius,
                                       double end, double tolerance) {
    std::vector<MotionPhase> phases;
    const auto keys = track.keys();
    for (std::size_t i = 0; i + 1 < keys.size() && keys[i].time < end; ++i) {
        const double from = keys[i].time;
        const double duration = std::min(keys[i + 1].time, end) - from;
        const int samples =
            std::clamp(static_cast<int>(std::ceil(duration * kRate)), 1, kMaxSamples);
        for (int sample = 0; sample < samples; ++sample) {
            const double begin = from + duration * sample / samples;
            const double middle = from + duration * (sample + 0.5) / samples;
            const double close = from + duration * (sample + 1) / samples;
            const Motion motion = motion_of(track.sample(middle), radius);
            if (motion == Motion::at_rest) {
                continue;
            }
            const bool continues = !phases.empty() && phases.back().motion == motion &&
                                   phases.back().to >= begin - 1e-9;
            if (!continues) {
                phases.push_back({motion, begin, begin, {top_view(track.sample(begin).position)}});
            }
            phases.back().points.push_back(top_view(track.sample(close).position));
            phases.back().to = close;
        }
    }
    for (MotionPhase& phase : phases) {
        phase.points = simplified(phase.points, tolerance);
    }
    return phases;
}

}  // namespace carom::pipeline
