// The fields of force events, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "sim/force_event.h"

namespace carom::sim {

constexpr auto fields_of(Describes<Force>) {
    return fields<Force>(field("newtons", &Force::newtons), field("duration", &Force::duration),
                         field("at_point", &Force::at_point), field("axes", &Force::axes));
}

constexpr auto fields_of(Describes<Torque>) {
    return fields<Torque>(field("newton_metres", &Torque::newton_metres),
                          field("duration", &Torque::duration), field("axes", &Torque::axes));
}

constexpr auto fields_of(Describes<Impulse>) {
    return fields<Impulse>(field("newton_seconds", &Impulse::newton_seconds),
                           field("at_point", &Impulse::at_point), field("axes", &Impulse::axes));
}

constexpr auto fields_of(Describes<SetVelocity>) {
    return fields<SetVelocity>(field("linear", &SetVelocity::linear),
                               field("angular", &SetVelocity::angular));
}

constexpr auto fields_of(Describes<Strike>) {
    using T = Strike;
    return fields<T>(field("speed", &T::speed), field("ball_speed", &T::ball_speed),
                     field("toward", &T::toward), field("toward_point", &T::toward_point),
                     field("direction", &T::direction), field("elevation", &T::elevation),
                     field("tip", &T::tip), field("stick_mass", &T::stick_mass),
                     field("end_mass_ratio", &T::end_mass_ratio),
                     field("tip_restitution", &T::tip_restitution));
}

constexpr auto fields_of(Describes<PlaceBall>) {
    using T = PlaceBall;
    return fields<T>(field("at", &T::at), field("spot", &T::spot),
                     field("if_occupied", &T::if_occupied));
}

constexpr auto fields_of(Describes<RemoveBall>) {
    return fields<RemoveBall>();
}

constexpr auto fields_of(Describes<Trigger>) {
    using T = Trigger;
    return fields<T>(field("kind", &T::kind), field("a", &T::a), field("b", &T::b),
                     field("from", &T::from), field("to", &T::to), field("nth", &T::nth));
}

constexpr auto fields_of(Describes<ForceEvent>) {
    using T = ForceEvent;
    return fields<T>(field("object", &T::object), field("time", &T::time),
                     field("trigger", &T::trigger), field("after", &T::after),
                     field("action", &T::action));
}

}  // namespace carom::sim
