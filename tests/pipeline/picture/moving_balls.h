// A timeline of two balls, for tests of annotations.
#pragma once

#include "sim/timeline/timeline.h"

namespace carom::testing {

inline constexpr double kRadius = 0.03;  // of both balls, m

/// "cue" rolls along +x at 2 m/s from (-1, 0), touches "one" at 0.5 s and then goes along -y at
/// 1 m/s; "one", which rested at (kRadius * sqrt(2), kRadius * sqrt(2)), goes along +y at 1 m/s.
/// Both heights are kRadius. It ends at 1 s.
[[nodiscard]] inline sim::Timeline two_balls() {
    constexpr double kHit = 0.5;
    constexpr double kDiagonal = kRadius * 1.4142135623730951;
    const auto key = [](double time, const Vec3& position, const Vec3& in, const Vec3& out) {
        sim::Key result;
        result.time = time;
        result.position = position;
        result.velocity_in = in;
        result.velocity_out = out;
        result.angular_velocity_in = result.angular_velocity_out = {0, 40, 0};
        return result;
    };
    const Vec3 rest(0);
    sim::Timeline timeline;
    timeline.end_time = 1;
    timeline.tracks.emplace_back("cue",
                                 std::vector{key(0, {-1, 0, kRadius}, {2, 0, 0}, {2, 0, 0}),
                                             key(kHit, {0, 0, kRadius}, {2, 0, 0}, {0, -1, 0}),
                                             key(1, {0, -0.5, kRadius}, {0, -1, 0}, {0, -1, 0})});
    timeline.tracks.emplace_back(
        "one", std::vector{key(0, {kDiagonal, kDiagonal, kRadius}, rest, rest),
                           key(kHit, {kDiagonal, kDiagonal, kRadius}, rest, {0, 1, 0}),
                           key(1, {kDiagonal, kDiagonal + 0.5, kRadius}, {0, 1, 0}, {0, 1, 0})});
    sim::Event impact;
    impact.time = kHit;
    impact.a = "one";
    impact.b = "cue";
    impact.place = {kDiagonal / 2, kDiagonal / 2, kRadius};
    impact.normal = Vec3(1, 1, 0).normalized();
    timeline.events = {impact};
    return timeline;
}

}  // namespace carom::testing
