// Random shots as YAML.
#pragma once

#include <cstdint>
#include <string>

namespace carom::testing {

/// The random shot with this number. It has a random table, balls, solids (resting, falling, fixed
/// or moved by keys), surfaces, lights, events, one or two cameras, integrator, acceleration
/// structure and output, with 64 x 36 pixels and a few samples. It follows the rules of the format,
/// but bodies may overlap.
[[nodiscard]] std::string random_film(std::uint64_t number);

}  // namespace carom::testing
