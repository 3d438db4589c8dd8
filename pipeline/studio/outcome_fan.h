// How sure the outcome of a shot is: the same shot several times, with small disturbances.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/message_lists.h"
#include "pipeline/studio/motion_messages.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// The disturbances of one run: what Fan says, with the signs and directions of this run.
struct Disturbance {
    Vec2 displacement{0, 0};  // of struck balls, m
    double turn = 0;          // of directions about the vertical, rad
};

/// Those of run `run` (from 0) of `runs`. The displacements point into directions that divide a
/// full turn evenly; the angles fill [-angle, angle] evenly.
[[nodiscard]] Disturbance disturbance_of(int run, const Fan& fan);

/// The world with its struck balls displaced and its strikes, impulses, forces and velocities
/// turned. `timeline`: the motion without disturbances, which says where a strike aims.
[[nodiscard]] sim::WorldDescription disturbed(const sim::WorldDescription& world,
                                              const sim::Timeline& timeline,
                                              const Disturbance& disturbance);

/// The paths and the counts of the finished runs.
[[nodiscard]] Numbers<FanHead> fan_message(const std::vector<sim::Timeline>& runs);

/// Simulates in a thread of its own. All functions may be called from any thread.
class OutcomeFan {
  public:
    /// Called from that thread.
    using Send = std::function<void(const ServerMessage& message)>;
    using SendNumbers =
        std::function<void(const FanHead& head, const std::vector<double>& numbers)>;

    OutcomeFan(SendNumbers answer, Send failed);
    /// Stops all work and waits for its end.
    ~OutcomeFan();
    OutcomeFan(const OutcomeFan&) = delete;
    OutcomeFan& operator=(const OutcomeFan&) = delete;
    OutcomeFan(OutcomeFan&&) = delete;
    OutcomeFan& operator=(OutcomeFan&&) = delete;

    /// The newest shot and its motion.
    void set_shot(std::shared_ptr<const pipeline::Shot> shot,
                  std::shared_ptr<const sim::Timeline> timeline, std::int64_t v);

    /// The newest question is the only one. It waits for the shot of its version.
    void ask(const Fan& question);

    /// Ends the question and stops its work.
    void cancel();

  private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace carom::studio
