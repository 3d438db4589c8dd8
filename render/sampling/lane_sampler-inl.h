// The sampler of sampler.h with one sample per lane; it returns the same bits. Included once per
// instruction set.
#if defined(CAROM_LANE_SAMPLER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_LANE_SAMPLER_INL_H
#undef CAROM_LANE_SAMPLER_INL_H
#else
#define CAROM_LANE_SAMPLER_INL_H
#endif

#include "render/sampling/lanes-inl.h"
#include "render/sampling/sobol_point.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

HWY_INLINE U mix_words(U x) {
    x = hn::Xor(x, hn::ShiftRight<16>(x));
    x = x * all_words(0x85ebca6bu);
    x = hn::Xor(x, hn::ShiftRight<13>(x));
    x = x * all_words(0xc2b2ae35u);
    return hn::Xor(x, hn::ShiftRight<16>(x));
}

HWY_INLINE U scramble_reversed_words(U x, U seed) {
    x = hn::Xor(x, x * all_words(0x3d20adeau));
    x = x + seed;
    x = x * hn::Or(hn::ShiftRight<16>(seed), all_words(1u));
    x = hn::Xor(x, x * all_words(0x05526c56u));
    return hn::Xor(x, x * all_words(0x53a22864u));
}

HWY_INLINE U reverse_bits_of_words(U x) {
    const hn::Repartition<std::uint8_t, WordTag> bytes;
    alignas(16) static constexpr std::uint8_t kNibbles[16] = {
        0x0, 0x8, 0x4, 0xc, 0x2, 0xa, 0x6, 0xe, 0x1, 0x9, 0x5, 0xd, 0x3, 0xb, 0x7, 0xf};
    alignas(16) static constexpr std::uint8_t kBytes[16] = {3,  2,  1, 0, 7,  6,  5,  4,
                                                            11, 10, 9, 8, 15, 14, 13, 12};
    const auto table = hn::LoadDup128(bytes, kNibbles);
    const U low = hn::And(x, all_words(0x0f0f0f0fu));
    const U high = hn::And(hn::ShiftRight<4>(x), all_words(0x0f0f0f0fu));
    const WordTag d;
    const U low_reversed = hn::BitCast(d, hn::TableLookupBytes(table, hn::BitCast(bytes, low)));
    const U high_reversed = hn::BitCast(d, hn::TableLookupBytes(table, hn::BitCast(bytes, high)));
    const U joined = hn::Or(hn::ShiftLeft<4>(low_reversed), high_reversed);
    return hn::BitCast(
        d, hn::TableLookupBytes(hn::BitCast(bytes, joined), hn::LoadDup128(bytes, kBytes)));
}

HWY_INLINE F to_unit_lanes(U x) {
    const F value = hn::ConvertTo(FloatTag(), hn::BitCast(IntTag(), hn::ShiftRight<8>(x)));
    return value * all(0x1p-24f);
}

/// The random numbers of a group of paths, one path per lane. The functions mirror SampleStream.
class LaneSampler {
  public:
    HWY_INLINE LaneSampler(U pixel_hash, U reversed_sample)
        : pixel_hash_(pixel_hash), reversed_sample_(reversed_sample) {}

    /// SampleStream::next_4d of the set.
    HWY_INLINE void get_4d(U set, F (&u)[4]) const {
        const U hash = set_hash(set);
        const U shuffled =
            scramble_reversed_words(reversed_sample_, mix_words(hash + all_words(0x9e3779b9u)));
        U coordinates[4];
        sobol(shuffled, coordinates);
        for (int d = 0; d < 4; ++d) {
            u[d] = scrambled(coordinates[d], seed(hash, d));
        }
    }

