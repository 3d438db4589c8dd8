// Steps bodies in lasting contact with ODE.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/pose.h"
#include "sim/ode/impact_solver.h"

namespace carom::sim::ode {

/// One point of contact during one step; a gap may close during it.
struct StepContact : Contact {
    int first = 0;
    int second = -1;  // another body; -1: the static environment
    double restitution = 0;
    double friction = 0;
    double rolling_arm = 0;    // rolling moment / normal force, m
    double torsional_arm = 0;  // moment about the normal / normal force, m
    /// Where pull p acts on a body that rolls without slip, it turns faster by p / this (m).
    double rolling_length = 0;
    /// Rolling is resisted about this axis only, a unit vector across the normal; zero: about all.
    Vec3 rolling_axis{0, 0, 0};
    /// m/s: what the velocity of the first body relative to the second, at the contact, has gained
    /// since the step's start because the bodies turn, as far as reversing it does no work.
    Vec3 turning{0, 0, 0};
};

/// A step of `duration` (s) under `gravity` (m/s^2).
struct StepProblem {
    double duration = 0;
    Vec3 gravity{0, 0, 0};
    std::span<const int> moving;             // indices of the bodies that move
    std::span<const MotionState> midpoints;  // in the same order, their states after half of it
                                             // without forces
    std::span<const StepContact> contacts;   // those found there
};

/// The motion of a body in a step: its velocities change at the midpoint, then it moves freely to
/// `end`.
struct StepMotion {
    MotionState after;  // at the midpoint, after the change
    MotionState end;
    double work = 0;  // of a kinematic body: what its contacts did on the others, J
};

class StepWorld {
  public:
    StepWorld();
    ~StepWorld();
    StepWorld(const StepWorld&) = delete;
    StepWorld& operator=(const StepWorld&) = delete;

    /// Adds a body; its index counts from 0. A kinematic one keeps its velocities in all contacts.
    void add(const RigidBody& body, bool is_kinematic);

    /// Finds the motions of the moving bodies, in their order, and the impulses of the contacts.
    /// dWorldStep solves for the velocities at the midpoint with all contacts together, then each
    /// body moves freely for the second half (Moreau's midpoint scheme: Jean, The non-smooth
    /// contact dynamics method, Comput. Methods Appl. Mech. Eng. 177, 1999, section 4.1). Where the
    /// bodies turn, a contact that does not slip leaves the midpoint with the opposite of the slip
    /// that it has got there, which the second half takes back: so the scheme is of second order
    /// while contacts last. It is exact for bodies without contacts. Contacts may refer to bodies
    /// that are not moving, which act like walls.
    void step(const StepProblem& problem, std::vector<StepMotion>& motions,
              std::vector<ImpulsePair>& impulses);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::sim::ode
