// The fields of events and the other records (core/fields.h), in the order of the JSON export. The
// bake file uses the same names.
#pragma once

#include "core/fields.h"
#include "sim/timeline/event.h"

namespace carom::sim {

constexpr auto fields_of(Describes<Event>) {
    return fields<Event>(field("time", &Event::time), field("end_time", &Event::end_time),
                         field("kind", &Event::kind), field("a", &Event::a), field("b", &Event::b),
                         field("place", &Event::place), field("normal", &Event::normal),
                         field("normal_impulse", &Event::normal_impulse),
                         field("tangential_impulse", &Event::tangential_impulse),
                         field("vector", &Event::vector));
}

constexpr auto fields_of(Describes<LastingContact>) {
    using T = LastingContact;
    return fields<T>(field("a", &T::a), field("b", &T::b), field("from", &T::from),
                     field("to", &T::to), field("normal_force", &T::normal_force),
                     field("slip", &T::slip));
}

constexpr auto fields_of(Describes<PutBack>) {
    return fields<PutBack>(field("ball", &PutBack::ball), field("time", &PutBack::time),
                           field("from", &PutBack::from), field("to", &PutBack::to));
}

constexpr auto fields_of(Describes<EnergySample>) {
    using T = EnergySample;
    return fields<T>(field("time", &T::time), field("kinetic", &T::kinetic),
                     field("potential", &T::potential), field("work", &T::work));
}

}  // namespace carom::sim
