// The bodies that ODE steps: all solids, and balls in contact with more than a level surface.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scheduler/balls.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recorder.h"
#include "sim/scheduler/static_environment.h"
#include "sim/scheduler/step_body.h"
#include "sim/scheduler/step_bounces.h"
#include "sim/scheduler/step_sleep.h"
#include "sim/scheduler/step_trial.h"

namespace carom::sim {

/// In every window with an awake body: `try_step`; then the event predictor searches for impacts of
/// balls in closed form with the stepped bodies; then `commit`, up to the first such impact.
class SteppedBodies {
  public:
    SteppedBodies(const WorldDescription& world, const StaticEnvironment& environment, Balls& balls,
                  Recorder& recorder);

    void start(double time);

    /// Moves kinematic bodies to the positions of their paths at `time`.
    void move_kinematic_bodies(double time);
    /// Time of the first key of any kinematic body after `time`; infinity if there is none.
    [[nodiscard]] double next_key_time(double time) const;

    [[nodiscard]] bool is_active() const;
    [[nodiscard]] bool has_trial_step() const { return has_trial_step_; }
    [[nodiscard]] const std::vector<StepBody>& all() const { return bodies_; }

    /// Tries a step of the awake bodies from `now` to `until` and publishes their paths. Returns
    /// the end of the step, which is earlier if an impact or a new contact shortens it.
    double try_step(double now, double until);

    /// Cost of the trial step: the number of moving bodies plus the number of pairs of contacts,
    /// which are all solved together.
    [[nodiscard]] std::size_t step_size() const {
        return trial_.moving().size() + trial_.contacts().size() * trial_.contacts().size();
    }

    /// Applies the trial step up to `end`, which is not later than its own end.
    void commit(double end);

    /// Sets the velocities of a solid; has no effect on a kinematic one.
    void change_solid_velocity(std::uint32_t body, double time, const Vec3& velocity,
                               const Vec3& angular_velocity);

    /// Wakes the body and its island (StepSleep) if it sleeps.
    void wake(std::uint32_t body, double time) { sleep_.wake(bodies_[body], time); }

    void add_energy(EnergySample& sample) const;
    [[nodiscard]] bool are_all_at_rest() const;
    void finish(double time);

  private:
    void adopt_balls(double time);
    void publish_trial_paths();
    void cancel_step(double time);
    void log_contacts();
    void finish_solid_step(StepBody& body, double end, bool falls_asleep);
    void finish_ball_step(StepBody& body, double end, bool falls_asleep);
    [[nodiscard]] Ground ground_under(const StepBody& ball, bool& touches_other) const;

    const StaticEnvironment& environment_;
    Balls& balls_;
    Recorder& recorder_;
    ContactFinder finder_;
    std::vector<StepSolid> solids_;  // referenced by the bodies
    std::vector<StepBody> bodies_;   // first the balls in their order, then the solids
    ode::StepWorld world_;
    StepSleep sleep_;
    StepBounces bounces_;
    StepTrial trial_;
    bool has_trial_step_ = false;
};

}  // namespace carom::sim
