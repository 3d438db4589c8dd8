// The fields of the types that describe motion, in the order in which they are hashed
// (core/fields.h).
#pragma once

#include "core/fields.h"
#include "sim/timeline/track.h"
#include "sim/timeline/track_recorder.h"

namespace carom {

constexpr auto fields_of(Describes<Pose>) {
    return fields<Pose>(field("position", &Pose::position),
                        field("orientation", &Pose::orientation));
}

constexpr auto fields_of(Describes<MotionState>) {
    using T = MotionState;
    return fields<T>(field("position", &T::position), field("orientation", &T::orientation),
                     field("velocity", &T::velocity),
                     field("angular_velocity", &T::angular_velocity));
}

}  // namespace carom

namespace carom::sim {

constexpr auto fields_of(Describes<Key>) {
    return fields<Key>(field("time", &Key::time), field("position", &Key::position),
                       field("orientation", &Key::orientation),
                       field("velocity_in", &Key::velocity_in),
                       field("angular_velocity_in", &Key::angular_velocity_in),
                       field("velocity_out", &Key::velocity_out),
                       field("angular_velocity_out", &Key::angular_velocity_out));
}

/// The part of a track that is hashed. Its name belongs to the object that it moves.
inline std::span<const Key> hashed_part(const Track& track) {
    return track.keys();
}

constexpr auto fields_of(Describes<PathSegment>) {
    using T = PathSegment;
    return fields<T>(field("start", &T::start), field("end", &T::end), field("p0", &T::p0),
                     field("p1", &T::p1), field("v0", &T::v0), field("v1", &T::v1));
}

constexpr auto fields_of(Describes<KeyReduction>) {
    return fields<KeyReduction>(field("position_error", &KeyReduction::position_error),
                                field("orientation_error", &KeyReduction::orientation_error));
}

}  // namespace carom::sim
