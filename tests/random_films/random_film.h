// Whole shots that nobody would film, as YAML.
#pragma once

#include <cstdint>
#include <string>

namespace carom::testing {

/// The shot of that number: any table, balls, solids that lie, fly, stand or are moved by keys,
/// surfaces, lights, events, one or two cameras, any integrator, structure and output. 64 x 36
/// pixels, a few samples. It keeps the rules of the format; bodies may still overlap.
[[nodiscard]] std::string random_film(std::uint64_t number);

}  // namespace carom::testing
