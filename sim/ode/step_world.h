// Bodies in lasting contact, stepped by ODE.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/pose.h"
#include "sim/ode/impact_solver.h"

namespace carom::sim::ode {

/// One point of contact during one step.
struct StepContact {
    int first = 0;
    int second = -1;  // another body; -1: something that does not move
    Vec3 point{0, 0, 0};
    Vec3 normal{0, 0, 1};  // unit, from the second towards the first
    double depth = 0;      // m; negative: a gap that may close during the step
    double restitution = 0;
    double friction = 0;
    double rolling_lever = 0;   // m: rolling moment / normal force
    double spinning_lever = 0;  // m: moment about the normal / normal force
};

struct StepImpulse {
    double normal = 0;      // N s, during the step
    double tangential = 0;  // N s
};

/// What a step did to a body: its velocities changed half-way, then it moved freely to `end`.
struct StepMotion {
    MotionState after;  // half-way, behind the change
    MotionState end;
};

struct BodyInertia {
    double mass = 1;
    Vec3 inertia{1, 1, 1};
    bool is_kinematic = false;  // keeps its velocities whatever it meets
};

/// Approaches below this speed (m/s) do not bounce in lasting contact: stacks would never rest.
inline constexpr double kBounceSpeed = 0.02;

class StepWorld {
  public:
    StepWorld();
    ~StepWorld();
    StepWorld(const StepWorld&) = delete;
    StepWorld& operator=(const StepWorld&) = delete;

    /// Returns the body's number, counted from 0.
    int add(const BodyInertia& body);

    /// Steps the bodies numbered in `moving` over `duration`. `middles` (same order): where they
    /// get to in half of it without any force; the contacts are those found there. Velocities are
    /// solved for by dWorldStep with all contacts at once, then each body goes on freely for the
    /// other half (Moreau's midpoint scheme: Jean, The non-smooth contact dynamics method, Comput.
    /// Methods Appl. Mech. Eng. 177, 1999, section 4.1): of second order as long as contacts last,
    /// exact for what touches nothing. Contacts may name bodies that are not moving; those stand
    /// like walls.
    void step(double duration, const Vec3& gravity, std::span<const int> moving,
              std::span<const MotionState> middles, std::span<const StepContact> contacts,
              std::vector<StepMotion>& motions, std::vector<StepImpulse>& impulses);

    /// The velocities behind a blow: contacts with their restitution, nothing else acts and nothing
    /// moves.
    void strike(std::span<const int> moving, std::span<const MotionState> states,
                std::span<const StepContact> contacts, std::vector<Velocities>& after,
                std::vector<StepImpulse>& impulses);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::sim::ode
