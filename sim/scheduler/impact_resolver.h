// What happens when a predicted touch comes true.
#pragma once

#include <string>

#include "sim/scheduler/balls.h"
#include "sim/scheduler/stepped_bodies.h"
#include "sim/scheduler/touch_queue.h"

namespace carom::sim {

class ImpactResolver {
  public:
    ImpactResolver(const Surroundings& around, Balls& balls, SteppedBodies& stepped,
                   Recording& recording)
        : around_(around), balls_(balls), stepped_(stepped), recording_(recording) {}

    /// Changes the balls that the touch is about; their versions tell that they changed.
    void resolve(const Touch& touch);

  private:
    void meet_ball(const Touch& touch);
    void meet_box(const Touch& touch);
    void meet_cushion(const Touch& touch, const Vec2& nearest);
    void meet_surface(const Touch& touch);
    void meet_slate_from_below(const Touch& touch);
    void enter_pocket(const Touch& touch);
    void sink(const Touch& touch);
    void land(const Touch& touch);
    void leave_lying(std::uint32_t index, double time);
    void bounce(const Touch& touch, const SurfaceContact& contact, const SurfaceInfo& info);

    const Surroundings& around_;
    Balls& balls_;
    SteppedBodies& stepped_;
    Recording& recording_;
};

}  // namespace carom::sim
