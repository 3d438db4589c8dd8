// Hierarchies of boxes: the common part of octree, R-tree and bounding volume hierarchy.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include <Imath/ImathBox.h>

#include "lab/structures/boxes.h"

namespace carom::render {

/// The entries of a node are nodes or shapes, each with its box. A ray visits the entries whose
/// boxes it enters, those of a node nearest first.
class BoxHierarchy {
  public:
    struct Entry {
        Imath::Box3f box;
        std::uint32_t index = 0;  // of a node or a shape
        bool is_shape = false;
    };

    /// Adds a node with these entries, which refer to nodes added before; the last node added is
    /// the root. Returns its index. Requires at least one entry.
    std::uint32_t add_node(const std::vector<Entry>& entries) {
        nodes_.push_back({static_cast<std::uint32_t>(entries_.size()),
                          static_cast<std::uint32_t>(entries.size())});
        entries_.insert(entries_.end(), entries.begin(), entries.end());
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }
    [[nodiscard]] Imath::Box3f box_of(std::uint32_t node) const {
        Imath::Box3f box;
        for (std::uint32_t i = 0; i < nodes_[node].count; ++i) {
            box.extendBy(entries_[nodes_[node].first + i].box);
        }
        return box;
    }
    /// The entry of this node in its parent.
    [[nodiscard]] Entry entry_of(std::uint32_t node) const { return {box_of(node), node, false}; }

    [[nodiscard]] std::size_t bytes() const { return bytes_of(nodes_) + bytes_of(entries_); }

    template <class Query>
    void search(Query& query) const {
        search(query, [&](std::uint32_t shape) { return query.test(shape); });
    }
    /// The same with another test of a shape, which returns whether the search is over.
    template <class Query, class Test>
    void search(Query& query, const Test& test) const {
        if (nodes_.empty()) {
            return;
        }
        std::vector<Waiting> stack;
        stack.reserve(kReserve);
        stack.push_back(root());
        while (!stack.empty()) {
            const Waiting next = stack.back();
            stack.pop_back();
            if (next.enter > query.t_max()) {
                continue;
            }
            if (next.is_shape) {
                if (test(next.index)) {
                    return;
                }
                continue;
            }
            enter_node(nodes_[next.index], query, stack);
        }
    }

    /// The same, where the entries of all nodes wait in one queue, from which the nearest is taken.
    template <class Query>
    void search_by_queue(Query& query) const {
        if (nodes_.empty()) {
            return;
        }
        std::vector<Waiting> storage;
        storage.reserve(kReserve);
        std::priority_queue<Waiting> queue({}, std::move(storage));
        queue.push(root());
        while (!queue.empty() && queue.top().enter <= query.t_max()) {
            const Waiting next = queue.top();
            queue.pop();
            if (next.is_shape) {
                if (query.test(next.index)) {
                    return;
                }
                continue;
            }
            each_entered(nodes_[next.index], query,
                         [&](const Waiting& entered) { queue.push(entered); });
        }
    }

  private:
    struct Node {
        std::uint32_t first = 0, count = 0;  // entries
    };
    struct Waiting {
        float enter;
        std::uint32_t index;
        bool is_shape;
        // The queue's top is the nearest.
        bool operator<(const Waiting& other) const { return enter > other.enter; }
    };
    static constexpr std::size_t kReserve = 64;

    [[nodiscard]] Waiting root() const {
        return {0, static_cast<std::uint32_t>(nodes_.size() - 1), false};
    }

    /// Calls `work` with each entry of the node whose box the ray enters.
    template <class Query, class Work>
    void each_entered(const Node& node, Query& query, const Work& work) const {
        query.note_node();
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Entry& entry = entries_[i];
            float enter = 0;
            if (query.enters(entry.box, enter)) {
                work(Waiting{enter, entry.index, entry.is_shape});
            }
        }
    }

    // Pushes the node's entries, the farthest first.
    template <class Query>
    void enter_node(const Node& node, Query& query, std::vector<Waiting>& stack) const {
        const std::size_t before = stack.size();
        each_entered(node, query, [&](const Waiting& entered) { stack.push_back(entered); });
        std::sort(stack.begin() + static_cast<std::ptrdiff_t>(before), stack.end());
    }

    std::vector<Node> nodes_;
    std::vector<Entry> entries_;
};

}  // namespace carom::render
