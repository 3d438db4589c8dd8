// Moving chosen lanes of vectors to their front. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_PACKED_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_PACKED_LANES_INL_H
#undef CAROM_PACKED_LANES_INL_H
#else
#define CAROM_PACKED_LANES_INL_H
#endif

#include <cstdint>

#include "render/lanes/packing_table.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The lanes of a mask, which `pack` moves to the front of vectors of floats or 32-bit integers;
/// what follows them is undefined. Where no instruction does it, the permutation is looked up once
/// for all of them: Highway 1.0.3 looks it up for each vector, in a table that gcc copies to the
/// stack every time.
class PackedLanes {
    using FloatTag = hn::CappedTag<float, 16>;
    using IntTag = hn::RebindToSigned<FloatTag>;
    using WordTag = hn::RebindToUnsigned<FloatTag>;
    using Mask = hn::Mask<FloatTag>;

  public:
#if HWY_TARGET == HWY_AVX2
    HWY_INLINE explicit PackedLanes(Mask mask)
        : count_(static_cast<int>(hn::CountTrue(FloatTag(), mask))) {
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(FloatTag(), mask, bits);
        const auto places = hn::Set(WordTag(), kPackingTable[bits[0]]);
        const auto each = places >> hn::ShiftLeft<2>(hn::Iota(WordTag(), 0));
        lanes_ = hn::And(each, hn::Set(WordTag(), 7));
    }
    template <class Vector>
    [[nodiscard]] HWY_INLINE Vector pack(Vector value) const {
        const hn::DFromV<Vector> d;
        return hn::TableLookupLanes(value, hn::IndicesFromVec(d, lanes_));
    }
#else
    HWY_INLINE explicit PackedLanes(Mask mask)
        : count_(static_cast<int>(hn::CountTrue(FloatTag(), mask))), lanes_(mask) {}
    template <class Vector>
    [[nodiscard]] HWY_INLINE Vector pack(Vector value) const {
        return hn::Compress(value, hn::RebindMask(hn::DFromV<Vector>(), lanes_));
    }
#endif

    /// How many lanes there are.
    [[nodiscard]] HWY_INLINE int count() const {
        return count_;
    }

  private:
    int count_;
#if HWY_TARGET == HWY_AVX2
    hn::Vec<WordTag> lanes_;
#else
    Mask lanes_;
#endif
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
