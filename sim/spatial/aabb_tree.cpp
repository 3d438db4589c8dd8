#include "sim/spatial/aabb_tree.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace carom::sim {
namespace {

constexpr std::uint32_t kLeafSize = 4;

int longest_axis(const Aabb& box) {
    const Vec3 size = box.high - box.low;
    if (size.x >= size.y && size.x >= size.z) {
        return 0;
    }
    return size.y >= size.z ? 1 : 2;
}

}  // namespace

void Aabb::extend(const Vec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
    }
}

void Aabb::extend(const Aabb& box) {
    extend(box.low);
    extend(box.high);
}

void Aabb::grow(double margin) {
    low -= Vec3(margin);
    high += Vec3(margin);
}

double Aabb::squared_distance(const Vec3& point) const {
    const Vec3 nearest(std::clamp(point.x, low.x, high.x), std::clamp(point.y, low.y, high.y),
                       std::clamp(point.z, low.z, high.z));
    const Vec3 d = point - nearest;
    return d.dot(d);
}

AabbTree::AabbTree(std::vector<Aabb> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    if (boxes_.empty()) {
        return;
    }
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(boxes_.size()));
}

void AabbTree::split(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    Aabb box = boxes_[order_[begin]];
    for (std::uint32_t i = begin; i < end; ++i) {
        box.extend(boxes_[order_[i]]);
    }
    nodes_[node].box = box;
    if (end - begin <= kLeafSize) {
        nodes_[node].first = begin;
        nodes_[node].count = end - begin;
        return;
    }
    const int axis = longest_axis(box);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double ka = boxes_[a].low[axis] + boxes_[a].high[axis];
                         const double kb = boxes_[b].low[axis] + boxes_[b].high[axis];
                         return ka < kb || (ka == kb && a < b);
                     });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].first = children;
    nodes_.resize(nodes_.size() + 2);
    split(children, begin, middle);
    split(children + 1, middle, end);
}

void AabbTree::query(const Aabb& box, std::vector<std::uint32_t>& found) const {
    walk([&](const Aabb& candidate) { return candidate.overlaps(box); }, found);
}

void AabbTree::query(const Vec3& point, double distance, std::vector<std::uint32_t>& found) const {
    walk([&](const Aabb& box) { return box.squared_distance(point) <= distance * distance; },
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
            if (is_hit(boxes_[order_[i]])) {
                found.push_back(order_[i]);
            }
        }
    }
    std::sort(found.begin(), found.end());
}

}  // namespace carom::sim
