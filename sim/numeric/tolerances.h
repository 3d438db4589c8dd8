// The gaps, depths, displacements and speeds below which the simulation makes no difference, each
// with its reason. Within a group they ascend.
#pragma once

namespace carom::sim {

// Gaps between balls and what they meet in closed form, m.

/// Closed: a thousand times the rounding error of a located impact.
inline constexpr double kContactDistance = 1e-12;
/// On neither side of a line: many times the rounding error.
inline constexpr double kOnLine = 1e-11;
/// Closed, where a time of impact is found by bisection.
inline constexpr double kClosedBySearch = 1e-10;
/// Closed, where several bodies take part in an impact: no ball is polished as well. The result
/// would multiply rounding errors of the places by the speed over the compression, some 1e4 / s.
inline constexpr double kPolish = 1e-9;
/// Frozen, that is, pushed together by a strike. While the tip presses, a ball moves ten times as
/// far. Coordinates rounded to 0.01 mm leave 14 micrometres, the balls of a rack about 30.
inline constexpr double kFrozenGap = 5e-5;

// Gaps and depths of bodies in the solver, m.

/// A gap that counts as closed in an impact.
inline constexpr double kClosedGap = 2e-6;
/// Impacting bodies and new contacts may overlap by this much at a step's end. Otherwise the step
/// is shortened so that they overlap by between a quarter of this and this.
inline constexpr double kContactDepth = 4e-6;
/// Depths up to this are not corrected: impacts are detected that late, and a correction would add
/// energy.
inline constexpr double kSlop = 5e-6;
/// Gaps of balls up to this are contacts, so that a ball at rest does not keep losing contact.
inline constexpr double kBallMargin = 1e-5;
/// Gaps of solids up to this are contacts of negative depth, so that a stack keeps all four corners
/// of every face in contact.
inline constexpr double kSolidMargin = 1e-4;
/// A body has moved when a point of it is this far from where it last rested: more than a body that
/// is put down sinks or closes a gap.
inline constexpr double kMinDisplacement = 2e-4;

// Speeds, m/s.

/// Surfaces of two bodies that collide slip in no direction: rounding.
inline constexpr double kMinImpactSlip = 1e-12;
/// Likewise in a step.
inline constexpr double kMinStepSlip = 1e-6;
/// Least separation after every impact. Without it, a ball that its spin presses against another
/// ball or a cushion would bounce infinitely often in a finite time (Zeno behaviour). A bounce at
/// this speed is a nanometre high; its energy is 2e-10 J for a pool ball.
inline constexpr double kMinSeparation = 5e-5;
/// Impacts slower than this are not logged: a ball that its spin presses against something makes
/// thousands.
inline constexpr double kMinLoggedSpeed = 4 * kMinSeparation;
/// A body whose speed has risen by more than this since it became slow is about to move.
inline constexpr double kRisingSpeed = 2.5e-4;
/// A ball that would leave a level surface more slowly than this stays on it: it would rise by
/// 5 micrometres.
inline constexpr double kLandingSpeed = 0.01;
/// A body whose points are slower than this may fall asleep.
inline constexpr double kSleepSpeed = 0.01;
/// Motion that can be seen, though it leads nowhere: something rocks.
inline constexpr double kVisibleSpeed = 0.01;
/// Frozen balls approach or separate more slowly than this: during a push, about 2 ms, their gap
/// changes by no more than kFrozenGap.
inline constexpr double kFrozenSpeed = 0.01;
/// Below this approach speed a contact in the solver does not bounce; otherwise stacks would never
/// rest.
inline constexpr double kBounceSpeed = 0.02;

/// Rotation that can be seen, though it leads nowhere: a ball spins in place, rad/s.
inline constexpr double kVisibleSpin = 0.5;

}  // namespace carom::sim
