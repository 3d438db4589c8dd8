// The balls that take part in an impact of two, for group_impact().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/length.h"
#include "sim/impact/group_impact.h"
#include "sim/scheduler/event_predictor.h"

namespace carom::sim {

/// Two balls of a group, without their indices.
[[nodiscard]] TouchingPair touching_pair(const StaticEnvironment& environment, const MovingBody& a,
                                         const MovingBody& b, const Vec3& normal);

/// Of balls with each other and with anything else. `reduced_radius`: as in hertz_stiffness().
[[nodiscard]] ContactStiffness ball_stiffness(double reduced_radius);

/// Of each of the points at which flat sides touch: a prism of plastic or of wood along its fibres
/// (3 GPa) that is as high as wide, of 33 mm. No measurement was looked for; ours.
inline constexpr ContactStiffness kFlatStiffness{1e8, true};

struct ImpactGroup {
    std::vector<std::uint32_t> indices;  // in Bodies; first the two that meet
    std::vector<RigidBody> balls;        // in the same order, without their orientations
    std::vector<GroupContact> contacts;  // first that of the two; empty if only they take part

    /// Of the two that meet: from the second to the first, and how fast they approach (m/s).
    [[nodiscard]] Vec3 normal() const {
        return unit(balls[0].state.position - balls[1].state.position);
    }
    [[nodiscard]] double approach() const {
        return -(balls[0].state.velocity - balls[1].state.velocity).dot(normal());
    }
};

/// The entry of ContactLaw::pairs that names these two balls instead of two materials, or nullptr.
[[nodiscard]] const PairContact* named_law(const StaticEnvironment& environment,
                                           const MovingBody& a, const MovingBody& b);

/// Restitution and friction of two balls that collide with surfaces slipping at `slip_speed` (m/s).
[[nodiscard]] ContactCoefficients pair_law(const StaticEnvironment& environment,
                                           const MovingBody& a, const MovingBody& b,
                                           double slip_speed);

/// The balls `first` and `second`, which meet at `time`, and those that may touch one of them,
/// directly or through others, while they compress each other. Only the two if they meet at
/// kMinLoggedSpeed or slower.
[[nodiscard]] ImpactGroup find_impact_group(std::span<const MovingBody> balls, std::uint32_t first,
                                            std::uint32_t second, double time,
                                            const EventPredictor& predictor,
                                            const StaticEnvironment& environment);

}  // namespace carom::sim
