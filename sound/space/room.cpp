#include "sound/space/room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace carom::sound {
namespace {

constexpr double kMinClearance = 0.3;      // m, of source and listener to every wall
constexpr double kGroundReflection = 0.9;  // of the pressure, outdoors

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
    const double nearest = std::max(side * source[axis], side * listener[axis]) + kMinClearance;
    const double wall = side * std::max(side * place, nearest);
    Reflection reflection;
    reflection.image = source;
    reflection.image[axis] = 2 * wall - source[axis];
    reflection.axis = axis;
    return reflection;
}

}  // namespace

std::span<const NamedRoom> rooms() {
    using Kind = RoomSettings::Kind;
    const Vec3 floor_centre(0, 0, -0.8);
    static const std::array<NamedRoom, 5> kRooms{
        {{"none", {.kind = Kind::none}},
         {"studio", {Kind::box, {6, 5, 3}, floor_centre, 0.25, 0.18}},
         {"club", {Kind::box, {8, 6, 2.8}, floor_centre, 0.6, 0.35}},
         {"hall", {Kind::box, {30, 20, 8}, floor_centre, 1.2, 0.8}},
         {"outdoors", {.kind = Kind::outdoors}}}};
    return kRooms;
}

std::vector<Reflection> reflections_of(const RoomSettings& room, const Vec3& source,
                                       const Vec3& listener) {
    std::vector<Reflection> reflections;
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
