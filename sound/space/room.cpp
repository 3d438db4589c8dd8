#include "sound/space/room.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace carom::sound {
namespace {

constexpr double kLeastClearance = 0.3;    // m, of source and listener to every wall
constexpr double kGroundReflection = 0.9;  // of the pressure, outdoors

constexpr std::array<std::string_view, 5> kNames{"none", "studio", "club", "hall", "outdoors"};

RoomSettings box(const Vec3& size, double low, double high) {
    RoomSettings room;
    room.size = size;
    room.reverberation_low = low;
    room.reverberation_high = high;
    return room;
}

double volume_of(const Vec3& size) {
    return size.x * size.y * size.z;
}

double surface_of(const Vec3& size) {
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

/// The factor of the pressure of one reflection, by Eyring.
double reflection_factor(const Vec3& size, double reverberation) {
    return exponential(-0.0805 * volume_of(size) / (surface_of(size) * reverberation));
}

/// The image in a wall at `place` along the axis; `side` is 1 if the room is below it, -1 above.
Reflection reflection_in(int axis, double side, double place, const Vec3& source,
                         const Vec3& listener) {
    const double nearest = std::max(side * source[axis], side * listener[axis]) + kLeastClearance;
    const double wall = side * std::max(side * place, nearest);
    Reflection reflection;
    reflection.image = source;
    reflection.image[axis] = 2 * wall - source[axis];
    reflection.axis = axis;
    return reflection;
}

}  // namespace

RoomSettings club() {
    return box({8, 6, 2.8}, 0.6, 0.35);
}

RoomSettings studio() {
    return box({6, 5, 3}, 0.25, 0.18);
}

RoomSettings hall() {
    return box({30, 20, 8}, 1.2, 0.8);
}

RoomSettings outdoors() {
    RoomSettings room;
    room.kind = RoomSettings::Kind::outdoors;
    return room;
}

RoomSettings no_room() {
    RoomSettings room;
    room.kind = RoomSettings::Kind::none;
    return room;
}

std::span<const std::string_view> room_names() {
    return kNames;
}

std::optional<RoomSettings> room_of_name(std::string_view name) {
    using Maker = RoomSettings (*)();
    constexpr std::array<Maker, kNames.size()> kMakers{no_room, studio, club, hall, outdoors};
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) {
        return std::nullopt;
    }
    return kMakers[static_cast<std::size_t>(found - kNames.begin())]();
}

Reflections reflections_of(const RoomSettings& room, const Vec3& source, const Vec3& listener) {
    Reflections reflections;
    if (room.kind == RoomSettings::Kind::none) {
        return reflections;
    }
    if (room.kind == RoomSettings::Kind::outdoors) {
        Reflection ground = reflection_in(2, -1, room.floor_centre.z, source, listener);
        ground.gain = kGroundReflection;
        reflections.push_back(ground);
        return reflections;
    }
    const double low = reflection_factor(room.size, room.reverberation_low);
    const double high = reflection_factor(room.size, room.reverberation_high);
    const double pole = pole_for(high / low);
    const Vec3 middle = room.floor_centre + Vec3(0, 0, room.size.z / 2);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            Reflection reflection = reflection_in(
                axis, side, middle[axis] + side * room.size[axis] / 2, source, listener);
            reflection.gain = low;
            reflection.pole = pole;
            reflections.push_back(reflection);
        }
    }
    return reflections;
}

double critical_distance(const RoomSettings& room) {
    return 0.057 * std::sqrt(volume_of(room.size) / room.reverberation_low);
}

// With c the cosine of the angle of kHighFrequency on the unit circle, and q = ratio^2, the
// condition (1 - p)^2 = q (1 - 2 p c + p^2) is a quadratic equation for p, of which this is the
// root below 1.
double pole_for(double ratio) {
    const double q = ratio * ratio;
    if (!(q < 1)) {
        return 0;
    }
    const double c = cosine(2 * std::numbers::pi * kHighFrequency / kSampleRate);
    const double half = 1 - q * c;
    return (1 - q) / (half + std::sqrt(half * half - (1 - q) * (1 - q)));
}

}  // namespace carom::sound
