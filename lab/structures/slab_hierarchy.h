// A hierarchy of volumes bounded by seven slabs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

#include "lab/structures/extents.h"
#include "render/geometry/scalar_kernels.h"

namespace carom::render {

/// Kay and Kajiya 1986, "Ray tracing complex scenes": volumes between planes perpendicular to the
/// axes and the space diagonals, in a binary tree by sorted centres; nodes are taken from a heap by
/// the distance at which the ray enters them.
class SlabHierarchy {
  public:
    static constexpr std::size_t kNormals = 7;

    explicit SlabHierarchy(const Primitives& primitives);

    template <class Query>
    void search(Query& query) const;

    [[nodiscard]] std::size_t bytes() const { return bytes_of(nodes_); }

  private:
    struct Node {
        std::array<Extent, kNormals> slabs;
        std::uint32_t left = 0;   // a node; for a leaf: the shape
        std::uint32_t right = 0;  // 0: a leaf
    };
    struct HeapEntry {
        float enter;
        std::uint32_t node;
        // The heap's top is the nearest node.
        bool operator<(const HeapEntry& other) const { return enter > other.enter; }
    };
    /// The ray projected onto the normals.
    struct Projected {
        std::array<float, kNormals> origin, inverse, margin;
    };

    template <class Query>
    [[nodiscard]] static bool enters(const Node& node, const Projected& along, Query& query,
                                     float& enter);
    static const std::array<V3f, kNormals>& normals();
    std::uint32_t build(std::vector<std::uint32_t>& order, std::size_t first, std::size_t count,
                        const std::vector<std::array<Extent, kNormals>>& extents);

    std::vector<Node> nodes_;  // the root is the first
};

template <class Query>
bool SlabHierarchy::enters(const Node& node, const Projected& along, Query& query, float& enter) {
    query.note_boxes(1);
    enter = query.ray().t_min;
    float leave = query.t_max();
    for (std::size_t k = 0; k < kNormals && enter <= leave; ++k) {
        const float at_low = (node.slabs[k].low - along.origin[k]) * along.inverse[k];
        const float at_high = (node.slabs[k].high - along.origin[k]) * along.inverse[k];
        enter = std::max(enter, std::min(at_low, at_high) - along.margin[k]);
        leave = std::min(leave, std::max(at_low, at_high) + along.margin[k]);
    }
    return enter <= leave;
}

template <class Query>
void SlabHierarchy::search(Query& query) const {
    if (nodes_.empty()) {
        return;
    }
    const Ray& ray = query.ray();
    const V3f& o = ray.origin;
    const float far = 0x1p-18f * (std::abs(o.x) + std::abs(o.y) + std::abs(o.z));
    Projected along{};
    for (std::size_t k = 0; k < kNormals; ++k) {
        along.origin[k] = normals()[k].dot(o);
        along.inverse[k] = scalar::finite_reciprocal<scalar::One>(normals()[k].dot(ray.direction));
        along.margin[k] = far * std::abs(along.inverse[k]);
    }
    std::vector<HeapEntry> storage;
    storage.reserve(64);
    std::priority_queue<HeapEntry> heap({}, std::move(storage));
    float enter = 0;
    if (enters(nodes_[0], along, query, enter)) {
        heap.push({enter, 0});
    }
    while (!heap.empty() && heap.top().enter <= query.t_max()) {
        const Node& node = nodes_[heap.top().node];
        heap.pop();
        query.note_node();
        if (node.right == 0) {
            if (query.test(node.left)) {
                return;
            }
            continue;
        }
        for (const std::uint32_t below : {node.left, node.right}) {
            if (enters(nodes_[below], along, query, enter)) {
                heap.push({enter, below});
            }
        }
    }
}

}  // namespace carom::render
