#include "pipeline/study/sampling.h"

#include <array>
#include <utility>

#include "core/assert.h"
#include "core/splitmix.h"

namespace carom::pipeline::study {

namespace {

constexpr std::size_t kBits = 32;

/// A primitive polynomial and the first direction numbers of a dimension.
struct Directions {
    std::uint32_t degree = 0;              // s
    std::uint32_t coefficients = 0;        // a: those between the first and the last, as bits
    std::array<std::uint32_t, 7> first{};  // m
};

/// Joe and Kuo 2008, "Constructing Sobol sequences with better two-dimensional projections", SIAM
/// J. Sci. Comput. 30, file new-joe-kuo-6.21201, dimensions 2 to 21, as several public copies have
/// them.
constexpr std::array<Directions, kMostSobolDimensions - 1> kDirections{
    {{1, 0, {1}},
     {2, 1, {1, 3}},
     {3, 1, {1, 3, 1}},
     {3, 2, {1, 1, 1}},
     {4, 1, {1, 1, 3, 3}},
     {4, 4, {1, 3, 5, 13}},
     {5, 2, {1, 1, 5, 5, 17}},
     {5, 4, {1, 1, 5, 5, 5}},
     {5, 7, {1, 1, 7, 11, 19}},
     {5, 11, {1, 1, 5, 1, 1}},
     {5, 13, {1, 1, 1, 3, 11}},
     {5, 14, {1, 3, 5, 5, 31}},
     {6, 1, {1, 3, 3, 9, 7, 49}},
     {6, 13, {1, 1, 1, 15, 21, 21}},
     {6, 16, {1, 3, 1, 13, 27, 49}},
     {6, 19, {1, 1, 1, 15, 7, 5}},
     {6, 22, {1, 3, 1, 15, 13, 25}},
     {6, 25, {1, 1, 5, 5, 19, 61}},
     {7, 1, {1, 3, 7, 11, 23, 15, 103}},
     {7, 4, {1, 3, 7, 13, 13, 15, 69}}}};

/// V of the paper's equations 2 and 3: the contribution of each bit of the index.
std::array<std::uint32_t, kBits> contributions(std::size_t dimension) {
    std::array<std::uint32_t, kBits> v{};
    if (dimension == 0) {  // van der Corput's sequence
        for (std::size_t i = 0; i < kBits; ++i) {
            v[i] = 1U << (kBits - 1 - i);
        }
        return v;
    }
    const Directions& of = kDirections.at(dimension - 1);
    for (std::size_t i = 0; i < of.degree; ++i) {
        v[i] = of.first[i] << (kBits - 1 - i);
    }
    for (std::size_t i = of.degree; i < kBits; ++i) {
        v[i] = v[i - of.degree] ^ (v[i - of.degree] >> of.degree);
        for (std::size_t k = 1; k < of.degree; ++k) {
            if (((of.coefficients >> (of.degree - 1 - k)) & 1U) != 0) {
                v[i] ^= v[i - k];
            }
        }
    }
    return v;
}

/// The centre of one of 2^32 intervals of [0, 1].
double centre_of(std::uint32_t interval) {
    return (interval + 0.5) * 0x1p-32;
}

/// Random numbers of a dimension.
SplitMix64 numbers_of(std::uint64_t seed, std::size_t dimension) {
    return SplitMix64(split_mix(split_mix(seed + kSplitMixStep) + (dimension + 1) * kSplitMixStep));
}

std::uint32_t upper_half(std::uint64_t bits) {
    return static_cast<std::uint32_t>(bits >> 32U);
}

std::vector<double> latin_coordinates(std::size_t count, SplitMix64 random) {
    std::vector<std::size_t> intervals(count);
    for (std::size_t i = 0; i < count; ++i) {
        intervals[i] = i;
    }
    for (std::size_t i = count; i > 1; --i) {  // Fisher and Yates
        const auto other = static_cast<std::size_t>(random.next_unit() * static_cast<double>(i));
        std::swap(intervals[i - 1], intervals[other]);
    }
    std::vector<double> coordinates;
    for (const std::size_t interval : intervals) {
        const double within = centre_of(upper_half(random.next()));
        coordinates.push_back((static_cast<double>(interval) + within) /
                              static_cast<double>(count));
    }
    return coordinates;
}

std::vector<double> coordinates_of(Sampling sampling, std::size_t count, std::size_t dimension,
                                   std::uint64_t seed) {
    SplitMix64 random = numbers_of(seed, dimension);
    if (sampling == Sampling::latin) {
        return latin_coordinates(count, random);
    }
    // A digital shift, which keeps the evenness of the sequence.
    const std::uint32_t shift = upper_half(random.next());
    std::vector<double> coordinates;
    for (std::size_t i = 0; i < count; ++i) {
        coordinates.push_back(
            centre_of(sampling == Sampling::sobol
                          ? sobol_number(static_cast<std::uint32_t>(i), dimension) ^ shift
                          : upper_half(random.next())));
    }
    return coordinates;
}

}  // namespace

std::uint32_t sobol_number(std::uint32_t index, std::size_t dimension) {
    static const std::vector<std::array<std::uint32_t, kBits>> all = [] {
        std::vector<std::array<std::uint32_t, kBits>> v;
        for (std::size_t d = 0; d < kMostSobolDimensions; ++d) {
            v.push_back(contributions(d));
        }
        return v;
    }();
    const std::array<std::uint32_t, kBits>& v = all.at(dimension);
    std::uint32_t number = 0;
    for (std::size_t bit = 0; index >> bit != 0; ++bit) {
        if (((index >> bit) & 1U) != 0) {
            number ^= v[bit];
        }
        if (bit == kBits - 1) {
            break;
        }
    }
    return number;
}

std::vector<std::vector<double>> sample_points(Sampling sampling, std::size_t count,
                                               std::size_t dimensions, std::uint64_t seed) {
    std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
    for (std::size_t d = 0; d < dimensions; ++d) {
        const std::vector<double> coordinates = coordinates_of(sampling, count, d, seed);
        for (std::size_t i = 0; i < count; ++i) {
            points[i][d] = coordinates[i];
        }
    }
    return points;
}

}  // namespace carom::pipeline::study
