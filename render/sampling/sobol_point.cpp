#include "render/sampling/sobol_point.h"

#include "render/sampling/scalar_kernels.h"

#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_AVX3_DL)  // bring nothing for four lanes
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/sampling/sobol_point.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/sampling/kernels-inl.h"

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

namespace hn = hwy::HWY_NAMESPACE;
/// The dimensions of a point, in as many lanes as there are.
using FourTag = hn::CappedTag<float, 4>;
using FourLanes = render::HWY_NAMESPACE::VectorLanes<FourTag>;
using Tag = FourLanes::WordTag;
using Four = FourLanes::Word;

HWY_INLINE int four_lanes() {
    return static_cast<int>(hn::Lanes(Tag()));
}

HWY_INLINE Four contribution(std::uint32_t reversed_index, int nibble, int dimension) {
    return hn::Load(Tag(),
                    kSobol.values[nibble][(reversed_index >> (4 * nibble)) & 15u] + dimension);
}

/// The coordinates in the dimensions from the given one on.
HWY_INLINE Four sobol(std::uint32_t reversed_index, int dimension) {
    const auto part = [&](int nibble)
                          HWY_ATTR { return contribution(reversed_index, nibble, dimension); };
    const Four a = hn::Xor(part(0), part(1));
    const Four b = hn::Xor(part(2), part(3));
    const Four c = hn::Xor(part(4), part(5));
    const Four e = hn::Xor(part(6), part(7));
    return hn::Xor(hn::Xor(a, b), hn::Xor(c, e));
}

HWY_INLINE Four seeds_of(std::uint32_t set_hash, int dimension) {
    return render::HWY_NAMESPACE::seed_of_dimension<FourLanes>(
        hn::Set(Tag(), set_hash), hn::LoadU(Tag(), kLaneSalts + dimension));
}

HWY_INLINE void write_scrambled(Four x, Four seeds, float* coordinates) {
    hn::StoreU(render::HWY_NAMESPACE::scrambled_coordinate<FourLanes>(x, seeds), FourTag(),
               coordinates);
}

inline HWY_ATTR void point(std::uint32_t reversed_index, std::uint32_t set_hash,
                           float* coordinates) {
    for (int d = 0; d < 4; d += four_lanes()) {
        write_scrambled(sobol(reversed_index, d), seeds_of(set_hash, d), coordinates + d);
    }
}

inline HWY_ATTR void block(std::uint32_t reversed_index, std::uint32_t set_hash,
                           float* coordinates) {
    const Tag words;
    alignas(16) std::uint32_t base[4];
    alignas(16) std::uint32_t seeds[4];
    for (int d = 0; d < 4; d += four_lanes()) {
        hn::Store(sobol(reversed_index, d), words, base + d);
        hn::Store(seeds_of(set_hash, d), words, seeds + d);
    }
    for (int d = 0; d < 2; ++d) {
        for (int k = 0; k < 4; k += four_lanes()) {
            const Four of_point = hn::Xor(hn::Set(words, base[d]), hn::Load(words, kBlock[d] + k));
            write_scrambled(of_point, hn::Set(words, seeds[d]), coordinates);
            coordinates += four_lanes();
        }
    }
}

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
