// An isolated impact, solved by ODE: two bodies with one contact and nothing else in the world.
#pragma once

#include <memory>

#include "core/pose.h"

namespace carom::sim::ode {

struct Velocities {
    Vec3 linear{0, 0, 0};   // m/s
    Vec3 angular{0, 0, 0};  // rad/s, world axes
};

/// The properties and state of a body in an impact.
struct ImpactBody {
    double mass = 1;        // kg
    Vec3 inertia{1, 1, 1};  // principal moments, kg m^2
    Pose pose;              // body axes are the principal ones
    Velocities velocities;
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
    [[nodiscard]] ImpactResult solve(const ImpactBody& first, const ImpactBody& second,
                                     const ImpactContact& contact);

    /// Impact with a static obstacle; `second` of the result is zero.
    [[nodiscard]] ImpactResult solve_static(const ImpactBody& first, const ImpactContact& contact);

    /// Impact with a kinematic body, which moves at `velocity` (m/s) at the contact and keeps it.
    [[nodiscard]] ImpactResult solve_kinematic(const ImpactBody& first, const Vec3& velocity,
                                               const ImpactContact& contact);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::sim::ode
