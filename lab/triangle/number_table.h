// The numbers of many rays or triangles in memory, for tests of several at once.
#pragma once

#include <cstddef>
#include <tuple>
#include <utility>

#include <hwy/aligned_allocator.h>

#include "lab/triangle/variant.h"

namespace carom::render::triangle {

/// Item by item `kNumbers` numbers. kTechnique: `structures` keeps the numbers of an item together,
/// `arrays` has one array for each number; every other has blocks of kBlock items, number by
/// number.
template <class T, std::size_t kNumbers, std::size_t kBlock, Technique kTechnique>
class NumberTable {
  public:
    /// Between the same numbers of two neighbouring items (of a block).
    static constexpr std::size_t kStride = kTechnique == Technique::structures ? kNumbers : 1;

    /// `count`: a multiple of kBlock.
    explicit NumberTable(std::size_t count)
        : count_(count), numbers_(hwy::AllocateAligned<T>(count * kNumbers)) {}

    [[nodiscard, gnu::always_inline]] T* place(std::size_t item, std::size_t number) const {
        if constexpr (kTechnique == Technique::structures) {
            return &numbers_[item * kNumbers + number];
        } else if constexpr (kTechnique == Technique::arrays) {
            return &numbers_[number * count_ + item];
        } else {
            return &numbers_[(item / kBlock * kNumbers + number) * kBlock + item % kBlock];
        }
    }

  private:
    std::size_t count_;
    hwy::AlignedFreeUniquePtr<T[]> numbers_;
};

/// Stores the numbers of one item.
template <class Numbers, class Table, std::size_t... kIndices>
void store_numbers(Numbers numbers, const Table& table, std::size_t item,
                   std::index_sequence<kIndices...> /*indices*/) {
    ((*table.place(item, kIndices) = std::get<kIndices>(numbers)), ...);
}

}  // namespace carom::render::triangle
