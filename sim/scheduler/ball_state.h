// State and properties of the balls during a simulation.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/impact/ball_impact.h"
#include "sim/motion/cloth_motion.h"
#include "sim/scheduler/static_environment.h"

namespace carom::sim {

/// Friction and restitution between a ball and a horizontal surface.
struct GroundLaw {
    SupportLaw motion;
    double restitution = 0;
    double friction = 0;
};

/// A body stepped by ODE counts as moved when a point of it is this far (m) from where it last
/// rested: more than a body that is put down sinks or closes a gap.
inline constexpr double kLeastDisplacement = 2e-4;

struct Ball {
    std::string name;
    MaterialId material = MaterialId::other;
    std::size_t track = 0;  // index among the moving bodies
    double mass = 0;
    double radius = 0;
    GroundLaw cloth_law, floor_law;

    MotionSegment segment;
    Ground ground = Ground::none;  // the surface on which it moves in closed form
    bool is_lying = false;         // at rest where ODE left it, not on a Ground
    bool has_lain = false;         // since it last moved in closed form
    bool is_potted = false;
    bool is_off_table = false;
    /// Height (m) of the centre at which the ball stops, if it has left a pocket through the floor.
    /// It falls straight and touches nothing.
    std::optional<double> sinks_to;
    bool is_removed = false;    // taken off the table: it has left it, like a returned one
    bool is_warned_of = false;  // that something acts on it although it has left
    std::optional<std::size_t> flight_event;  // logged event with which its last flight began
    Vec3 rested_at{0, 0, 0};                  // its centre when it last rested, or at the start
    std::uint32_t version = 0;                // counts its segments: older predictions are invalid

    [[nodiscard]] bool is_returned() const { return sinks_to.has_value(); }
    [[nodiscard]] bool is_still() const { return segment.kind == MotionKind::resting; }
    [[nodiscard]] bool is_stepped() const { return segment.kind == MotionKind::stepped; }
    /// Whether it lies or moves on the table, or above it.
    [[nodiscard]] bool is_on_table() const { return !is_potted && !is_off_table && !is_returned(); }
    /// True if the ball moves and, if ODE steps it, has moved visibly since it last rested.
    [[nodiscard]] bool has_moved_since_rest() const;
    [[nodiscard]] BallBody body_at(double time) const {
        return {mass, radius, segment.state_at(time)};
    }
    [[nodiscard]] const GroundLaw& law_of(Ground on) const {
        return on == Ground::floor ? floor_law : cloth_law;
    }
};

/// Height of a level surface, m.
[[nodiscard]] double ground_height(Ground ground, const StaticEnvironment& environment);
[[nodiscard]] const char* ground_name(Ground ground);

/// The moving spheres of the world, in the order of its bodies.
[[nodiscard]] std::vector<Ball> make_balls(const WorldDescription& world,
                                           const StaticEnvironment& environment);

/// The segment that `ball` begins at `time` from `state`: on `ball.ground`, in flight, or on its
/// way out of a pocket.
[[nodiscard]] MotionSegment next_segment(const Ball& ball, double time, const MotionState& state,
                                         const StaticEnvironment& environment);

}  // namespace carom::sim
