// Points that fill a space evenly, or at random: the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom::pipeline::study {

enum class Sampling {
    sobol,   // Sobol's sequence, shifted by the seed
    latin,   // a Latin hypercube: in each dimension one point in each of `count` equal intervals
    random,  // independent
};

inline constexpr std::size_t kMostSobolDimensions = 21;

/// Coordinate `dimension` (from 0) of point `index` of Sobol's sequence, as a fraction of 2^32.
[[nodiscard]] std::uint32_t sobol_number(std::uint32_t index, std::size_t dimension);

/// `count` points whose coordinates are above 0 and below 1. At most kMostSobolDimensions
/// dimensions for Sobol's sequence. The first points are those of a smaller count, except of a
/// Latin hypercube.
[[nodiscard]] std::vector<std::vector<double>> sample_points(Sampling sampling, std::size_t count,
                                                             std::size_t dimensions,
                                                             std::uint64_t seed);

}  // namespace carom::pipeline::study
