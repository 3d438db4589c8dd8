// The balls, and how each one's motion goes on: new stretch, key, log entry.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/ode/impact_solver.h"
#include "sim/scheduler/ball_state.h"
#include "sim/scheduler/recording.h"

namespace carom::sim {

/// A ball that would leave a level surface more slowly than this stays on it (m/s): it would rise
/// by 5 micrometres.
inline constexpr double kLandingSpeed = 0.01;
/// Impacts at less than this (m/s) are not written down: a ball that its spin presses against
/// something makes thousands.
inline constexpr double kQuietSpeed = 4 * kLeastSeparation;

class Balls {
  public:
    Balls(const WorldDescription& world, const Surroundings& around, Recording& recording);

    [[nodiscard]] const std::vector<Ball>& all() const { return balls_; }
    [[nodiscard]] Ball& operator[](std::uint32_t index) { return balls_[index]; }
    [[nodiscard]] ode::ImpactSolver& solver() { return solver_; }

    /// Puts every ball where it starts: on what carries it, or in the air.
    void start(double time);

    /// Ball `index` went from state `before` to `after` in an instant. A ball on a level surface
    /// that is pressed into it bounces at once; one that rises fast enough leaves it.
    void change(std::uint32_t index, double time, const MotionState& before, MotionState after);

    /// Its stretch ended by itself; the next one begins.
    void go_on(std::uint32_t index, double time);

    /// It leaves what carried it without an impact.
    void fall(std::uint32_t index, double time);

    void finish(double time);

    [[nodiscard]] EnergySample energy(double time) const;
    [[nodiscard]] bool all_rest() const;

  private:
    void settle(Ball& ball, double time, MotionState& state);
    void begin(Ball& ball, double time, const MotionState& state);

    const Surroundings& around_;
    Recording& recording_;
    std::vector<Ball> balls_;
    ode::ImpactSolver solver_;
};

}  // namespace carom::sim
