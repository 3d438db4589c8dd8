// What ODE carries: boxes, and balls in touch with more than level ground.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/ode/impact_solver.h"
#include "sim/ode/step_world.h"
#include "sim/scheduler/balls.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recording.h"
#include "sim/scheduler/step_body.h"
#include "sim/scheduler/surroundings.h"

namespace carom::sim {

/// Every window with something awake: `try_step`, then ball by ball the closed forms look whether
/// they meet what ODE carries, then `commit` up to the first such meeting.
class SteppedBodies {
  public:
    SteppedBodies(const WorldDescription& world, const Surroundings& around, Balls& balls,
                  Recording& recording);

    void start(double time);

    [[nodiscard]] bool is_active() const;
    [[nodiscard]] bool is_trying() const { return is_trying_; }
    [[nodiscard]] const std::vector<StepBody>& all() const { return bodies_; }

    /// Moves what is awake from `now` to `until` on trial and shows the paths. Where bodies meet
    /// that were apart, earlier: the time that is returned is the step's end.
    double try_step(double now, double until);

    /// Makes the trial true up to `end`, no later than the trial's own.
    void commit(double end);

    /// A box's velocities changed in an instant.
    void change_box(std::uint32_t body, double time, const Vec3& velocity,
                    const Vec3& angular_velocity);

    /// Something happened near `place`: bodies that sleep within `reach` of it wake.
    void wake_near(const Vec3& place, double reach, double time);

    [[nodiscard]] MotionState box_state(std::uint32_t body) const { return bodies_[body].state; }
    void add_energy(EnergySample& sample) const;
    [[nodiscard]] bool all_rest() const;
    void finish(double time);

  private:
    void adopt_balls(double time);
    void choose_moving();
    void solve(double duration);
    [[nodiscard]] double share_until_touch() const;
    void record(std::size_t slot, double end);
    void log_touches();
    void settle(std::uint32_t body, double end);
    void settle_ball(StepBody& body, double end);
    void wake_by_touch(double time);
    void bounce_balls(double time);
    void bounce(const FoundContact& found, double time);
    void take(StepBody& body, const ode::Velocities& velocities, double time);
    [[nodiscard]] double approach(const FoundContact& found) const;
    void wake(StepBody& body, double time);

    const Surroundings& around_;
    Balls& balls_;
    Recording& recording_;
    ContactFinder finder_;
    ode::StepWorld world_;
    std::vector<StepBody> bodies_;  // first the balls in their order, then the boxes

    // The step being tried.
    bool is_trying_ = false;
    double step_start_ = 0;
    double step_end_ = 0;
    std::vector<int> moving_;
    std::vector<MotionState> states_;
    std::vector<FoundContact> contacts_;
    std::vector<ode::StepContact> step_contacts_;
    std::vector<ode::StepMotion> motions_;
    std::vector<ode::StepImpulse> impulses_;
    std::map<std::pair<int, int>, bool> last_pairs_;  // in touch during the last step
};

}  // namespace carom::sim
