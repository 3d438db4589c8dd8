// Short functions that build worlds and shots for tests.
#pragma once

#include <string>
#include <vector>

#include "sim/bake.h"

namespace carom::sim::test {

inline constexpr double kRadius = 0.028575;
inline constexpr double kMass = 0.170097;
inline constexpr double kGravity = 9.81;

/// A ball on the cloth at (x, y) with these velocities.
[[nodiscard]] Body ball(const std::string& name, double x, double y,
                        const Vec3& velocity = {0, 0, 0}, const Vec3& spin = {0, 0, 0});

/// The spin of a ball that rolls with `velocity`.
[[nodiscard]] Vec3 rolling_spin(const Vec3& velocity, double radius = kRadius);

/// The contact law of these worlds: constant ball-ball friction of 0.05, and Han's cushion with
/// 0.85 and 0.2 at all speeds.
[[nodiscard]] ContactLaw constant_law();

/// A cushion model with its published parameters at all speeds.
[[nodiscard]] BallCushion constant_cushion(CushionModel model);

/// An unbounded cloth.
[[nodiscard]] WorldDescription cloth_world(double duration);

/// A carom table of 2.54 x 1.27 m without pockets.
[[nodiscard]] WorldDescription walled_world(double duration);

/// A 9 ft pool table with a nine-ball rack and the cue ball at (-0.75, 0.12).
[[nodiscard]] WorldDescription nine_ball_world(double duration);

/// Strikes `object` towards `target` at `time`.
[[nodiscard]] ForceEvent strike_towards(const std::string& object, const std::string& target,
                                        double speed, double time = 0, Vec2 tip = {0, 0},
                                        double elevation = 0);

[[nodiscard]] MotionState state_at(const Timeline& timeline, const std::string& name, double time);

/// The first event of that kind for `a` (and `b`, unless empty); nullptr if none exists.
[[nodiscard]] const Event* find_event(const Timeline& timeline, EventKind kind,
                                      const std::string& a, const std::string& b = {});

[[nodiscard]] std::vector<std::string> sentences_of(const std::vector<Diagnostic>& diagnostics);
/// The sentences of the problems that `find_problems` returns.
[[nodiscard]] std::vector<std::string> problem_sentences(const WorldDescription& world);

[[nodiscard]] int count_events(const Timeline& timeline, EventKind kind);

/// The key of the object at `time`.
[[nodiscard]] Key key_at(const Timeline& timeline, const std::string& name, double time);

}  // namespace carom::sim::test
