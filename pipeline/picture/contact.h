// The contacts of balls to which annotations refer.
#pragma once

#include <optional>
#include <string>

#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// An impact of an object on another object or surface.
struct Contact {
    double time = 0;         // scene time, s
    Vec3 centre{0, 0, 0};    // of the object, m
    Vec3 normal{0, 0, 1};    // unit, from the other one to the object
    Vec3 velocity{0, 0, 0};  // of the object before it, m/s
};

/// The first impact of `object` on `other`; empty if there is none.
[[nodiscard]] std::optional<Contact> first_contact(const sim::Timeline& timeline,
                                                   const std::string& object,
                                                   const std::string& other);

}  // namespace carom::pipeline
