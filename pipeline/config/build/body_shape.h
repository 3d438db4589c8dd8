// What others collide with where an object is seen.
#pragma once

#include <optional>

#include "pipeline/config/build/builder.h"

namespace carom::pipeline::config {

/// The shape that others collide with, in the object's axes; empty after a problem.
[[nodiscard]] std::optional<sim::BodyShape> body_shape(const Named<ObjectSection>& object,
                                                       Builder& builder);

/// Volume of the shapes that the simulation can move, m^3.
[[nodiscard]] std::optional<double> volume(const ObjectSection& object);

}  // namespace carom::pipeline::config
