// The moving bodies and the changes of their motion, with the keys and log entries that each needs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/numeric/tolerances.h"
#include "sim/ode/impact_solver.h"
#include "sim/scheduler/ball_return.h"
#include "sim/scheduler/moving_body.h"
#include "sim/scheduler/recorder.h"

namespace carom::sim {

/// A flight that ends in ODE after less than this (s) is removed from the log: a hop of 0.1 mm
/// takes as long.
inline constexpr double kMinFlight = 0.01;

/// A ball that leaves a contact at `separation` (m/s), in the air, on a table so far off level that
/// it rolls off, or from a surface that is not vertical, may be too slow to come free: then it
/// stays in contact and enters the solver.
[[nodiscard]] bool stays_in_contact(const MovingBody& ball, double separation, const Vec3& normal);

/// The balls come first. Functions that change a motion take the scene time (s) of the change.
class Bodies {
  public:
    Bodies(const WorldDescription& world, const StaticEnvironment& environment, Recorder& recorder);

    [[nodiscard]] const std::vector<MovingBody>& all() const { return bodies_; }
    [[nodiscard]] std::span<const MovingBody> balls() const {
        return std::span(bodies_).first(ball_count_);
    }
    [[nodiscard]] std::span<const MovingBody> solids() const {
        return std::span(bodies_).subspan(ball_count_);
    }
    [[nodiscard]] MovingBody& operator[](std::uint32_t index) { return bodies_[index]; }
    [[nodiscard]] ode::ImpactSolver& impact_solver() { return impact_solver_; }

    /// Begins the first segment of every ball, on a level surface or in the air. Solids begin in
    /// the solver.
    void start(double time);

    /// The state of a ball in closed form jumps from `before` to `after`. On a level surface, a
    /// ball that moves into it bounces immediately; one that rises fast enough leaves it.
    void change_state(std::uint32_t ball, double time, const MotionState& before,
                      MotionState after);
    /// The velocities of a body jump, whatever its mode. If it sleeps, its island wakes. A ball in
    /// the solver may touch more than a level surface: ODE finds out whether it leaves its
    /// contacts.
    void change_velocities(std::uint32_t index, double time, const MotionState& before,
                           const MotionState& after);

    /// Begins the next segment from the ball's state at `time`.
    void begin_next_segment(std::uint32_t ball, double time);
    /// The ball leaves its level surface without an impact.
    void leave_ground(std::uint32_t ball, double time);

    /// From now on ODE steps the ball. Takes effect with the next window.
    void enter_solver(std::uint32_t ball, double time);
    /// The ball moves in closed form again, on `ground` or in the air.
    void leave_solver(std::uint32_t ball, double time, const MotionState& state,
                      SupportPlane ground);
    /// The body is in the solver, in its `state`, at the end of a step.
    void end_step(std::uint32_t index, double time);
    /// Sets the straight path of a body in the solver during a step that is tried.
    void set_path(std::uint32_t index, double time, const MotionState& path);
    /// The body rests where the solver left it. A body that was woken and has not moved visibly has
    /// rested all the time.
    void fall_asleep(std::uint32_t index, double time);
    /// Wakes a sleeping body; a key says that it rested until then. Has no effect on others.
    void wake(std::uint32_t index, double time);
    /// Wakes the island of a body (StepSleep) before something happens to the body.
    void wake_island(std::uint32_t index, double time);
    /// Wakes the island of a body that is about to be taken away, and those of all that may touch
    /// it.
    void wake_around(std::uint32_t index, double time);
    /// Moves the kinematic bodies to the positions of their paths.
    void move_kinematic_bodies(double time);
    /// Time of the first key of any kinematic body after `time`; infinity if there is none.
    [[nodiscard]] double next_key_time(double time) const;

    /// The ball's centre is below the cloth. Logs, the first time, that it is potted or off the
    /// table.
    void log_below_cloth(std::uint32_t ball, double time, const Vec3& centre);
    /// True if a ball leaves a pocket through its floor now: take_returned() has to follow before
    /// the time goes on.
    [[nodiscard]] bool is_return_due() const { return return_.is_due(); }
    [[nodiscard]] std::vector<BallReturn::Leaving> take_returned() { return return_.take_due(); }
    /// The ball falls out of sight through the floor of its pocket and no longer takes part.
    void leave_table(const BallReturn::Leaving& leaving, double time);
    /// The ball is put down on the cloth with its centre at `place` (seen from above), at rest.
    void put_down(std::uint32_t ball, double time, const Vec2& place);
    /// The ball is taken off the table. It rests at `place`, out of sight, and touches nothing.
    void take_off(std::uint32_t ball, double time, const Vec3& place);
    /// Warns of balls that rest over a pocket's hole, held by other balls.
    void warn_of_balls_in_pocket_mouths() const;

    void finish(double time);

    /// The balls that have begun a new segment since the last call, in ascending order.
    [[nodiscard]] std::vector<std::uint32_t> take_changed();
    /// Makes all predictions invalid: all balls count as changed.
    void invalidate_predictions();
    [[nodiscard]] std::size_t solver_count() const { return solver_count_; }
    [[nodiscard]] bool is_solver_active() const { return solver_count_ > 0; }

    void add_energy(double time, EnergySample& sample) const;
    /// Adds to EnergySample::work, J.
    void add_work(double work) { work_ += work; }
    [[nodiscard]] bool are_all_at_rest() const;

  private:
    void warn_of_gone(MovingBody& ball);
    void resolve_ground_impact(MovingBody& ball, double time, MotionState& state);
    void begin_segment(MovingBody& ball, double time, const MotionState& state, Mode mode);
    void hold(MovingBody& body, double time, const MotionState& state, MotionKind kind);
    void set_mode(MovingBody& body, Mode mode);
    void mark_changed(MovingBody& ball);
    void move_to(MovingBody& ball, double time, const Vec3& place, Mode mode);
    void retract_flight(const MovingBody& ball, double time);
    void set_segment(MovingBody& ball, const MotionSegment& segment);
    [[nodiscard]] std::uint32_t index_of(const MovingBody& body) const {
        return static_cast<std::uint32_t>(&body - bodies_.data());
    }

    const StaticEnvironment& environment_;
    Recorder& recorder_;
    std::vector<MovingBody> bodies_;
    std::size_t ball_count_;
    BallReturn return_;
    ode::ImpactSolver impact_solver_;
    std::vector<std::uint32_t> changed_;
    std::vector<char> is_changed_;  // per ball, so that none is listed twice
    std::size_t solver_count_ = 0;
    double work_ = 0;  // of kinematic bodies until now, J
};

}  // namespace carom::sim
