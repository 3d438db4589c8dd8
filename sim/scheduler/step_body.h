// A body that ODE carries, or may come to carry.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/ode/impact_solver.h"
#include "sim/scheduler/ball_state.h"
#include "sim/spatial/box_touch.h"
#include "sim/timeline/vocabulary.h"

namespace carom::sim {

struct StepBody {
    std::string name;
    std::string material;
    std::size_t track = 0;
    bool is_ball = false;
    double radius = 0;        // of a ball
    Vec3 half_size{0, 0, 0};  // of a box, m
    double mass = 1;
    Vec3 inertia{1, 1, 1};  // principal moments
    bool is_in = false;     // ODE's; a box always, a ball while it is stepped or lying
    bool is_awake = false;
    MotionState state;      // when it is in: at the end of the last step
    BoxMotion motion;       // of a box during the step being tried
    double slow_since = 0;  // scene time since when it has hardly moved
    int free_steps = 0;     // of a ball: steps since it last touched more than the ground

    /// Radius of a sphere around the centre that holds all of it.
    [[nodiscard]] double reach() const;
    [[nodiscard]] Aabb bounds() const;
    /// A bound for the speed of any of its points, m/s.
    [[nodiscard]] double farthest_speed() const;
    [[nodiscard]] Vec3 velocity_at(const Vec3& point) const;
    [[nodiscard]] double kinetic_energy() const;
    [[nodiscard]] ode::ImpactBody impact_body() const;
};

/// First the balls in their order, then the moving boxes of the world in theirs.
[[nodiscard]] std::vector<StepBody> make_step_bodies(const WorldDescription& world,
                                                     const std::vector<Ball>& balls);

/// Where a corner of a box is, counted from 0 to 7.
[[nodiscard]] Vec3 corner_of(const StepBody& box, int corner);

}  // namespace carom::sim
