// Sobol's generating matrices for five dimensions, laid out for the sampler.
//
// Primitive polynomials and initial direction numbers: S. Joe and F. Y. Kuo, "Constructing Sobol
// sequences with better two-dimensional projections", SIAM J. Sci. Comput. 30 (2008), their table
// new-joe-kuo-6 (d, s, a, m_i); the recurrence is their equation (2).
#pragma once

#include <array>
#include <cstdint>

#include "render/lanes/scalar_lanes.h"

namespace carom::render::detail {

inline constexpr int kSobolDimensions = 5;

/// Degree, inner coefficients and first direction numbers of one dimension.
struct SobolPolynomial {
    int degree;
    std::uint32_t coefficients;
    std::array<std::uint32_t, 3> initial;
};

inline constexpr std::array<SobolPolynomial, kSobolDimensions> kSobolPolynomials = {{
    {0, 0, {}},  // dimension 0 is van der Corput's sequence
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
}};

/// m_k of Joe and Kuo, k from 0: odd, below 2^(k+1).
constexpr std::array<std::uint32_t, 32> direction_numbers(const SobolPolynomial& polynomial) {
    std::array<std::uint32_t, 32> m{};
    const int s = polynomial.degree;
    for (int k = 0; k < 32; ++k) {
        if (s == 0) {
            m[k] = 1;
        } else if (k < s) {
            m[k] = polynomial.initial[k];
        } else {
            m[k] = m[k - s] ^ (m[k - s] << s);
            for (int j = 1; j < s; ++j) {
                if ((polynomial.coefficients >> (s - 1 - j)) & 1u) {
                    m[k] ^= m[k - j] << j;
                }
            }
        }
    }
    return m;
}

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    return ScalarLanes<float>::reversed_bits(x);
}

/// For each nibble of the bit-reversed index, the bit-reversed coordinates that it contributes:
/// the point of a reversed index is the exclusive or over its eight nibbles. In the order [nibble]
/// [dimension][value of the nibble].
struct SobolTables {
    alignas(64) std::uint32_t at[8][kSobolDimensions][16];
};

constexpr std::uint32_t nibble_contribution(const std::array<std::uint32_t, 32>& m, int nibble,
                                            int value) {
    std::uint32_t x = 0;
    for (int bit = 0; bit < 4; ++bit) {
        if ((value >> bit) & 1) {
            const int k = 31 - (4 * nibble + bit);  // bit of the index itself
            x ^= reverse_bits(m[k] << (31 - k));
        }
    }
    return x;
}

constexpr SobolTables make_sobol_tables() {
    SobolTables tables{};
    for (int d = 0; d < kSobolDimensions; ++d) {
        const std::array<std::uint32_t, 32> m = direction_numbers(kSobolPolynomials[d]);
        for (int nibble = 0; nibble < 8; ++nibble) {
            for (int value = 0; value < 16; ++value) {
                tables.at[nibble][d][value] = nibble_contribution(m, nibble, value);
            }
        }
    }
    return tables;
}

inline constexpr SobolTables kSobol = make_sobol_tables();

/// Seeds that make the scrambling of each dimension of a set different.
inline constexpr std::uint32_t kDimensionSalts[kSobolDimensions] = {
    0x3c6ef372u, 0xdaa66d2bu, 0x78dde6e4u, 0x1715609du, 0xb54cda56u};

/// The set of a pixel's camera rays, apart from the numbered sets.
inline constexpr std::uint32_t kCameraSet = 0xffffffffu;

/// The exclusive or between a coordinate of point `k` of an aligned block of four and that of the
/// block's first point. Their indices differ in the two lowest bits, which are the highest when
/// reversed.
constexpr std::uint32_t block_difference(int dimension, std::uint32_t k) {
    const std::uint32_t reversed = (k & 1u) << 1 | k >> 1;
    return kSobol.at[7][dimension][reversed << 2];
}

}  // namespace carom::render::detail
