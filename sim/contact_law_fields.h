// The fields of the contact law, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "sim/contact_law.h"

namespace carom::sim {

constexpr auto fields_of(Describes<BallCloth>) {
    using T = BallCloth;
    return fields<T>(field("sliding_friction", &T::sliding_friction),
                     field("rolling_friction", &T::rolling_friction),
                     field("spinning_friction", &T::spinning_friction),
                     field("restitution", &T::restitution));
}

constexpr auto fields_of(Describes<BallBall>) {
    using T = BallBall;
    return fields<T>(field("restitution", &T::restitution), field("friction", &T::friction),
                     field("friction_model", &T::friction_model),
                     field("friction_factor", &T::friction_factor));
}

constexpr auto fields_of(Describes<RestitutionFall>) {
    using T = RestitutionFall;
    return fields<T>(field("above", &T::above), field("slope", &T::slope),
                     field("least", &T::least));
}

constexpr auto fields_of(Describes<BallCushion>) {
    using T = BallCushion;
    return fields<T>(field("model", &T::model), field("restitution", &T::restitution),
                     field("friction", &T::friction), field("fall", &T::fall));
}

constexpr auto fields_of(Describes<PairContact>) {
    using T = PairContact;
    return fields<T>(field("restitution", &T::restitution), field("friction", &T::friction),
                     field("rolling_friction", &T::rolling_friction));
}

constexpr auto fields_of(Describes<ContactLaw>) {
    using T = ContactLaw;
    return fields<T>(field("ball_cloth", &T::ball_cloth), field("ball_ball", &T::ball_ball),
                     field("ball_cushion", &T::ball_cushion), field("hop", &T::hop),
                     field("otherwise", &T::otherwise), field("pairs", &T::pairs));
}

}  // namespace carom::sim
