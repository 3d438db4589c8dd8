// The fields of a table's measures, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "sim/billiards/table.h"

namespace carom::sim::billiards {

constexpr auto fields_of(Describes<PocketMeasures>) {
    using T = PocketMeasures;
    return fields<T>(field("mouth", &T::mouth), field("throat", &T::throat),
                     field("jaw_angle", &T::jaw_angle), field("hole_radius", &T::hole_radius),
                     field("shelf", &T::shelf), field("drop", &T::drop),
                     field("lip_radius", &T::lip_radius));
}

constexpr auto fields_of(Describes<TableMeasures>) {
    using T = TableMeasures;
    return fields<T>(
        field("kind", &T::kind), field("length", &T::length), field("width", &T::width),
        field("nose_height", &T::nose_height), field("cushion_width", &T::cushion_width),
        field("rail_width", &T::rail_width), field("rail_height", &T::rail_height),
        field("height", &T::height), field("has_cushions", &T::has_cushions),
        field("corner_pocket", &T::corner_pocket), field("side_pocket", &T::side_pocket),
        field("has_ball_return", &T::has_ball_return),
        field("jaw_restitution", &T::jaw_restitution));
}

}  // namespace carom::sim::billiards
