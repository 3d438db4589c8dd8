// Applies the effects of predicted events to the balls.
#pragma once

#include <string>

#include "sim/scheduler/balls.h"
#include "sim/scheduler/impact_group.h"
#include "sim/scheduler/predicted_event.h"
#include "sim/scheduler/stepped_bodies.h"

namespace carom::sim {

class ImpactResolver {
  public:
    ImpactResolver(const StaticEnvironment& environment, Balls& balls, SteppedBodies& stepped,
                   const EventPredictor& predictor, Recorder& recorder)
        : environment_(environment),
          balls_(balls),
          stepped_(stepped),
          predictor_(predictor),
          recorder_(recorder) {}

    /// Changes the balls of the event; their versions count up.
    void resolve(const PredictedEvent& event);

    /// Whether a ball that ODE steps may take part in this impact of two balls.
    [[nodiscard]] bool involves_stepped(const PredictedEvent& event) const;

  private:
    void resolve_ball_impact(const PredictedEvent& event);
    [[nodiscard]] ImpactGroup group_of(const PredictedEvent& event) const;
    bool resolve_group_impact(const PredictedEvent& event);
    void resolve_solid_impact(const PredictedEvent& event);
    void resolve_face_impact(const PredictedEvent& event, const Vec2& centre);
    void resolve_cushion_impact(const PredictedEvent& event, const Vec2& nearest,
                                const BallCushion& cushion);
    void resolve_surface_impact(const PredictedEvent& event);
    void resolve_slate_impact(const PredictedEvent& event);
    void enter_pocket(const PredictedEvent& event);
    void cross_below_cloth(const PredictedEvent& event);
    void land(const PredictedEvent& event);
    void wake_neighbours(std::uint32_t index, double time);
    void bounce(const PredictedEvent& event, const SurfaceContact& contact,
                const SurfaceInfo& info);

    struct Impact {
        double time = 0;
        double approach = 0;  // m/s
        const std::string& a;
        const std::string& b;
        Vec3 place, normal;  // as in Event
        ImpulsePair impulse;
        BallBody first, second;  // with the means of their velocities before and after it
    };
    void record(const Impact& impact);

    const StaticEnvironment& environment_;
    Balls& balls_;
    SteppedBodies& stepped_;
    const EventPredictor& predictor_;
    Recorder& recorder_;
};

}  // namespace carom::sim
