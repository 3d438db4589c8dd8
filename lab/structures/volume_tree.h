// A hierarchy of bounding volumes of any kind.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "lab/structures/outlines.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

/// Kay and Kajiya 1986, "Ray tracing complex scenes": a binary tree, in which the shapes are halved
/// by their centres along the axis of the widest spread; nodes are taken from a heap by the
/// distance at which the ray enters them. Trees with different volumes have the same nodes.
///
/// `Volumes` has
/// - Volume, a type;
/// - static Volume around(const Outlines&, std::uint32_t shape);
/// - static Volume around(const Outlines&, std::span<const std::uint32_t> shapes, const Volume&
///   left, const Volume& right), for the volumes of both halves of these shapes;
/// - Probe(const Ray&), with bool enters(const Volume&, float t_max, float& enter): whether the ray
///   enters the volume before t_max; if so, `enter` is the distance.
template <class Volumes>
class VolumeTree {
  public:
    VolumeTree(const Primitives& primitives, const StructureSizes& /*sizes*/) {
        const Outlines outlines(primitives);
        std::vector<std::uint32_t> order(outlines.size());
        std::iota(order.begin(), order.end(), 0u);
        if (!order.empty()) {
            nodes_.reserve(2 * order.size());
            build(outlines, order);
        }
    }

    template <class Query>
    void search(Query& query) const {
        if (nodes_.empty()) {
            return;
        }
        const typename Volumes::Probe probe(query.ray());
        std::vector<Waiting> storage;
        storage.reserve(64);
        std::priority_queue<Waiting> heap({}, std::move(storage));
        const auto consider = [&](std::uint32_t node) {
            query.note_boxes(1);
            float enter = 0;
            if (probe.enters(nodes_[node].volume, query.t_max(), enter)) {
                heap.push({enter, node});
            }
        };
        consider(0);
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
            consider(node.left);
            consider(node.right);
        }
    }

    [[nodiscard]] std::size_t bytes() const { return bytes_of(nodes_); }

  private:
    using Volume = typename Volumes::Volume;

    struct Node {
        Volume volume;
        std::uint32_t left = 0;   // a node; for a leaf: the shape
        std::uint32_t right = 0;  // 0: a leaf
    };
    struct Waiting {
        float enter;
        std::uint32_t node;
        // The heap's top is the nearest node.
        bool operator<(const Waiting& other) const { return enter > other.enter; }
    };

    std::uint32_t build(const Outlines& outlines, std::span<std::uint32_t> shapes) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        if (shapes.size() == 1) {
            nodes_[index] = {Volumes::around(outlines, shapes[0]), shapes[0], 0};
            return index;
        }
        halve(outlines, shapes);
        const std::uint32_t left = build(outlines, shapes.first(shapes.size() / 2));
        const std::uint32_t right = build(outlines, shapes.subspan(shapes.size() / 2));
        nodes_[index] = {
            Volumes::around(outlines, shapes, nodes_[left].volume, nodes_[right].volume), left,
            right};
        return index;
    }

    static void halve(const Outlines& outlines, std::span<std::uint32_t> shapes) {
        Imath::Box3f centres;
        for (const std::uint32_t shape : shapes) {
            centres.extendBy(outlines.box(shape).center());
        }
        const auto axis = static_cast<int>(centres.majorAxis());
        // Of equal centres the lower index comes first, so that the tree is deterministic.
        const auto place = [&](std::uint32_t shape) {
            return std::pair(outlines.box(shape).center()[axis], shape);
        };
        std::nth_element(
            shapes.begin(), shapes.begin() + static_cast<std::ptrdiff_t>(shapes.size() / 2),
            shapes.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    }

    std::vector<Node> nodes_;  // the root is the first
};

}  // namespace carom::render
