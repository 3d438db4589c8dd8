// One isolated impact, solved by ODE: two bodies, one contact, nothing else in the world.
#pragma once

#include <memory>

#include "core/pose.h"

namespace carom::sim::ode {

struct Velocities {
    Vec3 linear{0, 0, 0};   // m/s
    Vec3 angular{0, 0, 0};  // rad/s, world axes
};

/// What an impact needs to know of a body.
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

/// Solves impacts in a small ODE world of its own, as PHYSICS describes it: exact normal, depth 0,
/// no gravity, no softness, friction direction along the slip, friction limited by the normal
/// impulse. One per thread.
class ImpactSolver {
  public:
    ImpactSolver();
    ~ImpactSolver();
    ImpactSolver(const ImpactSolver&) = delete;
    ImpactSolver& operator=(const ImpactSolver&) = delete;

    /// The two velocities behind the impact. The bodies must be approaching at the contact.
    [[nodiscard]] ImpactResult solve(const ImpactBody& first, const ImpactBody& second,
                                     const ImpactContact& contact);

    /// The same against something that does not move; `second` of the result stays zero.
    [[nodiscard]] ImpactResult solve_static(const ImpactBody& first, const ImpactContact& contact);

    /// The same against something that moves on unmoved, at `velocity` (m/s) where they touch.
    [[nodiscard]] ImpactResult solve_moved(const ImpactBody& first, const Vec3& velocity,
                                           const ImpactContact& contact);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::sim::ode
