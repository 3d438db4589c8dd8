// Steps the bodies in the solver: solids, and balls in contact with more than a level surface.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scheduler/bodies.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recorder.h"
#include "sim/scheduler/restitution_pass.h"
#include "sim/scheduler/static_environment.h"
#include "sim/scheduler/step_sleep.h"
#include "sim/scheduler/toi_substep.h"

namespace carom::sim {

/// In every window with a body in the solver: `try_step`; then the event predictor searches for
/// impacts of balls in closed form with the stepped bodies; then `commit`, up to the first such
/// impact.
class Stepper {
  public:
    Stepper(const StaticEnvironment& environment, Bodies& bodies, Recorder& recorder);

    [[nodiscard]] bool has_trial_step() const { return has_trial_step_; }

    /// Tries a step of the bodies in the solver from `now` to `until` and sets their paths. Returns
    /// the end of the step, which is earlier if an impact or a new contact shortens it.
    double try_step(double now, double until);

    /// Cost of the trial step: the number of moving bodies plus the number of pairs of contacts,
    /// which are all solved together.
    [[nodiscard]] std::size_t step_size() const {
        return trial_.moving().size() + trial_.contacts().size() * trial_.contacts().size();
    }

    /// Applies the trial step up to `end`, which is not later than its own end.
    void commit(double end);

  private:
    void begin_window(double now);
    void resolve_impacts(const std::vector<BodyContact>& contacts, double now);
    void set_paths();
    void log_contacts();
    void finish_solid_step(std::uint32_t number, double end, bool falls_asleep);
    void finish_ball_step(std::uint32_t number, double end, bool falls_asleep);
    [[nodiscard]] SupportPlane ground_under(std::uint32_t ball, bool& touches_other) const;

    const StaticEnvironment& environment_;
    Bodies& bodies_;
    Recorder& recorder_;
    ContactFinder finder_;
    ode::StepWorld world_;
    StepSleep sleep_;
    RestitutionPass bounces_;
    ToiSubstep trial_;
    bool has_trial_step_ = false;
};

}  // namespace carom::sim
