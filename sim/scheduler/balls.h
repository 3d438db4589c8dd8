// The balls and the changes of their motion, with the keys and log entries that each one needs.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/ode/impact_solver.h"
#include "sim/scheduler/ball_return.h"
#include "sim/scheduler/ball_state.h"
#include "sim/scheduler/recorder.h"

namespace carom::sim {

/// A ball that would leave a level surface more slowly than this (m/s) stays on it: it would rise
/// by 5 micrometres.
inline constexpr double kLandingSpeed = 0.01;
/// Impacts slower than this (m/s) are not logged: a ball that its spin presses against something
/// makes thousands.
inline constexpr double kLeastLoggedSpeed = 4 * kLeastSeparation;
/// A flight that ends in ODE after less than this (s) is removed from the log: a hop of 0.1 mm
/// takes as long.
inline constexpr double kLeastFlight = 0.01;

/// A ball that leaves a contact at `separation` (m/s), in the air or from a surface that is not
/// vertical, may be too slow to come free: then it stays in contact and is activated in ODE.
[[nodiscard]] bool stays_in_contact(const Ball& ball, double separation, const Vec3& normal);

class Balls {
  public:
    Balls(const WorldDescription& world, const StaticEnvironment& environment, Recorder& recorder);

    [[nodiscard]] const std::vector<Ball>& all() const { return balls_; }
    [[nodiscard]] Ball& operator[](std::uint32_t index) { return balls_[index]; }
    [[nodiscard]] ode::ImpactSolver& solver() { return solver_; }

    /// Begins the first segment of every ball, on a level surface or in the air.
    void start(double time);

    /// The state of ball `index` jumps from `before` to `after`. A ball on a level surface that
    /// moves into it bounces immediately; one that rises fast enough leaves it.
    void change_state(std::uint32_t index, double time, const MotionState& before,
                      MotionState after);

    /// As `change_state`, for a ball that touches more than a level surface: ODE finds out whether
    /// it leaves its contacts.
    void change_stepped_state(std::uint32_t index, double time, const MotionState& before,
                              const MotionState& after);

    /// Begins the next segment from the ball's state at `time`.
    void begin_next_segment(std::uint32_t index, double time);

    /// The ball leaves its level surface without an impact.
    void leave_ground(std::uint32_t index, double time);

    /// From now on ODE steps the ball. Takes effect with the next window.
    void activate(std::uint32_t index, double time);
    /// Sets the state of a ball that ODE steps.
    void set_stepped_state(std::uint32_t index, double time, const MotionState& state);
    /// The ball moves in closed form again, on `ground` or in the air.
    void deactivate(std::uint32_t index, double time, const MotionState& state, Ground ground);
    /// ODE no longer steps the ball: it rests where it is, in contact with something.
    void put_to_rest(std::uint32_t index, double time, MotionState state);
    /// The ball's centre is below the cloth. Logs, the first time, that it is potted or off the
    /// table.
    void log_below_cloth(std::uint32_t index, double time, const Vec3& centre);
    /// True if a ball leaves a pocket through its floor now: take_returned() has to follow before
    /// the time goes on.
    [[nodiscard]] bool is_return_due() const { return return_.is_due(); }
    [[nodiscard]] std::vector<BallReturn::Leaving> take_returned() { return return_.take_due(); }
    /// The ball falls out of sight through the floor of its pocket and no longer takes part.
    void leave_table(const BallReturn::Leaving& leaving, double time);
    /// The ball is put down on the cloth with its centre at `place` (seen from above), at rest.
    void put_down(std::uint32_t index, double time, const Vec2& place);
    /// The ball is taken off the table. It rests at `place`, out of sight, and touches nothing.
    void take_off(std::uint32_t index, double time, const Vec3& place);
    /// Warns of balls that rest over a pocket's hole, held by other balls.
    void warn_of_balls_in_pocket_mouths() const;
    /// Sets the straight path of the ball during a step that ODE is trying.
    void set_trial_path(std::uint32_t index, double time, const MotionState& state) {
        set_stepped_state(index, time, state);
    }

    void finish(double time);

    /// The balls that have begun a new segment since the last call, in ascending order.
    [[nodiscard]] std::vector<std::uint32_t> take_changed();
    /// Makes all predictions invalid: all balls count as changed.
    void invalidate_predictions();
    /// Number of balls that ODE steps.
    [[nodiscard]] std::size_t stepped_count() const { return stepped_count_; }

    void add_energy(double time, EnergySample& sample) const;
    [[nodiscard]] bool are_all_at_rest() const;

  private:
    void warn_of_returned(Ball& ball);
    void resolve_ground_impact(Ball& ball, double time, MotionState& state);
    void begin_segment(Ball& ball, double time, const MotionState& state);
    void mark_changed(Ball& ball);
    void move_to(Ball& ball, double time, const Vec3& place);
    void retract_flight(const Ball& ball, double time);
    void set_segment(Ball& ball, const MotionSegment& segment);

    const StaticEnvironment& environment_;
    Recorder& recorder_;
    std::vector<Ball> balls_;
    BallReturn return_;
    ode::ImpactSolver solver_;
    std::vector<std::uint32_t> changed_;
    std::vector<char> is_changed_;  // per ball, so that none is listed twice
    std::size_t stepped_count_ = 0;
};

}  // namespace carom::sim
