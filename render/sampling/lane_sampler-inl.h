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

/// The random numbers of a group of paths, one path per lane. The functions mirror SampleStream.
class LaneSampler {
  public:
    HWY_INLINE LaneSampler(U pixel_hash, U reversed_sample)
        : pixel_hash_(pixel_hash), reversed_sample_(reversed_sample) {}

    /// SampleStream::next_4d of the set.
    HWY_INLINE void get_4d(U set, F (&u)[4]) const {
        const U hash = set_hash(set);
        U coordinates[4];
        sobol(shuffled_index<Lanes>(reversed_sample_, hash), coordinates);
        for (int d = 0; d < 4; ++d) {
            u[d] = scrambled_coordinate<Lanes>(coordinates[d], seed(hash, d));
        }
    }

    /// SampleStream::get_2d_block: all x coordinates, then all y coordinates.
    HWY_INLINE void get_2d_block(std::uint32_t set, F (&x)[4], F (&y)[4]) const {
        const U hash = set_hash(all_words(set));
        const U shuffled = shuffled_index<Lanes>(reversed_sample_, hash);
        U coordinates[4];
        sobol(hn::ShiftRight<2>(shuffled), coordinates);
        const U seed_x = seed(hash, 0);
        const U seed_y = seed(hash, 1);
        for (std::uint32_t k = 0; k < 4; ++k) {
            const U to_x = all_words(detail::block_difference(0, k));
            const U to_y = all_words(detail::block_difference(1, k));
            x[k] = scrambled_coordinate<Lanes>(hn::Xor(coordinates[0], to_x), seed_x);
            y[k] = scrambled_coordinate<Lanes>(hn::Xor(coordinates[1], to_y), seed_y);
        }
    }

    /// SampleStream::camera_sample: pixel, lens, time.
    HWY_INLINE void get_camera_sample(F (&u)[5]) const {
        const U hash = set_hash(all_words(detail::kCameraSet));
        U coordinates[4];
        sobol(reversed_sample_, coordinates);
        for (int d = 0; d < 4; ++d) {
            u[d] = scrambled_coordinate<Lanes>(coordinates[d], seed(hash, d));
        }
        U fifth = all_words(0);
        for (int nibble = 0; nibble < 8; ++nibble) {
            const U part =
                of_digit(detail::kSobol.fifth[nibble], digit_of(reversed_sample_, nibble));
            fifth = hn::Xor(fifth, part);
        }
        u[4] = scrambled_coordinate<Lanes>(
            fifth, seed_of_dimension<Lanes>(hash, all_words(detail::kFifthSalt)));
    }

    /// SampleStream::get_1d.
    HWY_INLINE F get_1d(U set) const {
        return independent_number<Lanes>(set_hash(set), reversed_sample_);
    }

  private:
    HWY_INLINE U set_hash(U set) const { return hash_of_set<Lanes>(pixel_hash_, set); }
    static HWY_INLINE U seed(U hash, int dimension) {
        return seed_of_dimension<Lanes>(hash, all_words(detail::kLaneSalts[dimension]));
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
