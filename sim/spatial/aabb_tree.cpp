#include "sim/spatial/aabb_tree.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace carom::sim {
namespace {

constexpr std::uint32_t kLeafSize = 8;

int longest_axis(const Aabb& box) {
    const Vec3 size = box.high - box.low;
    if (size.x >= size.y && size.x >= size.z) {
        return 0;
    }
    return size.y >= size.z ? 1 : 2;
}

}  // namespace

void Aabb::grow(double margin) {
    low -= Vec3(margin);
    high += Vec3(margin);
}

AabbTree::AabbTree(const std::vector<Aabb>& boxes) {
    if (boxes.empty()) {
        return;
    }
    items_.reserve(boxes.size());
    for (const Aabb& box : boxes) {
        items_.push_back({box, static_cast<std::uint32_t>(items_.size())});
    }
    nodes_.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(items_.size()));
}

/// Moves the items with the lowest centres along the axis before `middle`.
template <double Vec3::*kAxis>
void AabbTree::partition(std::span<Item> items, std::size_t middle) {
    const auto centre = [](const Item& item) { return item.box.low.*kAxis + item.box.high.*kAxis; };
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle),
                     items.end(), [&](const Item& a, const Item& b) {
                         return centre(a) < centre(b) ||
                                (centre(a) == centre(b) && a.index < b.index);
                     });
}

void AabbTree::split(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    const std::span<Item> items(items_.data() + begin, end - begin);
    Aabb box = items.front().box;
    for (const Item& item : items) {
        box.extend(item.box);
    }
    nodes_[node].box = box;
    if (items.size() <= kLeafSize) {
        nodes_[node].first = begin;
        nodes_[node].count = end - begin;
        return;
    }
    const std::uint32_t half = (end - begin) / 2;
    switch (longest_axis(box)) {
        case 0:
            partition<&Vec3::x>(items, half);
            break;
        case 1:
            partition<&Vec3::y>(items, half);
            break;
        default:
            partition<&Vec3::z>(items, half);
    }
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].first = children;
    nodes_.resize(nodes_.size() + 2);
    split(children, begin, begin + half);
    split(children + 1, begin + half, end);
}

void AabbTree::query(const Aabb& box, std::vector<std::uint32_t>& found) const {
    walk([&](const Aabb& candidate) { return candidate.overlaps(box); }, found);
}

void AabbTree::query(const Vec3& point, double distance, std::vector<std::uint32_t>& found) const {
    walk([&](const Aabb& box) { return box.squared_distance(point) <= distance * distance; },
         found);
}

void AabbTree::query(const Aabb& box, const Vec3& point, double distance,
                     std::vector<std::uint32_t>& found) const {
    walk(
        [&](const Aabb& candidate) {
            return candidate.overlaps(box) &&
                   candidate.squared_distance(point) <= distance * distance;
        },
        found);
}

template <class Predicate>
void AabbTree::walk(const Predicate& is_hit, std::vector<std::uint32_t>& found) const {
    found.clear();
    if (nodes_.empty()) {
        return;
    }
    std::array<std::uint32_t, 64> stack{};
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (!is_hit(node.box)) {
            continue;
        }
        if (node.count == 0) {
            stack[depth++] = node.first;
            stack[depth++] = node.first + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            if (is_hit(items_[i].box)) {
                found.push_back(items_[i].index);
            }
        }
    }
    std::sort(found.begin(), found.end());
}

}  // namespace carom::sim
