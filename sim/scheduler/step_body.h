// A body that ODE carries, or may come to carry.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/pose.h"
#include "sim/ode/impact_solver.h"
#include "sim/scheduler/ball_state.h"
#include "sim/scheduler/kinematic_path.h"
#include "sim/solid_shape.h"
#include "sim/spatial/convex_distance.h"
#include "sim/spatial/convex_impact_time.h"

namespace carom::sim {

/// A body of the world that is not a ball, with what is made once for it.
struct StepSolid {
    const Body* body = nullptr;
    std::size_t track = 0;  // not of a kinematic body
    SolidShape solid;
    std::optional<KinematicPath> path;  // of a kinematic body
};

/// Holds numbers and references alone, so that all bodies are copied cheaply for every step that is
/// tried.
struct StepBody {
    const std::string* name = nullptr;  // the ball's or the world's
    MaterialId material = MaterialId::other;
    std::size_t track = 0;  // not of a kinematic body
    bool is_ball = false;
    double radius = 0;                   // of a ball
    const ConvexShape* shape = nullptr;  // of all others, along principal axes
    Quat principal{};                    // turns those into the body's own axes
    double mass = 1;
    Vec3 inertia{1, 1, 1};  // principal moments
    bool is_in = false;     // ODE's; a ball while it is stepped or lying
    bool is_awake = false;  // a kinematic body: moving
    MotionState state;      // when it is in: at the end of the last step, along principal axes
    ConvexMotion motion;    // of what is no ball during the step being tried
    double slow_since = 0;  // scene time since when it has hardly moved
    double least_speed = std::numeric_limits<double>::infinity();  // of its farthest point since
                                                                   // then, m/s
    Pose rested_at;  // of what is not a ball: where it last rested, or at the start
    const KinematicPath* path = nullptr;  // of a kinematic body
    int free_steps = 0;  // of a ball: steps since it last touched more than the ground

    [[nodiscard]] bool is_kinematic() const { return path != nullptr; }
    [[nodiscard]] bool is_box() const { return !is_ball && shape->is_box(); }
    [[nodiscard]] PlacedShape placed() const {
        return {shape, {state.position, state.orientation}};
    }
    /// A state of this body as tracks have it: the orientation of its own axes.
    [[nodiscard]] MotionState seen(const MotionState& internal) const;

    /// Radius of a sphere around the centre that holds all of it.
    [[nodiscard]] double bounding_radius() const;
    [[nodiscard]] Aabb bounds() const;
    /// A bound for the speed of any of its points, m/s.
    [[nodiscard]] double farthest_speed() const;
    /// Its time of hardly moving begins anew.
    void begin_rest(double time) {
        slow_since = time;
        least_speed = std::numeric_limits<double>::infinity();
    }
    /// It moves, and unless keys move it, it has moved visibly since it last rested. Not of a ball.
    [[nodiscard]] bool has_left() const;
    [[nodiscard]] Vec3 velocity_at(const Vec3& point) const;
    [[nodiscard]] double kinetic_energy() const;
    /// Seen from what moves with `frame`, which may turn, too.
    [[nodiscard]] double kinetic_energy_in(const MotionState& frame) const;
    [[nodiscard]] ode::ImpactBody impact_body() const;
};

static_assert(std::is_trivially_destructible_v<StepBody>);

/// The bodies of the world that move and are not balls, in its order. Refers to the world.
[[nodiscard]] std::vector<StepSolid> make_step_solids(const WorldDescription& world);

/// First the balls, then the solids. Refers to both.
[[nodiscard]] std::vector<StepBody> make_step_bodies(const std::vector<Ball>& balls,
                                                     const std::vector<StepSolid>& solids,
                                                     const ContactTable& contacts);

}  // namespace carom::sim
