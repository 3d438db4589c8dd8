// The room around the listener: its first reflections. What follows them is in reverberation.h.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/vectors.h"
#include "sound/sound_scene.h"

namespace carom::sound {

struct NamedRoom {
    std::string_view name;
    RoomSettings room;
};

/// The rooms that have a name: "none", "studio", "club", "hall", "outdoors" (where only the ground
/// reflects). Their measures are plausible; no published ones of billiard rooms were found.
[[nodiscard]] std::span<const NamedRoom> rooms();

/// A sound's mirror image in one surface of the room. It sounds like the source itself, at its
/// distance, after the filter y[n] = (1 - pole) gain x[n] + pole y[n-1].
struct Reflection {
    Vec3 image{0, 0, 0};  // m, where the sound seems to come from
    int axis = 2;         // vectors of the source (a dipole's) have this component negated
    double gain = 0;      // of the pressure at low frequencies, [0, 1]
    double pole = 0;      // [0, 1)

    bool operator==(const Reflection&) const = default;
};

/// The images of the source in the walls, in the order -x, +x, -y, +y, floor, ceiling (outdoors the
/// floor alone; without a room none). The room is a box with edges along the axes and the middle of
/// its floor at `room.floor_centre`.
///
/// All surfaces absorb alike, so much that the room has its reverberation times: by Eyring (1930),
/// "Reverberation time in 'dead' rooms", J. Acoust. Soc. Am. 1, T = 0.161 V / (-S ln(1 - a)), the
/// pressure of a reflection has the factor sqrt(1 - a) = exp(-0.0805 V / (S T)), with V the volume
/// and S the surface of the room, T the time at low frequencies and, for the pole, at
/// kHighFrequency. The ground outdoors has the factor 0.9 (tuned), at all frequencies.
///
/// A source or listener beyond a wall, or less than 0.3 m in front of it, pushes this wall back to
/// 0.3 m behind itself: nothing jumps when a camera flies through a wall.
[[nodiscard]] std::vector<Reflection> reflections_of(const RoomSettings& room, const Vec3& source,
                                                     const Vec3& listener);

inline constexpr double kHighFrequency = 8000;  // Hz, at which rooms have their "high" times

/// The distance (m) from a source at which the reverberation is as loud as its direct sound,
/// 0.057 sqrt(V / T), for a source without direction (H. Kuttruff, "Room Acoustics").
/// Requires a box.
[[nodiscard]] double critical_distance(const RoomSettings& room);

/// The pole p in [0, 1) of the filter (1 - p) / (1 - p / z), whose factor is 1 at 0 Hz and `ratio`,
/// in (0, 1], at kHighFrequency.
[[nodiscard]] double pole_for(double ratio);

}  // namespace carom::sound
