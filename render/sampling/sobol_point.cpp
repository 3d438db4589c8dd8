#include "render/sampling/sobol_point.h"

#include "render/sampling/scalar_kernels.h"

#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_AVX3_DL)  // bring nothing for four lanes
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/sampling/sobol_point.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "render/sampling/kernels-inl.h"
#endif

#ifndef CAROM_SOBOL_FUNCTIONS
#define CAROM_SOBOL_FUNCTIONS
namespace carom::render::detail {
// Both write floats in [0, 1). `point`: four coordinates; `block`: the first coordinates of four
// points, then the second ones.
using WriteFunction = void(std::uint32_t reversed_index, std::uint32_t set_hash,
                           float* coordinates);
struct SobolFunctions {
    WriteFunction* point;
    WriteFunction* block;
};

alignas(16) constexpr std::uint32_t kBlock[2][4] = {
    {block_difference(0, 0), block_difference(0, 1), block_difference(0, 2),
     block_difference(0, 3)},
    {block_difference(1, 0), block_difference(1, 1), block_difference(1, 2),
     block_difference(1, 3)}};
}  // namespace carom::render::detail
#endif

HWY_BEFORE_NAMESPACE();
namespace carom::render::detail::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

inline std::uint32_t sobol(std::uint32_t reversed_index, int d) {
    std::uint32_t x = 0;
    for (int nibble = 0; nibble < 8; ++nibble) {
        x ^= kSobol.values[nibble][(reversed_index >> (4 * nibble)) & 15u][d];
    }
    return x;
}

inline float scrambled(std::uint32_t x, std::uint32_t set_hash, int d) {
    using scalar::One;
    return scalar::scrambled_coordinate<One>(
        x, scalar::seed_of_dimension<One>(set_hash, kLaneSalts[d]));
}

inline void point(std::uint32_t reversed_index, std::uint32_t set_hash, float* coordinates) {
    for (int d = 0; d < 4; ++d) {
        coordinates[d] = scrambled(sobol(reversed_index, d), set_hash, d);
    }
}

inline void block(std::uint32_t reversed_index, std::uint32_t set_hash, float* coordinates) {
    for (int d = 0; d < 2; ++d) {
        for (int k = 0; k < 4; ++k) {
            coordinates[4 * d + k] =
                scrambled(sobol(reversed_index, d) ^ kBlock[d][k], set_hash, d);
        }
    }
}

#else

namespace hn = hwy::HWY_NAMESPACE;
/// One point's four dimensions.
using FourTag = hn::CappedTag<float, 4>;
using FourLanes = render::HWY_NAMESPACE::VectorLanes<FourTag>;
using Tag = FourLanes::WordTag;
using Four = FourLanes::Word;

HWY_INLINE Four contribution(std::uint32_t reversed_index, int nibble) {
    return hn::Load(Tag(), kSobol.values[nibble][(reversed_index >> (4 * nibble)) & 15u]);
}

HWY_INLINE Four sobol4(std::uint32_t reversed_index) {
    const Four a = hn::Xor(contribution(reversed_index, 0), contribution(reversed_index, 1));
    const Four b = hn::Xor(contribution(reversed_index, 2), contribution(reversed_index, 3));
    const Four c = hn::Xor(contribution(reversed_index, 4), contribution(reversed_index, 5));
    const Four e = hn::Xor(contribution(reversed_index, 6), contribution(reversed_index, 7));
    return hn::Xor(hn::Xor(a, b), hn::Xor(c, e));
}

HWY_INLINE Four seeds4(std::uint32_t set_hash) {
    return render::HWY_NAMESPACE::seed_of_dimension<FourLanes>(hn::Set(Tag(), set_hash),
                                                               hn::LoadU(Tag(), kLaneSalts));
}

HWY_INLINE void write_scrambled4(Four x, Four seeds, float* coordinates) {
    hn::StoreU(render::HWY_NAMESPACE::scrambled_coordinate<FourLanes>(x, seeds), FourTag(),
               coordinates);
}

inline HWY_ATTR void point(std::uint32_t reversed_index, std::uint32_t set_hash,
                           float* coordinates) {
    write_scrambled4(sobol4(reversed_index), seeds4(set_hash), coordinates);
}

inline HWY_ATTR void block(std::uint32_t reversed_index, std::uint32_t set_hash,
                           float* coordinates) {
    const Tag d;
    const Four base = sobol4(reversed_index);
    const Four seeds = seeds4(set_hash);
    write_scrambled4(hn::Xor(hn::Broadcast<0>(base), hn::Load(d, kBlock[0])),
                     hn::Broadcast<0>(seeds), coordinates);
    write_scrambled4(hn::Xor(hn::Broadcast<1>(base), hn::Load(d, kBlock[1])),
                     hn::Broadcast<1>(seeds), coordinates + 4);
}

#endif

inline const SobolFunctions& functions_of_target() {
    static constexpr SobolFunctions kFunctions = {point, block};
    return kFunctions;
}

}  // namespace carom::render::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render::detail {

HWY_EXPORT(functions_of_target);

namespace {

const SobolFunctions& best() {
    static const SobolFunctions& functions = HWY_DYNAMIC_DISPATCH(functions_of_target)();
    return functions;
}

}  // namespace

std::array<float, 4> sobol_point(std::uint32_t reversed_index, std::uint32_t set_hash) {
    std::array<float, 4> coordinates;
    best().point(reversed_index, set_hash, coordinates.data());
    return coordinates;
}

std::array<float, 8> sobol_block(std::uint32_t reversed_index, std::uint32_t set_hash) {
    std::array<float, 8> coordinates;
    best().block(reversed_index, set_hash, coordinates.data());
    return coordinates;
}

float sobol_fifth(std::uint32_t reversed_index, std::uint32_t set_hash) {
    std::uint32_t x = 0;
    for (int nibble = 0; nibble < 8; ++nibble) {
        x ^= kSobol.fifth[nibble][(reversed_index >> (4 * nibble)) & 15u];
    }
    using scalar::One;
    return scalar::scrambled_coordinate<One>(x,
                                             scalar::seed_of_dimension<One>(set_hash, kFifthSalt));
}

}  // namespace carom::render::detail

#endif
