// Limits of the numbers that describe a world. Beyond them nothing that carom films happens, and a
// simulation would end late with an error that names no place.
#pragma once

namespace carom::sim {

// Of each component; a struck ball reaches 20 m/s and 1000 rad/s.
inline constexpr double kMostSpeed = 1000;    // m/s
inline constexpr double kMostSpin = 10'000;   // rad/s
inline constexpr double kMostImpulse = 1000;  // N s
inline constexpr double kMostForce = 1e5;     // N
inline constexpr double kMostTorque = 1e4;    // N m

/// Of the radius of a sphere, capsule or cylinder and of each length of a solid, m.
inline constexpr double kLeastSize = 1e-5;
inline constexpr double kMostSize = 1000;

}  // namespace carom::sim
