// A vector for data with random access.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include <sys/mman.h>

namespace carom::render {

/// Aligned to cache lines. Large arrays request huge pages, because otherwise each random access
/// also costs a walk through the page table.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class U>
    explicit LargePages(const LargePages<U>& /*other*/) {}

    [[nodiscard]] T* allocate(std::size_t count) {
        constexpr std::size_t kLine = 64;
        constexpr std::size_t kPage = std::size_t{2} << 20;
        const std::size_t bytes = count * sizeof(T);
        const bool is_large = bytes >= kPage;
        const std::size_t unit = is_large ? kPage : kLine;
        // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the vector owns it
        void* memory = std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit);
        if (memory == nullptr) {
            throw std::bad_alloc();
        }
        if (is_large) {
            ::madvise(memory, (bytes + unit - 1) / unit * unit, MADV_HUGEPAGE);  // may be refused
        }
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t /*count*/) {
        std::free(memory);  // NOLINT(cppcoreguidelines-owning-memory)
    }

    bool operator==(const LargePages& /*other*/) const { return true; }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace carom::render
