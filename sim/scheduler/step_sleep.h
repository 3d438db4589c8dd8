// Decides which of the bodies in ODE sleep and which are awake.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scheduler/bodies.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/support.h"

namespace carom::sim {

/// A body falls asleep when it and all that it touches have hardly moved for long enough, so that
/// what has come to rest costs nothing while other parts of its island still move: a row of
/// dominoes would cost the cube of its length. It wakes when something that it touches moves,
/// however slowly, by more than 50 micrometres. Sleeping bodies that touch each other, directly or
/// through others, are an island, which wakes as one when something happens to one of them, and
/// what a kinematic body moves stays awake with all of its island, so that no sleeping body rests
/// on one that moves. Kinematic bodies and the static environment belong to no island.
class StepSleep {
  public:
    StepSleep(Bodies& bodies, const Vec3& gravity) : bodies_(bodies), gravity_(gravity) {}

    /// Wakes the bodies that one which moves touches; true if there were any.
    bool wake_by_contact(const std::vector<BodyContact>& contacts, double time);

    /// The bodies of `moving` that fall asleep at `time`, the end of a step, in ascending order.
    /// One that is only balanced has to stay for as long as it would take to fall.
    [[nodiscard]] std::vector<int> falling_asleep(const std::vector<int>& moving,
                                                  const SolvedContacts& solved, double time);

  private:
    void update_rest_timers(const std::vector<int>& moving, const SolvedContacts& solved,
                            double time);
    void leave_island(int number, double time);
    void join_islands(const std::vector<int>& asleep, const SolvedContacts& solved);
    [[nodiscard]] bool is_movable(int number);
    /// Whether the body sleeps or has hardly moved for long enough.
    [[nodiscard]] bool is_quiet(int number, double time);
    [[nodiscard]] bool is_held(int number, const SolvedContacts& solved,
                               std::span<const std::size_t> own, double time);

    [[nodiscard]] MovingBody& body(int number) {
        return bodies_[static_cast<std::uint32_t>(number)];
    }

    Bodies& bodies_;
    Vec3 gravity_;
    std::uint32_t island_count_ = 0;  // that there have been
};

}  // namespace carom::sim
