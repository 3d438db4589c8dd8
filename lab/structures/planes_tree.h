// Traversal of space that planes divide recursively: kd-tree and BSP tree.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "lab/structures/boxes.h"
#include "lab/structures/mailbox.h"

namespace carom::render {

/// Planes with one of `kNormals` normals. A shape is in every leaf that it may overlap. It is
/// tested once, as far as the mailbox remembers, and only if the ray enters its own box.
template <std::size_t kNormals>
class PlanesTree {
  public:
    using Normals = std::array<V3f, kNormals>;

    /// Without nodes.
    PlanesTree(const Normals& normals, std::vector<Imath::Box3f> boxes_of_shapes)
        : boxes(std::move(boxes_of_shapes)), normals_(normals) {
        for (const Imath::Box3f& box : boxes) {
            bounds.extendBy(box);
        }
    }

    struct Node {
        double offset = 0;         // of the plane: normal . p = offset
        std::uint32_t normal = 0;  // kNormals: a leaf
        std::uint32_t low = 0;     // the node below the plane; for a leaf: its first shape
        std::uint32_t high = 0;    // the node above; for a leaf: its number of shapes
    };

    Imath::Box3f bounds;
    std::vector<Imath::Box3f> boxes;  // by shape
    std::vector<Node> nodes;          // the root first; none without shapes
    std::vector<std::uint32_t> shapes;

    using Members = std::vector<std::uint32_t>;

    [[nodiscard]] Members all_shapes() const {
        Members all(boxes.size());
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }
    /// The depth found by Havran 2000, "Heuristic ray shooting algorithms", section 4.5. Requires a
    /// shape.
    [[nodiscard]] int most_levels() const {
        return 8 + static_cast<int>(1.3 * std::log2(static_cast<double>(boxes.size())));
    }
    /// Adds a node, then what `build_low` and `build_high` add, which return their node. Returns
    /// the index.
    template <class BuildLow, class BuildHigh>
    std::uint32_t add_node(float offset, std::size_t normal, const BuildLow& build_low,
                           const BuildHigh& build_high) {
        const auto index = static_cast<std::uint32_t>(nodes.size());
        nodes.push_back({static_cast<double>(offset), static_cast<std::uint32_t>(normal), 0, 0});
        const std::uint32_t low = build_low();
        const std::uint32_t high = build_high();
        nodes[index].low = low;
        nodes[index].high = high;
        return index;
    }
    /// Returns its index.
    std::uint32_t add_leaf(const Members& members) {
        nodes.push_back({0, kNormals, static_cast<std::uint32_t>(shapes.size()),
                         static_cast<std::uint32_t>(members.size())});
        shapes.insert(shapes.end(), members.begin(), members.end());
        return static_cast<std::uint32_t>(nodes.size() - 1);
    }

    [[nodiscard]] std::size_t bytes() const {
        return bytes_of(boxes) + bytes_of(nodes) + bytes_of(shapes);
    }

    template <class Query>
    void search(Query& query) const {
        float enter = 0;
        if (nodes.empty() || !query.enters(bounds, enter)) {
            return;
        }
        const Ray& ray = query.ray();
        std::array<Projected, kNormals> along{};
        for (std::size_t i = 0; i < kNormals; ++i) {
            const Vec3 normal(normals_[i]);
            along[i] = {normal.dot(Vec3(ray.origin)), normal.dot(Vec3(ray.direction))};
        }
        Mailbox mailbox;
        std::vector<Part> stack;
        stack.reserve(kReserve);
        Part part{0, static_cast<double>(enter), static_cast<double>(kInfinity)};
        for (;;) {
            const Node& node = nodes[part.node];
            query.note_node();
            if (node.normal < kNormals) {
                query.note_boxes(1);
                const Projected& p = along[node.normal];
                const bool is_low =
                    p.origin < node.offset || (p.origin == node.offset && p.direction <= 0);
                const std::uint32_t near = is_low ? node.low : node.high;
                const std::uint32_t far = is_low ? node.high : node.low;
                const double t = p.direction != 0 ? (node.offset - p.origin) / p.direction : -1;
                if (!(t > 0) || t > part.to) {  // a ray from the plane itself has one side ahead
                    part.node = near;
                } else if (t < part.from) {
                    part.node = far;
                } else {
                    stack.push_back({far, t, part.to});
                    part = {near, part.from, t};
                }
                continue;
            }
            if (visit_leaf(node, mailbox, query)) {
                return;
            }
            if (stack.empty() || query.is_beyond(stack.back().from)) {
                return;
            }
            part = stack.back();
            stack.pop_back();
        }
    }

  private:
    struct Part {
        std::uint32_t node;
        double from, to;  // interval of the ray
    };
    struct Projected {
        double origin, direction;
    };
    static constexpr std::size_t kReserve = 64;

    template <class Query>
    [[nodiscard]] bool visit_leaf(const Node& leaf, Mailbox& mailbox, Query& query) const {
        for (std::uint32_t i = leaf.low; i < leaf.low + leaf.high; ++i) {
            const std::uint32_t shape = shapes[i];
            float enter = 0;
            if (!mailbox.knows(shape) && query.enters(boxes[shape], enter) && query.test(shape)) {
                return true;
            }
        }
        return false;
    }

    Normals normals_;
};

}  // namespace carom::render
