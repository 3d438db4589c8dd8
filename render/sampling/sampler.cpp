#include "render/sampling/sampler.h"

#include <cstring>

#include "render/sampling/sobol_tables.h"

namespace carom::render {
namespace {

using detail::reverse_bits;

constexpr detail::SobolNibbleTables kSobol = detail::make_sobol_tables();

// Four 32-bit lanes as a vector of the compiler; SSE2 on every x86-64.
typedef std::uint32_t UInt4 __attribute__((vector_size(16)));

/// Which point of a pixel the numbers belong to; the camera's stands outside the numbered sets.
constexpr std::uint32_t kCameraSet = 0xffffffffu;

/// Finaliser of MurmurHash3 (Appleby 2011), one lane or four.
template <class T>
T mix(T x) {
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
template <class T>
T scramble_reversed(T x, T seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// Finaliser of SplitMix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number
/// generators").
std::uint64_t mix64(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

UInt4 reverse_bits4(UInt4 x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

/// The first four Sobol coordinates, bits reversed, of a bit-reversed index.
UInt4 sobol4_reversed(std::uint32_t reversed_index) {
    UInt4 x = {0, 0, 0, 0};
    for (int nibble = 0; nibble < 8; ++nibble) {
        UInt4 contribution;
        const std::uint32_t value = (reversed_index >> (4 * nibble)) & 15u;
        std::memcpy(&contribution, kSobol.values[nibble][value], sizeof contribution);
        x ^= contribution;
    }
    return x;
}

/// The 24 highest bits, so that the result is below 1.
float to_unit(std::uint32_t x) {
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

std::array<float, 4> scrambled_point(std::uint32_t reversed_index, std::uint32_t set_hash) {
    const UInt4 lane_seeds =
        mix(set_hash + UInt4{0x3c6ef372u, 0xdaa66d2bu, 0x78dde6e4u, 0x1715609du});
    const UInt4 x = reverse_bits4(scramble_reversed(sobol4_reversed(reversed_index), lane_seeds));
    return {to_unit(x[0]), to_unit(x[1]), to_unit(x[2]), to_unit(x[3])};
}

}  // namespace

SampleStream::SampleStream(std::uint64_t seed, std::uint32_t pixel_x, std::uint32_t pixel_y,
                           std::uint32_t sample)
    : reversed_sample_(reverse_bits(sample)) {
    const std::uint64_t pixel = (static_cast<std::uint64_t>(pixel_y) << 32) | pixel_x;
    pixel_hash_ = static_cast<std::uint32_t>(mix64(mix64(seed) ^ pixel) >> 32);
}

CameraSample SampleStream::camera_sample() const {
    // The index itself is not shuffled: the sets of the bounces are, each in its own way.
    const std::uint32_t set_hash = mix(pixel_hash_ ^ mix(kCameraSet));
    const std::array<float, 4> point = scrambled_point(reversed_sample_, set_hash);
    std::uint32_t fifth = 0;
    for (int nibble = 0; nibble < 8; ++nibble) {
        fifth ^= kSobol.fifth[nibble][(reversed_sample_ >> (4 * nibble)) & 15u];
    }
    fifth = reverse_bits(scramble_reversed(fifth, mix(set_hash + 0xb54cda56u)));
    return {V2f(point[0], point[1]), V2f(point[2], point[3]), to_unit(fifth)};
}

std::array<float, 4> SampleStream::next_4d() {
    const std::uint32_t set_hash = mix(pixel_hash_ ^ mix(set_));
    set_ += 1;
    const std::uint32_t shuffled = scramble_reversed(reversed_sample_, mix(set_hash + 0x9e3779b9u));
    return scrambled_point(shuffled, set_hash);
}

}  // namespace carom::render
