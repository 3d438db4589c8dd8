// Loads of rays and triangles in lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_TRIANGLE_NUMBER_LOADS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_TRIANGLE_NUMBER_LOADS_INL_H
#undef CAROM_TRIANGLE_NUMBER_LOADS_INL_H
#else
#define CAROM_TRIANGLE_NUMBER_LOADS_INL_H
#endif

#include "lab/triangle/kernels-inl.h"
#include "lab/triangle/number_table.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

/// One number of the items from `item` on, which are in the same block.
template <class D, class Table>
HWY_INLINE hn::Vec<D> load(const Table& table, std::size_t item, std::size_t number) {
    const D d;
    const auto* from = table.place(item, number);
    if constexpr (Table::kStride == 1) {
        return hn::LoadU(d, from);
    } else {
        const hn::RebindToSigned<D> to_index;
        const auto stride = hn::Set(to_index, static_cast<int>(Table::kStride));
        return hn::GatherIndex(d, from, hn::Mul(hn::Iota(to_index, 0), stride));
    }
}

/// The rays of a set: x, y, z of the origin, x, y, z of the direction.
template <class T, std::size_t kBlock, Technique kTechnique>
NumberTable<T, 6, kBlock, kTechnique> table_of_rays(const TestSet& set) {
    NumberTable<T, 6, kBlock, kTechnique> table(set.origins.size());
    for (std::size_t i = 0; i < set.origins.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            *table.place(i, static_cast<std::size_t>(axis)) = set.origins[i][axis];
            *table.place(i, static_cast<std::size_t>(axis + 3)) = set.directions[i][axis];
        }
    }
    return table;
}

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
