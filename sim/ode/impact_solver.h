// An isolated impact, solved by ODE: two bodies with one contact and nothing else in the world.
#pragma once

#include <memory>

#include "sim/motion/contact.h"
#include "sim/motion/rigid_body.h"

namespace carom::sim::ode {

struct ImpactResult {
    Velocities first, second;
    ImpulsePair impulse;
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
                                     const Contact& contact, double restitution, double friction);

    /// Impact with a static obstacle; `second` of the result is zero.
    [[nodiscard]] ImpactResult solve_static(const RigidBody& first, const Contact& contact,
                                            double restitution, double friction);

    /// Impact with a kinematic body, which moves at `velocity` (m/s) at the contact and keeps it.
    [[nodiscard]] ImpactResult solve_kinematic(const RigidBody& first, const Vec3& velocity,
                                               const Contact& contact, double restitution,
                                               double friction);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::sim::ode
