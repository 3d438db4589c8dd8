// Applies the effects of predicted events to the balls.
#pragma once

#include <string>

#include "sim/scheduler/bodies.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/impact_group.h"
#include "sim/scheduler/predicted_event.h"

namespace carom::sim {

class ImpactResolver {
  public:
    ImpactResolver(const StaticEnvironment& environment, Bodies& bodies,
                   const EventPredictor& predictor, Recorder& recorder)
        : environment_(environment),
          bodies_(bodies),
          predictor_(predictor),
          recorder_(recorder),
          finder_(environment) {}

    /// Changes the balls of the event; their versions count up.
    void resolve(const PredictedEvent& event);

    /// Whether a ball in the solver may take part in this impact of two balls.
    [[nodiscard]] bool involves_solver(const PredictedEvent& event) const;

  private:
    void resolve_ball_impact(const PredictedEvent& event);
    [[nodiscard]] ImpactGroup group_of(const PredictedEvent& event) const;
    [[nodiscard]] bool reaches_obstacle(const PredictedEvent& event,
                                        const ImpactGroup& group) const;
    void leave_to_solver(const PredictedEvent& event);
    [[nodiscard]] bool reaches_ball(const PredictedEvent& event, double approach) const;

    /// Two balls of a group, by their places there, that touched each other.
    struct Touch {
        std::size_t first = 0, second = 0;
        double approach = 0;  // m/s
        Vec3 normal{0, 0, 1};
        ImpulsePair impulse;
    };
    [[nodiscard]] std::vector<Touch> hit_group(const ImpactGroup& group,
                                               std::vector<RigidBody>& after) const;
    [[nodiscard]] Touch hit_pair(const ImpactGroup& group, std::vector<RigidBody>& after) const;
    /// What an impact does to one of its balls.
    void part(std::uint32_t ball, double time, const MotionState& before, const MotionState& after,
              bool enters_solver);
    void resolve_face_impact(const PredictedEvent& event, const Vec2& centre);
    void resolve_cushion_impact(const PredictedEvent& event, const Vec2& nearest,
                                const BallCushion& cushion);
    void resolve_surface_impact(const PredictedEvent& event);
    void resolve_slate_impact(const PredictedEvent& event);
    void enter_pocket(const PredictedEvent& event);
    void cross_below_cloth(const PredictedEvent& event);
    void land(const PredictedEvent& event);
    void bounce(const PredictedEvent& event, const Contact& contact, const SurfaceInfo& info);

    struct Impact {
        double time = 0;
        double approach = 0;  // m/s
        const std::string& a;
        const std::string& b;
        Vec3 place, normal;  // as in Event
        ImpulsePair impulse;
        RigidBody first, second;  // with the means of their velocities before and after it
    };
    void record(const Impact& impact);

    const StaticEnvironment& environment_;
    Bodies& bodies_;
    const EventPredictor& predictor_;
    Recorder& recorder_;
    mutable ContactFinder finder_;  // remembers near pairs
};

}  // namespace carom::sim
