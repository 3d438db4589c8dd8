// An isolated impact, solved by ODE: two bodies with one contact and nothing else in the world.
#pragma once

#include <memory>

#include "sim/motion/rigid_body.h"

namespace carom::sim::ode {

struct Velocities {
    Vec3 linear{0, 0, 0};   // m/s
    Vec3 angular{0, 0, 0};  // rad/s, world axes
};

struct ImpactContact {
    Vec3 point{0, 0, 0};
    Vec3 normal{0, 0, 1};  // unit, from the second body towards the first
    double restitution = 0;
    double friction = 0;
};

struct ImpactResult {
    Velocities first, second;
    double normal_impulse = 0;      // N s
    double tangential_impulse = 0;  // N s
};

/// Solves impacts in a small ODE world of its own (docs/physics.md): exact normal, depth 0, no
/// gravity, no softness, friction direction along the slip, friction limited by the normal impulse.
/// One per thread.
class ImpactSolver {
  public:
    ImpactSolver();
    ~ImpactSolver();
    ImpactSolver(const ImpactSolver&) = delete;
    ImpactSolver& operator=(const ImpactSolver&) = delete;

    /// The velocities after the impact. The bodies have to approach each other at the contact.
    [[nodiscard]] ImpactResult solve(const RigidBody& first, const RigidBody& second,
                                     const ImpactContact& contact);

    /// Impact with a static obstacle; `second` of the result is zero.
    [[nodiscard]] ImpactResult solve_static(const RigidBody& first, const ImpactContact& contact);

    /// Impact with a kinematic body, which moves at `velocity` (m/s) at the contact and keeps it.
    [[nodiscard]] ImpactResult solve_kinematic(const RigidBody& first, const Vec3& velocity,
                                               const ImpactContact& contact);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::sim::ode
