// The balls, and how each one's motion goes on: new segment, key, log entry.
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
/// A ball that ODE gets back sooner than this (s) did not leave what it lies or rolls on: a hop of
/// 0.1 mm takes as long.
inline constexpr double kLeastFlight = 0.01;

class Balls {
  public:
    Balls(const WorldDescription& world, const StaticEnvironment& environment,
          Recording& recording);

    [[nodiscard]] const std::vector<Ball>& all() const { return balls_; }
    [[nodiscard]] Ball& operator[](std::uint32_t index) { return balls_[index]; }
    [[nodiscard]] ode::ImpactSolver& solver() { return solver_; }

    /// Puts every ball where it starts: on what carries it, or in the air.
    void start(double time);

    /// Ball `index` went from state `before` to `after` in an instant. A ball on a level surface
    /// that is pressed into it bounces at once; one that rises fast enough leaves it.
    void change(std::uint32_t index, double time, const MotionState& before, MotionState after);

    /// The same of a ball that touches more than level ground: ODE finds out whether it leaves
    /// that.
    void change_stepped(std::uint32_t index, double time, const MotionState& before,
                        const MotionState& after);

    /// Its segment ended by itself; the next one begins.
    void go_on(std::uint32_t index, double time);

    /// It leaves what carried it without an impact.
    void fall(std::uint32_t index, double time);

    /// From now on ODE carries it. Takes effect with the next window.
    void activate(std::uint32_t index, double time);
    /// Where ODE has carried it: still ODE's ...
    void carry(std::uint32_t index, double time, const MotionState& state);
    /// ... or handed back: on level ground, in the air ...
    void deactivate(std::uint32_t index, double time, const MotionState& state, Ground ground);
    /// ... or lying still where it is.
    void put_to_rest(std::uint32_t index, double time, MotionState state);
    /// The ball's centre is below the cloth: it is potted or off the table. Written down the first
    /// time.
    void note_sunk(std::uint32_t index, double time, const Vec3& centre);
    /// Warns of balls that rest over a pocket's hole: what fell in before holds them up.
    void warn_of_jammed() const;
    /// Shows the straight path that it takes during a step that ODE is trying.
    void show_step(std::uint32_t index, double time, const MotionState& state) {
        carry(index, time, state);
    }

    void finish(double time);

    /// Those that have begun a new segment since this was asked last, in their order.
    [[nodiscard]] std::vector<std::uint32_t> take_changed();
    /// All predictions are void, and all balls count as changed.
    void void_predictions();
    /// How many ODE carries.
    [[nodiscard]] std::size_t stepped_count() const { return stepped_count_; }

    void add_energy(double time, EnergySample& sample) const;
    [[nodiscard]] bool all_rest() const;

  private:
    void settle(Ball& ball, double time, MotionState& state);
    void begin(Ball& ball, double time, const MotionState& state);
    void note_change(Ball& ball);
    void retract_flight(const Ball& ball, double time);
    void set_segment(Ball& ball, const MotionSegment& segment);

    const StaticEnvironment& environment_;
    Recording& recording_;
    std::vector<Ball> balls_;
    ode::ImpactSolver solver_;
    std::vector<std::uint32_t> changed_;
    std::vector<char> is_changed_;  // one per ball, so that none is listed twice
    std::size_t stepped_count_ = 0;
};

}  // namespace carom::sim