    /// SampleStream::get_2d_block: all x coordinates, then all y coordinates.
    HWY_INLINE void get_2d_block(std::uint32_t set, F (&x)[4], F (&y)[4]) const {
        const U hash = set_hash(all_words(set));
        const U shuffled =
            scramble_reversed_words(reversed_sample_, mix_words(hash + all_words(0x9e3779b9u)));
        U coordinates[4];
        sobol(hn::ShiftRight<2>(shuffled), coordinates);
        const U seed_x = seed(hash, 0);
        const U seed_y = seed(hash, 1);
        for (std::uint32_t k = 0; k < 4; ++k) {
            x[k] = scrambled(hn::Xor(coordinates[0], all_words(detail::block_difference(0, k))),
                             seed_x);
            y[k] = scrambled(hn::Xor(coordinates[1], all_words(detail::block_difference(1, k))),
                             seed_y);
        }
    }

    /// SampleStream::camera_sample: pixel, lens, time.
    HWY_INLINE void get_camera_sample(F (&u)[5]) const {
        const U hash = set_hash(all_words(detail::kCameraSet));
        U coordinates[4];
        sobol(reversed_sample_, coordinates);
        for (int d = 0; d < 4; ++d) {
            u[d] = scrambled(coordinates[d], seed(hash, d));
        }
        U fifth = all_words(0);
        for (int nibble = 0; nibble < 8; ++nibble) {
            const U part =
                of_digit(detail::kSobol.fifth[nibble], digit_of(reversed_sample_, nibble));
            fifth = hn::Xor(fifth, part);
        }
        u[4] = scrambled(fifth, mix_words(hash + all_words(detail::kFifthSalt)));
    }

    /// SampleStream::get_1d.
    HWY_INLINE F get_1d(U set) const {
        return to_unit_lanes(mix_words(hn::Xor(set_hash(set), reversed_sample_)));
    }

  private:
    HWY_INLINE U set_hash(U set) const { return mix_words(hn::Xor(pixel_hash_, mix_words(set))); }
    static HWY_INLINE U seed(U hash, int dimension) {
        return mix_words(hash + all_words(detail::kLaneSalts[dimension]));
    }
    static HWY_INLINE F scrambled(U x, U seed) {
        return to_unit_lanes(reverse_bits_of_words(scramble_reversed_words(x, seed)));
    }
    static HWY_INLINE I digit_of(U index, int nibble) {
        return hn::BitCast(IntTag(), hn::And(hn::ShiftRightSame(index, 4 * nibble), all_words(15)));
    }
    /// A number of a table of sixteen for each lane's digit, out of registers.
    static HWY_INLINE U of_digit(const std::uint32_t (&table)[16], I digit) {
        const WordTag d;
        if constexpr (hn::MaxLanes(WordTag()) >= 16) {
            return hn::TableLookupLanes(hn::LoadU(d, table), hn::IndicesFromVec(d, digit));
        } else if constexpr (hn::MaxLanes(WordTag()) == 8) {
            // The two halves of the table; eight lanes take three bits of the digit.
            const IntTag di;
            const auto place = hn::IndicesFromVec(d, hn::And(digit, hn::Set(di, 7)));
            const U low = hn::TableLookupLanes(hn::LoadU(d, table), place);
            const U high = hn::TableLookupLanes(hn::LoadU(d, table + 8), place);
            return hn::IfThenElse(hn::RebindMask(d, hn::Gt(digit, hn::Set(di, 7))), high, low);
        } else {
            return hn::GatherIndex(d, table, digit);
        }
    }
    /// The exclusive or over the eight nibbles of the index, in four dimensions.
    static HWY_INLINE void sobol(U reversed_index, U (&coordinates)[4]) {
        for (int nibble = 0; nibble < 8; ++nibble) {
            const I digit = hn::BitCast(
                IntTag(), hn::And(hn::ShiftRightSame(reversed_index, 4 * nibble), all_words(15)));
            for (int d = 0; d < 4; ++d) {
                const U part = of_digit(detail::kSobolDigits.at[nibble][d], digit);
                coordinates[d] = nibble == 0 ? part : hn::Xor(coordinates[d], part);
            }
        }
    }

    U pixel_hash_, reversed_sample_;
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
