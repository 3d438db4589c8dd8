// The lane type of vectors. Included once per instruction set, after <hwy/highway.h>.
#if defined(CAROM_VECTOR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_VECTOR_LANES_INL_H
#undef CAROM_VECTOR_LANES_INL_H
#else
#define CAROM_VECTOR_LANES_INL_H
#endif

#include <cstdint>
#include <limits>

#include "render/lanes/scalar_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// See ScalarLanes. D: a Highway tag; integers, bits and loads are for floats only.
template <class D>
struct VectorLanes {
    using Number = hn::TFromD<D>;
    using Value = hn::Vec<D>;
    using Mask = hn::Mask<D>;
    using IntTag = hn::RebindToSigned<D>;
    using WordTag = hn::RebindToUnsigned<D>;
    using Int = hn::Vec<IntTag>;
    using Word = hn::Vec<WordTag>;
    static constexpr Number kLargest = ScalarLanes<Number>::kLargest;

    static HWY_INLINE Value all(Number x) { return hn::Set(D(), x); }
    static HWY_INLINE Int all_int(std::int32_t x) { return hn::Set(IntTag(), x); }
    static HWY_INLINE Word all_word(std::uint32_t x) { return hn::Set(WordTag(), x); }
    static HWY_INLINE int count() { return static_cast<int>(hn::Lanes(D())); }
    static HWY_INLINE Int from(std::int32_t first) { return hn::Iota(IntTag(), first); }
    static HWY_INLINE Mask first_lanes(int n) {
        return hn::FirstN(D(), static_cast<std::size_t>(n));
    }
    static HWY_INLINE std::int32_t first_of(Int x) { return hn::GetLane(x); }
    static HWY_INLINE std::int32_t smallest_of(Mask mask, Int x) {
        const Int most = all_int(std::numeric_limits<std::int32_t>::max());
        return hn::GetLane(hn::MinOfLanes(IntTag(), select_int(mask, x, most)));
    }

    static HWY_INLINE Mask is_less(Value a, Value b) { return hn::Lt(a, b); }
    static HWY_INLINE Mask is_at_most(Value a, Value b) { return hn::Le(a, b); }
    static HWY_INLINE Mask is_equal(Value a, Value b) { return hn::Eq(a, b); }
    static HWY_INLINE Mask is_equal_int(Int a, Int b) { return hn::RebindMask(D(), hn::Eq(a, b)); }
    static HWY_INLINE Mask is_less_int(Int a, Int b) { return hn::RebindMask(D(), hn::Lt(a, b)); }
    static HWY_INLINE Mask is_less_word(Word a, Word b) {
        return hn::RebindMask(D(), hn::Lt(a, b));
    }
    static HWY_INLINE Mask both(Mask a, Mask b) { return hn::And(a, b); }
    static HWY_INLINE Mask either(Mask a, Mask b) { return hn::Or(a, b); }
    static HWY_INLINE Mask opposite(Mask a) { return hn::Not(a); }
    static HWY_INLINE Mask without(Mask a, Mask b) { return hn::AndNot(b, a); }
    static HWY_INLINE bool none(Mask mask) { return hn::AllFalse(D(), mask); }
    static HWY_INLINE int count_of(Mask mask) { return static_cast<int>(hn::CountTrue(D(), mask)); }
    static HWY_INLINE bool fails_alone(Mask) { return false; }

    static HWY_INLINE Value select(Mask mask, Value yes, Value no) {
        return hn::IfThenElse(mask, yes, no);
    }
    static HWY_INLINE Mask select_mask(Mask mask, Mask yes, Mask no) {
        return hn::Or(hn::And(mask, yes), hn::AndNot(mask, no));
    }
    static HWY_INLINE Int select_int(Mask mask, Int yes, Int no) {
        return hn::IfThenElse(hn::RebindMask(IntTag(), mask), yes, no);
    }

