// Decides which of the bodies in ODE sleep and which are awake.
#pragma once

#include <vector>

#include "sim/scheduler/balls.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recorder.h"
#include "sim/scheduler/step_body.h"
#include "sim/scheduler/support.h"

namespace carom::sim {

class StepSleep {
  public:
    StepSleep(std::vector<StepBody>& bodies, Balls& balls, Recorder& recorder, const Vec3& gravity)
        : bodies_(bodies), balls_(balls), recorder_(recorder), gravity_(gravity) {}

    /// Wakes a body; a key says that it rested until then.
    void wake(StepBody& body, double time);

    /// Wakes the sleeping bodies within `distance` of `position`, and their neighbours.
    void wake_near(const Vec3& position, double distance, double time);

    /// Wakes sleeping bodies that a waking one approaches in contact; true if there were any.
    bool wake_by_contact(const std::vector<BodyContact>& contacts, double time);

    /// True if a body has hardly moved, in contact with something, for long enough at `time`. A
    /// body that is only balanced, or touches one that is, has to stay for as long as it would take
    /// to fall.
    [[nodiscard]] bool can_fall_asleep(StepBody& body, const SolvedContacts& solved,
                                       double time) const;

  private:
    [[nodiscard]] bool is_slow_in_contact(const StepBody& body, int number,
                                          const SolvedContacts& solved) const;
    [[nodiscard]] bool is_supported_with_neighbours(const StepBody& body, int number,
                                                    const SolvedContacts& solved) const;

    std::vector<StepBody>& bodies_;
    Balls& balls_;
    Recorder& recorder_;
    Vec3 gravity_;
};

}  // namespace carom::sim
