#include "lab/structures/slab_hierarchy.h"

#include <cmath>
#include <numeric>

namespace carom::render {

const std::array<V3f, SlabHierarchy::kNormals>& SlabHierarchy::normals() {
    static const float kThird = 1 / std::sqrt(3.0f);
    static const std::array<V3f, kNormals> all = {V3f(1, 0, 0),
                                                  V3f(0, 1, 0),
                                                  V3f(0, 0, 1),
                                                  V3f(kThird, kThird, kThird),
                                                  V3f(-kThird, kThird, kThird),
                                                  V3f(-kThird, -kThird, kThird),
                                                  V3f(kThird, -kThird, kThird)};
    return all;
}

SlabHierarchy::SlabHierarchy(const Primitives& primitives) {
    std::vector<std::array<Extent, kNormals>> extents;
    for (const Primitive& shape : primitives.bounded()) {
        std::array<Extent, kNormals> slabs;
        for (std::size_t k = 0; k < kNormals; ++k) {
            slabs[k] = extent_along(primitives, shape, normals()[k]);
        }
        extents.push_back(slabs);
    }
    std::vector<std::uint32_t> order(extents.size());
    std::iota(order.begin(), order.end(), 0u);
    if (!order.empty()) {
        nodes_.reserve(2 * order.size());
        build(order, 0, order.size(), extents);
    }
}

// Splits in half across the axis along which the shapes' centres spread farthest.
std::uint32_t SlabHierarchy::build(std::vector<std::uint32_t>& order, std::size_t first,
                                   std::size_t count,
                                   const std::vector<std::array<Extent, kNormals>>& extents) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Node node;
    if (count == 1) {
        node.slabs = extents[order[first]];
        node.left = order[first];
        nodes_[index] = node;
        return index;
    }
    const auto middle_of = [&](std::uint32_t shape, std::size_t axis) {
        return extents[shape][axis].low + extents[shape][axis].high;
    };
    std::array<Extent, 3> spread;
    for (std::size_t i = first; i < first + count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float middle = middle_of(order[i], axis);
            spread[axis].extend({middle, middle});
        }
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        const float size = spread[k].high - spread[k].low;
        axis = size > spread[axis].high - spread[axis].low ? k : axis;
    }
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
    const auto half = static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(begin, begin + half, begin + static_cast<std::ptrdiff_t>(count),
                     [&](std::uint32_t a, std::uint32_t b) {
                         const float at_a = middle_of(a, axis);
                         const float at_b = middle_of(b, axis);
                         return at_a < at_b || (at_a == at_b && a < b);
                     });
    node.left = build(order, first, count / 2, extents);
    node.right = build(order, first + count / 2, count - count / 2, extents);
    for (std::size_t k = 0; k < kNormals; ++k) {
        node.slabs[k] = nodes_[node.left].slabs[k];
        node.slabs[k].extend(nodes_[node.right].slabs[k]);
    }
    nodes_[index] = node;
    return index;
}

}  // namespace carom::render