    template <class Function>
    static HWY_INLINE Value lane_by_lane(const Function& function, Value a, Value b) {
        HWY_ALIGN Number x[hn::MaxLanes(D())];
        HWY_ALIGN Number y[hn::MaxLanes(D())];
        hn::Store(a, D(), x);
        hn::Store(b, D(), y);
        for (std::size_t i = 0; i < hn::Lanes(D()); ++i) {
            x[i] = function(x[i], y[i]);
        }
        return hn::Load(D(), x);
    }

    static HWY_INLINE Value size(Value x) { return hn::Abs(x); }
    static HWY_INLINE Value opposite_sign(Value x) { return hn::Neg(x); }
    static HWY_INLINE Value smaller(Value a, Value b) { return hn::Min(a, b); }
    static HWY_INLINE Value larger(Value a, Value b) { return hn::Max(a, b); }
    static HWY_INLINE Int smaller_int(Int a, Int b) { return hn::Min(a, b); }
    static HWY_INLINE Int larger_int(Int a, Int b) { return hn::Max(a, b); }
    static HWY_INLINE Int product(Int a, std::int32_t b) { return hn::Mul(a, all_int(b)); }
    static HWY_INLINE Value root(Value x) { return hn::Sqrt(x); }
    static HWY_INLINE Value inverse(Value x) { return hn::Div(all(1), x); }
    static HWY_INLINE Value rounded_down(Value x) { return hn::Floor(x); }

    static HWY_INLINE Int to_int(Value x) { return hn::ConvertTo(IntTag(), x); }
    static HWY_INLINE Value to_value(Int x) { return hn::ConvertTo(D(), x); }
    static HWY_INLINE Int bits_of(Value x) { return hn::BitCast(IntTag(), x); }
    static HWY_INLINE Value from_bits(Int x) { return hn::BitCast(D(), x); }
    static HWY_INLINE Word to_word(Int x) { return hn::BitCast(WordTag(), x); }
    static HWY_INLINE Int from_word(Word x) { return hn::BitCast(IntTag(), x); }
    template <int kBits>
    static HWY_INLINE Word shifted_left(Word x) {
        return hn::ShiftLeft<kBits>(x);
    }
    template <int kBits>
    static HWY_INLINE Word shifted_right(Word x) {
        return hn::ShiftRight<kBits>(x);
    }
    static HWY_INLINE Word shifted_right(Word x, Word bits) { return hn::Shr(x, bits); }
    static HWY_INLINE Word shifted_right_by(Word x, int bits) {
        return hn::ShiftRightSame(x, bits);
    }
    /// Out of registers, where these are wide enough.
    static HWY_INLINE Word one_of_sixteen(const std::uint32_t (&table)[16], Int index) {
        const WordTag d;
        if constexpr (hn::MaxLanes(WordTag()) >= 16) {
            return hn::TableLookupLanes(hn::LoadU(d, table), hn::IndicesFromVec(d, index));
        } else if constexpr (hn::MaxLanes(WordTag()) == 8) {
            // The two halves of the table; eight lanes take three bits of the index.
            const auto place = hn::IndicesFromVec(d, hn::And(index, all_int(7)));
            const Word low = hn::TableLookupLanes(hn::LoadU(d, table), place);
            const Word high = hn::TableLookupLanes(hn::LoadU(d, table + 8), place);
            return hn::IfThenElse(hn::RebindMask(d, hn::Gt(index, all_int(7))), high, low);
        } else {
            return hn::GatherIndex(d, table, index);
        }
    }
    template <int kBits>
    static HWY_INLINE Int shifted_right_int(Int x) {
        return hn::ShiftRight<kBits>(x);
    }

    static HWY_INLINE Value load(const Number* from) { return hn::LoadU(D(), from); }
    static HWY_INLINE Int load_int(const std::int32_t* from) { return hn::LoadU(IntTag(), from); }
    static HWY_INLINE void store(Value x, Number* to) { hn::StoreU(x, D(), to); }
    static HWY_INLINE void store_int(Int x, std::int32_t* to) { hn::StoreU(x, IntTag(), to); }

