// Which touches lie ahead of a ball.
#pragma once

#include <vector>

#include "sim/scheduler/ball_state.h"
#include "sim/scheduler/step_body.h"
#include "sim/scheduler/surroundings.h"
#include "sim/scheduler/touch_queue.h"

namespace carom::sim {

class TouchFinder {
  public:
    TouchFinder(const Surroundings& around, const std::vector<Ball>& balls,
                const std::vector<StepBody>& bodies)
        : around_(around), balls_(balls), bodies_(bodies) {}

    /// Puts every touch of ball `index` in [now, until] into the queue. With `only_later_balls`,
    /// of the other moving balls only those of a higher index are looked at (the lower ones have
    /// been asked already).
    void find(std::uint32_t index, double now, double until, bool only_later_balls,
              TouchQueue& queue) const;

  private:
    void find_balls(std::uint32_t index, double now, double until, bool only_later_balls,
                    TouchQueue& queue) const;
    void find_boxes(std::uint32_t index, double now, double until, TouchQueue& queue) const;
    void find_fixed(std::uint32_t index, double now, double until, TouchQueue& queue) const;
    void find_on_cloth(std::uint32_t index, double now, double until, TouchQueue& queue) const;
    void find_in_air(std::uint32_t index, double now, double until, TouchQueue& queue) const;

    const Surroundings& around_;
    const std::vector<Ball>& balls_;
    const std::vector<StepBody>& bodies_;
};

/// How far from the nose's line (horizontally) the centre of a ball at height `z` is when it
/// touches; 0 if it passes above or below.
[[nodiscard]] double nose_reach(double radius, double z, double nose_height);

}  // namespace carom::sim
