// Decides which of the bodies in ODE sleep and which are awake.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scheduler/bodies.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/support.h"

namespace carom::sim {

/// Bodies that touch each other, directly or through others, are an island. It falls asleep and
/// wakes as one, so that no sleeping body rests on one that moves (the rule of box3d,
/// src/solver_set.c). Kinematic bodies and the static environment belong to no island.
class StepSleep {
  public:
    StepSleep(Bodies& bodies, const Vec3& gravity) : bodies_(bodies), gravity_(gravity) {}

    /// Wakes the islands that a waking body touches, however slowly; true if there were any.
    bool wake_by_contact(const std::vector<BodyContact>& contacts, double time);

    /// The islands of `moving` that fall asleep at `time`, the end of a step: each body of them has
    /// hardly moved, in contact with something, for long enough. A body that is only balanced has
    /// to stay for as long as it would take to fall. Returns their bodies in ascending order.
    [[nodiscard]] std::vector<int> falling_asleep(const std::vector<int>& moving,
                                                  const SolvedContacts& solved, double time);

  private:
    void update_rest_timers(const std::vector<int>& moving, const SolvedContacts& solved,
                            double time);
    [[nodiscard]] bool is_movable(int number);
    [[nodiscard]] bool is_held(int number, const SolvedContacts& solved,
                               std::span<const std::size_t> own, double time);

    [[nodiscard]] MovingBody& body(int number) {
        return bodies_[static_cast<std::uint32_t>(number)];
    }

    Bodies& bodies_;
    Vec3 gravity_;
    std::uint32_t island_count_ = 0;  // that have fallen asleep
};

}  // namespace carom::sim