    static HWY_INLINE Value gather(const float* numbers, Int index) {
        return hn::GatherIndex(D(), numbers, index);
    }
    static HWY_INLINE void scatter(Value x, float* numbers, Int index) {
        hn::ScatterIndex(x, D(), numbers, index);
    }
    static HWY_INLINE Int gather_int(const std::int32_t* numbers, Int index) {
        return hn::GatherIndex(IntTag(), numbers, index);
    }
    static HWY_INLINE Word gather_bytes(const void* from, Int byte) {
        return hn::GatherOffset(WordTag(), static_cast<const std::uint32_t*>(from), byte);
    }

    struct Pair {
        Value first, second;
    };
    static HWY_INLINE Pair gather_pair(const float* numbers, Int index) {
        const WordPair bits = gather_bytes_pair(numbers, hn::ShiftLeft<2>(index));
        return {hn::BitCast(D(), bits.first), hn::BitCast(D(), bits.second)};
    }
    struct WordPair {
        Word first, second;
    };
    /// Processors gather one long number in about the time of a short one.
    static HWY_INLINE WordPair gather_bytes_pair(const void* from, Int byte) {
#if HWY_TARGET == HWY_SCALAR
        return {gather_bytes(from, byte), gather_bytes(from, byte + all_int(4))};
#else
        const hn::Half<IntTag> half;
        const Word low = gather_long(from, hn::LowerHalf(half, byte));
        const Word high = gather_long(from, hn::UpperHalf(half, byte));
        return {hn::ConcatEven(WordTag(), high, low), hn::ConcatOdd(WordTag(), high, low)};
#endif
    }

    static HWY_INLINE Value flip_sign(Value x, Value by) {
        return hn::Xor(x, hn::And(by, hn::SignBit(D())));
    }

    static HWY_INLINE Word reversed_bits(Word x) {
        if constexpr (hn::MaxLanes(WordTag()) == 1) {
            return all_word(ScalarLanes<float>::reversed_bits(hn::GetLane(x)));
        } else {
            return reversed_by_tables(x);
        }
    }

  private:
#if HWY_TARGET != HWY_SCALAR
    /// For each of half as many bytes the two words that begin there.
    template <class HalfInt>
    static HWY_INLINE Word gather_long(const void* from, HalfInt byte) {
        const hn::Repartition<std::uint64_t, WordTag> longs;
        const hn::RebindToSigned<decltype(longs)> offsets;
        return hn::BitCast(WordTag(),
                           hn::GatherOffset(longs, static_cast<const std::uint64_t*>(from),
                                            hn::PromoteTo(offsets, byte)));
    }
#endif

    /// Nibbles by a table lookup, then bytes by another.
    static HWY_INLINE Word reversed_by_tables(Word x) {
        const hn::Repartition<std::uint8_t, WordTag> bytes;
        alignas(16) static constexpr std::uint8_t kNibbles[16] = {
            0x0, 0x8, 0x4, 0xc, 0x2, 0xa, 0x6, 0xe, 0x1, 0x9, 0x5, 0xd, 0x3, 0xb, 0x7, 0xf};
        alignas(16) static constexpr std::uint8_t kBytes[16] = {3,  2,  1, 0, 7,  6,  5,  4,
                                                                11, 10, 9, 8, 15, 14, 13, 12};
        const auto table = hn::LoadDup128(bytes, kNibbles);
        const auto reversed = [&](Word nibbles) HWY_ATTR {
            const auto found = hn::TableLookupBytes(table, hn::BitCast(bytes, nibbles));
            return hn::BitCast(WordTag(), found);
        };
        const Word mask = all_word(0x0f0f0f0fu);
        const Word joined = hn::Or(hn::ShiftLeft<4>(reversed(hn::And(x, mask))),
                                   reversed(hn::And(hn::ShiftRight<4>(x), mask)));
        return hn::BitCast(WordTag(), hn::TableLookupBytes(hn::BitCast(bytes, joined),
                                                           hn::LoadDup128(bytes, kBytes)));
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
