// What ODE carries: boxes, and balls in touch with more than level ground.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scheduler/balls.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recording.h"
#include "sim/scheduler/static_environment.h"
#include "sim/scheduler/step_body.h"
#include "sim/scheduler/step_bounces.h"
#include "sim/scheduler/step_sleep.h"
#include "sim/scheduler/step_trial.h"

namespace carom::sim {

/// Every window with something awake: `try_step`, then ball by ball the closed forms look whether
/// they meet what ODE carries, then `commit` up to the first such meeting.
class SteppedBodies {
  public:
    SteppedBodies(const WorldDescription& world, const StaticEnvironment& environment, Balls& balls,
                  Recording& recording);

    void start(double time);

    /// Kinematic bodies are where their paths have them.
    void follow_paths(double time);
    /// When the first of them comes to a key after `time`; else infinite.
    [[nodiscard]] double next_key(double time) const;

    [[nodiscard]] bool is_active() const;
    [[nodiscard]] bool is_trying() const { return is_trying_; }
    [[nodiscard]] const std::vector<StepBody>& all() const { return bodies_; }

    /// Moves what is awake from `now` to `until` on trial and shows the paths. Where bodies meet
    /// that were apart, earlier: the time that is returned is the step's end.
    double try_step(double now, double until);

    /// How many bodies the trial moves, and how many pairs there are among their contacts, which
    /// are all solved for at once: what a step costs grows with these.
    [[nodiscard]] std::size_t step_size() const {
        return trial_.moving().size() + trial_.contacts().size() * trial_.contacts().size();
    }

    /// Makes the trial true up to `end`, no later than the trial's own.
    void commit(double end);

    /// A box's velocities changed in an instant; those of a kinematic one do not.
    void change_box(std::uint32_t body, double time, const Vec3& velocity,
                    const Vec3& angular_velocity);

    /// Something happened near `place`: bodies that sleep within `reach` of it wake.
    void wake_near(const Vec3& place, double reach, double time) {
        sleep_.wake_near(place, reach, time);
    }

    [[nodiscard]] MotionState box_state(std::uint32_t body) const { return bodies_[body].state; }
    void add_energy(EnergySample& sample) const;
    [[nodiscard]] bool all_rest() const;
    void finish(double time);

  private:
    void adopt_balls(double time);
    void show_paths();
    void stay(double time);
    void settle_box(StepBody& body, double end);
    void settle_ball(StepBody& body, double end);
    [[nodiscard]] Ground ground_under(const StepBody& ball, bool& touches_other) const;

    const StaticEnvironment& environment_;
    Balls& balls_;
    Recording& recording_;
    ContactFinder finder_;
    std::vector<StepSolid> solids_;  // which the bodies refer to
    std::vector<StepBody> bodies_;   // first the balls in their order, then the boxes
    ode::StepWorld world_;
    StepSleep sleep_;
    StepBounces bounces_;
    StepTrial trial_;
    bool is_trying_ = false;
};

}  // namespace carom::sim
