// What happens when a predicted touch comes true.
#pragma once

#include <string>

#include "sim/scheduler/balls.h"
#include "sim/scheduler/predicted_event.h"
#include "sim/scheduler/stepped_bodies.h"

namespace carom::sim {

class ImpactResolver {
  public:
    ImpactResolver(const StaticEnvironment& environment, Balls& balls, SteppedBodies& stepped,
                   Recording& recording)
        : environment_(environment), balls_(balls), stepped_(stepped), recording_(recording) {}

    /// Changes the balls that the touch is about; their versions tell that they changed.
    void resolve(const PredictedEvent& event);

  private:
    void meet_ball(const PredictedEvent& event);
    void meet_box(const PredictedEvent& event);
    void meet_cushion(const PredictedEvent& event, const Vec2& nearest);
    void meet_surface(const PredictedEvent& event);
    void meet_slate_from_below(const PredictedEvent& event);
    void enter_pocket(const PredictedEvent& event);
    void sink(const PredictedEvent& event);
    void land(const PredictedEvent& event);
    void leave_lying(std::uint32_t index, double time);
    void bounce(const PredictedEvent& event, const SurfaceContact& contact,
                const SurfaceInfo& info);

    const StaticEnvironment& environment_;
    Balls& balls_;
    SteppedBodies& stepped_;
    Recording& recording_;
};

}  // namespace carom::sim
