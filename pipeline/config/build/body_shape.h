// The collision shapes of objects.
#pragma once

#include <optional>

#include "pipeline/config/build/builder.h"

namespace carom::pipeline::config {

/// The collision shape in the object's axes; empty after a problem.
[[nodiscard]] std::optional<sim::BodyShape> body_shape(const Named<ObjectSection>& object,
                                                       Builder& builder);

/// The volume of the shapes that the simulation can move, m^3; empty for others.
[[nodiscard]] std::optional<double> volume(const ObjectSection& object);

}  // namespace carom::pipeline::config
