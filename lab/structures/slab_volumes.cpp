#include "lab/structures/slab_volumes.h"

namespace carom::render {

template <std::size_t kSlabs>
const std::array<V3f, kSlabs>& SlabVolumes<kSlabs>::normals() {
    static const std::array<V3f, kSlabs> all = [] {
        const float third = 1 / std::sqrt(3.0f);
        const std::array<V3f, 7> known = {V3f(1, 0, 0),
                                          V3f(0, 1, 0),
                                          V3f(0, 0, 1),
                                          V3f(third, third, third),
                                          V3f(-third, third, third),
                                          V3f(-third, -third, third),
                                          V3f(third, -third, third)};
        std::array<V3f, kSlabs> first;
        std::copy_n(known.begin(), kSlabs, first.begin());
        return first;
    }();
    return all;
}

template <std::size_t kSlabs>
auto SlabVolumes<kSlabs>::around(const Outlines& outlines, std::uint32_t shape) -> Volume {
    Volume volume;
    for (std::size_t k = 0; k < kSlabs; ++k) {
        volume[k] = outlines.extent(shape, normals()[k]);
    }
    return volume;
}

template <std::size_t kSlabs>
auto SlabVolumes<kSlabs>::around(const Outlines& /*outlines*/,
                                 std::span<const std::uint32_t> /*shapes*/, const Volume& left,
                                 const Volume& right) -> Volume {
    Volume volume = left;
    for (std::size_t k = 0; k < kSlabs; ++k) {
        volume[k].extend(right[k]);
    }
    return volume;
}

template struct SlabVolumes<3>;
template struct SlabVolumes<7>;

}  // namespace carom::render
