#include "render/sampling/sobol_point.h"

#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_AVX3_DL)  // bring nothing for four lanes
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/sampling/sobol_point.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

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
    const std::uint32_t seed = mix(set_hash + kLaneSalts[d]);
    return to_unit(reverse_bits(scramble_reversed(x, seed)));
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
using Tag = hn::CappedTag<std::uint32_t, 4>;
using Bytes = hn::Repartition<std::uint8_t, Tag>;
using Four = hn::Vec<Tag>;

HWY_INLINE Four times(Four x, std::uint32_t factor) {
    return hn::Mul(x, hn::Set(Tag(), factor));
}

/// `mix` of sobol_point.h in four lanes.
HWY_INLINE Four mix4(Four x) {
    x = hn::Xor(x, hn::ShiftRight<16>(x));
    x = times(x, 0x85ebca6bu);
    x = hn::Xor(x, hn::ShiftRight<13>(x));
    x = times(x, 0xc2b2ae35u);
    return hn::Xor(x, hn::ShiftRight<16>(x));
}

/// `scramble_reversed` of sobol_point.h in four lanes.
HWY_INLINE Four scramble_reversed4(Four x, Four seed) {
    x = hn::Xor(x, times(x, 0x3d20adeau));
    x = hn::Add(x, seed);
    x = hn::Mul(x, hn::Or(hn::ShiftRight<16>(seed), hn::Set(Tag(), 1u)));
    x = hn::Xor(x, times(x, 0x05526c56u));
    return hn::Xor(x, times(x, 0x53a22864u));
}

/// Each lane's 32 bits reversed: nibbles by a table lookup, then bytes by another.
HWY_INLINE Four reverse_bits4(Four x) {
    alignas(16) static constexpr std::uint8_t kNibbles[16] = {
        0x0, 0x8, 0x4, 0xc, 0x2, 0xa, 0x6, 0xe, 0x1, 0x9, 0x5, 0xd, 0x3, 0xb, 0x7, 0xf};
    alignas(16) static constexpr std::uint8_t kBytes[16] = {3,  2,  1, 0, 7,  6,  5,  4,
                                                            11, 10, 9, 8, 15, 14, 13, 12};
    const Bytes db;
    const Tag d;
    const Four low = hn::And(x, hn::Set(d, 0x0f0f0f0fu));
    const Four high = hn::And(hn::ShiftRight<4>(x), hn::Set(d, 0x0f0f0f0fu));
    const auto table = hn::Load(db, kNibbles);
    const Four low_reversed = hn::BitCast(d, hn::TableLookupBytes(table, hn::BitCast(db, low)));
    const Four high_reversed = hn::BitCast(d, hn::TableLookupBytes(table, hn::BitCast(db, high)));
    const Four in_bytes = hn::Or(hn::ShiftLeft<4>(low_reversed), high_reversed);
    return hn::BitCast(d, hn::TableLookupBytes(hn::BitCast(db, in_bytes), hn::Load(db, kBytes)));
}

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
    const Tag d;
    return mix4(hn::Add(hn::Set(d, set_hash), hn::LoadU(d, kLaneSalts)));
}

HWY_INLINE void write_scrambled4(Four x, Four seeds, float* coordinates) {
    const hn::Rebind<float, Tag> df;
    const hn::Rebind<std::int32_t, Tag> di;
    const Four scrambled = reverse_bits4(scramble_reversed4(x, seeds));
    const auto value = hn::ConvertTo(df, hn::BitCast(di, hn::ShiftRight<8>(scrambled)));
    hn::StoreU(hn::Mul(value, hn::Set(df, 0x1p-24f)), df, coordinates);
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
    return to_unit(reverse_bits(scramble_reversed(x, mix(set_hash + kFifthSalt))));
}

}  // namespace carom::render::detail

#endif
