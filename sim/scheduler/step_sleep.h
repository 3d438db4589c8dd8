// Which of the bodies that ODE carries are awake.
#pragma once

#include <vector>

#include "sim/scheduler/balls.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recording.h"
#include "sim/scheduler/step_body.h"
#include "sim/scheduler/support.h"

namespace carom::sim {

class StepSleep {
  public:
    StepSleep(std::vector<StepBody>& bodies, Balls& balls, Recording& recording,
              const Vec3& gravity)
        : bodies_(bodies), balls_(balls), recording_(recording), gravity_(gravity) {}

    /// Its track says that it rested until then.
    void wake(StepBody& body, double time);

    /// Something happened near `place`: bodies that sleep within `reach` of it wake.
    void wake_near(const Vec3& place, double reach, double time);

    /// Wakes sleepers that something awake comes against; true if there were any.
    bool wake_by_contact(const std::vector<FoundContact>& contacts, double time);

    /// Whether a body has hardly moved, in touch with something, for long enough at `time`. What is
    /// only balanced, or touches what is, has to stay for as long as it would take to fall.
    [[nodiscard]] bool is_tired(StepBody& body, const SolvedContacts& solved, double time) const;

  private:
    [[nodiscard]] bool is_slow(const StepBody& body, int number,
                               const SolvedContacts& solved) const;
    [[nodiscard]] bool is_held_up(const StepBody& body, int number,
                                  const SolvedContacts& solved) const;

    std::vector<StepBody>& bodies_;
    Balls& balls_;
    Recording& recording_;
    Vec3 gravity_;
};

}  // namespace carom::sim
