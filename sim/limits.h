// Limits of the numbers that describe a world. Beyond them nothing that carom films happens, and a
// simulation would end late with an error that names no place.
#pragma once

namespace carom::sim {

// Of each component; a struck ball reaches 20 m/s and 1000 rad/s.
inline constexpr double kMaxSpeed = 1000;    // m/s
inline constexpr double kMaxSpin = 10'000;   // rad/s
inline constexpr double kMaxImpulse = 1000;  // N s
inline constexpr double kMaxForce = 1e5;     // N
inline constexpr double kMaxTorque = 1e4;    // N m

/// Of the radius of a sphere, capsule or cylinder and of each length of a solid, m.
inline constexpr double kMinSize = 1e-5;
inline constexpr double kMaxSize = 1000;

}  // namespace carom::sim
