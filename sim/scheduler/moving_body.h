// A body that moves: a ball, or a solid that the simulation or its keys move.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/motion/cloth_motion.h"
#include "sim/motion/rigid_body.h"
#include "sim/scheduler/kinematic_path.h"
#include "sim/scheduler/static_environment.h"
#include "sim/spatial/convex_distance.h"
#include "sim/spatial/convex_impact_time.h"
#include "sim/timeline/event.h"

namespace carom::sim {

/// Friction and restitution between a ball and a horizontal surface.
struct SurfaceCoefficients {
    FrictionCoefficients motion;
    double restitution = 0;
    double friction = 0;
    bool lets_balls_go = false;  // it is so far off level that no ball rests on it
};

enum class Mode : std::uint8_t {
    closed_form,  // a ball on a level surface or in the air
    solver,       // ODE steps it; a kinematic body: its path moves it
    asleep,       // at rest where the solver left it; a kinematic body: its path stands still
    gone,         // a ball that was taken off or leaves through a pocket's floor: touches nothing
};

/// Its `state` is meaningful in the solver and asleep: at the start of the current window.
struct MovingBody : RigidBody {
    Mode mode = Mode::closed_form;  // beside the state: most loops over all bodies read both
    const Body* description = nullptr;
    MaterialId material = MaterialId::other;
    std::size_t track = 0;  // index among the tracks; unused for a kinematic body
    std::shared_ptr<const ConvexShape> shape;  // along principal axes; none for a ball
    Quat principal{};                          // turns the principal axes into the body's own axes
    std::optional<KinematicPath> path;         // for a kinematic body
    /// R + I / (m R) of a body that rolls (m), R its radius and I its moment of inertia about the
    /// axis of rolling; 0 for others. A resisting moment of mu times this times the normal force
    /// decelerates a body that rolls without slip by mu g.
    double rolling_length = 0;

    /// Its motion in closed form; in the solver its straight path during the step that is tried.
    MotionSegment segment;
    std::uint32_t version = 0;  // for a ball: counts its segments; older predictions are invalid
    Pose rested_at;             // where it last rested, or its start
    bool has_rested = false;    // in the solver, since it last moved in closed form

    // In the solver:
    double slow_since = 0;    // scene time since when it has hardly moved
    Pose slow_at;             // where it was then
    bool is_restless = true;  // has moved in the last step, or is about to
    /// Least value of max_point_speed() since then, m/s.
    double least_speed = std::numeric_limits<double>::infinity();
    std::uint32_t island = 0;  // of the sleeping bodies that it touches; 0: none
    bool was_stepped = false;  // in the last step
    int free_steps = 0;        // for a ball: steps since it last touched more than a Ground

    // Of balls:
    SurfaceCoefficients cloth_law, floor_law;
    SupportPlane ground = SupportPlane::none;  // the surface on which it moves in closed form
    bool is_potted = false;
    bool is_off_table = false;
    double sinks_to = 0;        // height (m) of the centre at which the ball stops if it is gone
    bool is_removed = false;    // gone because it was taken off the table
    bool is_warned_of = false;  // that something acts on it although it is gone
    std::optional<std::size_t> flight_event;  // logged event with which its last flight began

    [[nodiscard]] const std::string& name() const { return description->name; }
    [[nodiscard]] bool is_kinematic() const { return path.has_value(); }
    [[nodiscard]] bool is_box() const { return shape != nullptr && shape->is_box(); }
    [[nodiscard]] bool is_in_solver() const { return mode == Mode::solver; }
    [[nodiscard]] bool is_asleep() const { return mode == Mode::asleep; }
    [[nodiscard]] bool is_gone() const { return mode == Mode::gone; }
    [[nodiscard]] bool is_still() const { return segment.kind == MotionKind::resting; }
    /// Whether a ball lies or moves on the table, or above it.
    [[nodiscard]] bool is_on_table() const { return !is_potted && !is_off_table && !is_gone(); }
    /// True if the body moves and, if ODE steps it, has moved visibly since it last rested.
    [[nodiscard]] bool has_moved_since_rest() const;

    /// Its state between two windows, or in the middle of one for a ball in closed form.
    [[nodiscard]] MotionState state_at(double time) const {
        return is_ball() ? segment.state_at(time) : state;
    }
    [[nodiscard]] RigidBody rigid_at(double time) const {
        return {mass, inertia, radius, segment.state_at(time)};
    }
    /// A state as tracks store it: with the orientation of the body's own axes instead of the
    /// principal ones.
    [[nodiscard]] MotionState with_own_axes(const MotionState& internal) const;
    [[nodiscard]] PlacedShape placed(const MotionState& at) const {
        return {shape.get(), {at.position, at.orientation}};
    }
    /// The path of a solid during the step that is tried.
    [[nodiscard]] ConvexMotion motion() const {
        return {shape.get(), segment.start, segment.state};
    }
    /// Radius of a sphere around the centre that contains the body.
    [[nodiscard]] double bounding_radius() const {
        return is_ball() ? radius : shape->bounding_radius();
    }
    /// An upper bound for the speed of any of its points, m/s.
    [[nodiscard]] double max_point_speed() const;
    [[nodiscard]] const SurfaceCoefficients& law_of(SupportPlane on) const {
        return on == SupportPlane::floor ? floor_law : cloth_law;
    }
    /// How far (m) a point of it can be from where it was in `pose`, both in the solver.
    [[nodiscard]] double distance_from(const Pose& pose) const;
    /// Restarts the time during which it has hardly moved.
    void restart_rest_timer(double time) {
        slow_since = time;
        slow_at = {state.position, state.orientation};
        least_speed = std::numeric_limits<double>::infinity();
    }
    void add_energy(double time, const Vec3& gravity, EnergySample& sample) const;
};

/// Height of a level surface, m.
[[nodiscard]] double ground_height(SupportPlane ground, const StaticEnvironment& environment);
[[nodiscard]] const char* ground_name(SupportPlane ground);

/// The moving bodies of the world: first the balls, then all others, both in the order of its
/// bodies. The result refers to the world.
[[nodiscard]] std::vector<MovingBody> make_moving_bodies(const WorldDescription& world,
                                                         const StaticEnvironment& environment);

/// The segment that `ball` begins at `time` from `state`: on `ball.ground`, in flight, or on its
/// way out of a pocket.
[[nodiscard]] MotionSegment next_segment(const MovingBody& ball, double time,
                                         const MotionState& state,
                                         const StaticEnvironment& environment);

}  // namespace carom::sim
