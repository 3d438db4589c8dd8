// Scrambled Sobol points in four dimensions, vectorised. Internal to this folder.
#pragma once

#include <array>
#include <cstdint>

#include "render/sampling/sobol_tables.h"

namespace carom::render::detail {

/// The first four dimensions of the point with this bit-reversed index, each scrambled by its own
/// seed, which is made from `set_hash`. All instruction sets return the same bits.
[[nodiscard]] std::array<float, 4> sobol_point(std::uint32_t reversed_index,
                                               std::uint32_t set_hash);

/// Four consecutive points with the same scrambling, from the bit-reversed index of the first one,
/// which is a multiple of 4: all first coordinates, then all second ones.
[[nodiscard]] std::array<float, 8> sobol_block(std::uint32_t reversed_index,
                                               std::uint32_t set_hash);

/// The fifth dimension of the same point.
[[nodiscard]] float sobol_fifth(std::uint32_t reversed_index, std::uint32_t set_hash);

}  // namespace carom::render::detail
