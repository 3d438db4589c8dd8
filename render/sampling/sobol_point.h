// Scrambled Sobol points in four dimensions, vectorised. Internal to this folder.
#pragma once

#include <array>
#include <cstdint>

#include "render/sampling/sobol_tables.h"

namespace carom::render::detail {

/// Finaliser of MurmurHash3 (Appleby 2011).
[[nodiscard]] constexpr std::uint32_t mix(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x85ebca6bu;
    x ^= x >> 13;
    x *= 0xc2b2ae35u;
    x ^= x >> 16;
    return x;
}

/// Nested uniform (Owen) scrambling in base 2 of a number whose bits are reversed: each bit is
/// flipped depending on `seed` and the bits below it. The form is Laine and Karras 2011,
/// "Stratified sampling for stochastic transparency", section 3.1; constants and order of steps
/// are Vegdahl 2021, "Building a better LK hash", which mixes the first bits more thoroughly.
[[nodiscard]] constexpr std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// The 24 highest bits, so that the result is below 1.
[[nodiscard]] constexpr float to_unit(std::uint32_t x) {
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

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
