// A body that ODE steps, or may step later.
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

/// A body of the world that is not a ball, with the data that is computed once for it.
struct StepSolid {
    const Body* body = nullptr;
    std::size_t track = 0;  // unused for a kinematic body
    SolidShape solid;
    std::optional<KinematicPath> path;  // for a kinematic body
};

/// Holds only numbers and references, so that copying all bodies for every trial step is cheap.
struct StepBody {
    const std::string* name = nullptr;  // owned by the ball or the world
    MaterialId material = MaterialId::other;
    std::size_t track = 0;  // unused for a kinematic body
    bool is_ball = false;
    double radius = 0;                   // for a ball
    const ConvexShape* shape = nullptr;  // for all other bodies, along principal axes
    Quat principal{};                    // turns the principal axes into the body's own axes
    double mass = 1;
    Vec3 inertia{1, 1, 1};   // principal moments
    bool is_in_ode = false;  // for a ball: while it is stepped or lying
    bool is_awake = false;   // for a kinematic body: while it moves
    MotionState state;       // in ODE: at the end of the last step, along principal axes
    ConvexMotion motion;     // during the trial step; not for a ball
    double slow_since = 0;   // scene time since when it has hardly moved
    /// Least value of max_point_speed() since then, m/s.
    double least_speed = std::numeric_limits<double>::infinity();
    Pose rested_at;                       // where it last rested, or its start; not for a ball
    bool has_rested = false;              // not for a ball
    std::uint32_t island = 0;             // with which it last fell asleep
    const KinematicPath* path = nullptr;  // for a kinematic body
    int free_steps = 0;  // for a ball: steps since it last touched more than a Ground

    [[nodiscard]] bool is_kinematic() const { return path != nullptr; }
    [[nodiscard]] bool is_box() const { return !is_ball && shape->is_box(); }
    [[nodiscard]] PlacedShape placed() const {
        return {shape, {state.position, state.orientation}};
    }
    /// A state as tracks store it: with the orientation of the body's own axes instead of the
    /// principal ones.
    [[nodiscard]] MotionState with_own_axes(const MotionState& internal) const;

    /// Radius of a sphere around the centre that contains the body.
    [[nodiscard]] double bounding_radius() const;
    [[nodiscard]] Aabb bounds() const;
    /// An upper bound for the speed of any of its points, m/s.
    [[nodiscard]] double max_point_speed() const;
    /// Restarts the time during which it has hardly moved.
    void restart_rest_timer(double time) {
        slow_since = time;
        least_speed = std::numeric_limits<double>::infinity();
    }
    /// True if it moves and, unless it is kinematic, has moved visibly since it last rested. Not
    /// for a ball.
    [[nodiscard]] bool has_moved_since_rest() const;
    [[nodiscard]] Vec3 velocity_at(const Vec3& point) const;
    [[nodiscard]] double kinetic_energy() const;
    /// Kinetic energy relative to a frame that moves and turns with `frame`.
    [[nodiscard]] double kinetic_energy_in(const MotionState& frame) const;
    [[nodiscard]] ode::ImpactBody impact_body() const;
};

static_assert(std::is_trivially_destructible_v<StepBody>);

/// The moving bodies of the world that are not balls, in the order of its bodies. The result refers
/// to the world.
[[nodiscard]] std::vector<StepSolid> make_step_solids(const WorldDescription& world);

/// First the balls, then the solids. The result refers to both.
[[nodiscard]] std::vector<StepBody> make_step_bodies(const std::vector<Ball>& balls,
                                                     const std::vector<StepSolid>& solids,
                                                     const ContactTable& contacts);

}  // namespace carom::sim
