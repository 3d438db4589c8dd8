// A tree of axis-aligned bounding boxes of static objects.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vectors.h"

namespace carom::sim {

struct Aabb {
    Vec3 low{0, 0, 0};
    Vec3 high{0, 0, 0};

    void extend(const Vec3& point) { extend(Aabb{point, point}); }
    void extend(const Aabb& box) {
        low = Vec3(std::min(low.x, box.low.x), std::min(low.y, box.low.y),
                   std::min(low.z, box.low.z));
        high = Vec3(std::max(high.x, box.high.x), std::max(high.y, box.high.y),
                    std::max(high.z, box.high.z));
    }
    void grow(double margin);
    /// Squared distance of a point from the box; 0 inside.
    [[nodiscard]] double squared_distance(const Vec3& point) const {
        const Vec3 nearest(std::clamp(point.x, low.x, high.x), std::clamp(point.y, low.y, high.y),
                           std::clamp(point.z, low.z, high.z));
        const Vec3 d = point - nearest;
        return d.dot(d);
    }
    [[nodiscard]] bool overlaps(const Aabb& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
               other.low.y <= high.y && low.z <= other.high.z && other.low.z <= high.z;
    }
};

class AabbTree {
  public:
    AabbTree() = default;
    explicit AabbTree(const std::vector<Aabb>& boxes);

    /// Replaces `found` by the indices of all boxes that overlap `box`, ascending.
    void query(const Aabb& box, std::vector<std::uint32_t>& found) const;
    /// Replaces `found` by the indices of all boxes within `distance` of a point, ascending.
    void query(const Vec3& point, double distance, std::vector<std::uint32_t>& found) const;
    /// Replaces `found` by the indices of all boxes for which both hold, ascending.
    void query(const Aabb& box, const Vec3& point, double distance,
               std::vector<std::uint32_t>& found) const;

  private:
    struct Node {
        Aabb box;
        std::uint32_t first = 0;  // inner node: the left child, followed by the right one
        std::uint32_t count = 0;  // leaf: number of items from `first`; inner node: 0
    };
    /// A box and its index in the list that the tree was made of.
    struct Item {
        Aabb box;
        std::uint32_t index = 0;
    };
    template <class Predicate>
    void walk(const Predicate& is_hit, std::vector<std::uint32_t>& found) const;
    void split(std::uint32_t node, std::uint32_t begin, std::uint32_t end);
    template <double Vec3::*kAxis>
    static void partition(std::span<Item> items, std::size_t middle);

    std::vector<Item> items_;  // those of a leaf are adjacent
    std::vector<Node> nodes_;
};

}  // namespace carom::sim
