// The room around the listener: its first reflections. What follows them is in reverberation.h.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/vectors.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// Rooms by name. Their measures are plausible; no published ones of billiard rooms were found.
[[nodiscard]] RoomSettings club();      // 8 x 6 x 2.8 m, 0.6 s (0.35 s at high frequencies)
[[nodiscard]] RoomSettings studio();    // 6 x 5 x 3 m, 0.25 s (0.18 s)
[[nodiscard]] RoomSettings hall();      // 30 x 20 x 8 m, 1.2 s (0.8 s)
[[nodiscard]] RoomSettings outdoors();  // only the ground reflects
[[nodiscard]] RoomSettings no_room();

/// The names: "none", "studio", "club", "hall", "outdoors".
[[nodiscard]] std::span<const std::string_view> room_names();

/// The room of that name, or nothing.
[[nodiscard]] std::optional<RoomSettings> room_of_name(std::string_view name);

/// A sound's mirror image in one surface of the room. It sounds like the source itself, at its
/// distance, after the filter y[n] = (1 - pole) gain x[n] + pole y[n-1].
struct Reflection {
    Vec3 image{0, 0, 0};  // m, where the sound seems to come from
    int axis = 2;         // vectors of the source (a dipole's) have this component negated
    double gain = 0;      // of the pressure at low frequencies, [0, 1]
    double pole = 0;      // [0, 1)

    bool operator==(const Reflection&) const = default;
};

/// The reflections of one source.
class Reflections {
  public:
    static constexpr std::size_t kMost = 6;

    void push_back(const Reflection& reflection) { list_[count_++] = reflection; }
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] const Reflection& operator[](std::size_t index) const { return list_[index]; }
    [[nodiscard]] const Reflection* begin() const { return list_.data(); }
    [[nodiscard]] const Reflection* end() const { return list_.data() + count_; }

  private:
    std::array<Reflection, kMost> list_{};
    std::size_t count_ = 0;
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
[[nodiscard]] Reflections reflections_of(const RoomSettings& room, const Vec3& source,
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
