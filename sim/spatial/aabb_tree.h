// A tree of axis-aligned bounding boxes of static objects.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vectors.h"

namespace carom::sim {

struct Aabb {
    Vec3 low{0, 0, 0};
    Vec3 high{0, 0, 0};

    void extend(const Vec3& point);
    void extend(const Aabb& box);
    void grow(double margin);
    /// Squared distance of a point from the box; 0 inside.
    [[nodiscard]] double squared_distance(const Vec3& point) const;
    [[nodiscard]] bool overlaps(const Aabb& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
               other.low.y <= high.y && low.z <= other.high.z && other.low.z <= high.z;
    }
};

class AabbTree {
  public:
    AabbTree() = default;
    explicit AabbTree(std::vector<Aabb> boxes);

    /// Replaces `found` by the indices of all boxes that overlap `box`, ascending.
    void query(const Aabb& box, std::vector<std::uint32_t>& found) const;
    /// Replaces `found` by the indices of all boxes within `distance` of a point, ascending.
    void query(const Vec3& point, double distance, std::vector<std::uint32_t>& found) const;

  private:
    struct Node {
        Aabb box;
        std::uint32_t first = 0;  // inner node: the left child, followed by the right one
        std::uint32_t count = 0;  // leaf: number of entries of order_ from `first`; inner node: 0
    };
    template <class Predicate>
    void walk(const Predicate& is_hit, std::vector<std::uint32_t>& found) const;
    void split(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

    std::vector<Aabb> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace carom::sim
