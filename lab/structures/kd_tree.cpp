#include "lab/structures/kd_tree.h"

#include <optional>

namespace carom::render {
namespace {

using Box = Imath::Box3f;
using Members = KdTree::Members;

constexpr std::size_t kPlaces = 32;
constexpr int kFew = 2;              // nodes with so few shapes are not split
constexpr float kPlaneCost = 0.3f;   // of a node, in tests of a shape and its box
constexpr float kEmptyBonus = 0.8f;  // of the cost, for cutting off empty space
constexpr double kMostCopies =
    0.75;  // bound on a node's members on both sides, as a fraction of them

struct Plane {
    int axis = 0;
    float place = 0;
};

struct Builder {
    KdTree& tree;
    std::size_t few = 0;
    int deepest = 0;

    [[nodiscard]] std::optional<Plane> best_plane(const Members& members, const Box& region) const;
    std::uint32_t build(const Members& members, const Box& region, int depth);
};

// The numbers of boxes that begin before each place and end behind it give the numbers on both
// sides.
std::optional<Plane> Builder::best_plane(const Members& members, const Box& region) const {
    const float area = half_area(region);
    auto best = std::optional<Plane>();
    float best_cost = static_cast<float>(members.size());
    for (int axis = 0; axis < 3; ++axis) {
        const float low = region.min[axis];
        const float size = region.max[axis] - low;
        if (!(size > 0)) {
            continue;
        }
        std::array<std::size_t, kPlaces + 1> begins{};
        std::array<std::size_t, kPlaces + 1> ends{};
        const auto bin = [&](float place) {
            const float place_in_bins = (place - low) / size * static_cast<float>(kPlaces);
            return static_cast<std::size_t>(
                std::clamp(place_in_bins, 0.0f, static_cast<float>(kPlaces)));
        };
        for (const std::uint32_t member : members) {
            begins[std::min(bin(tree.boxes[member].min[axis]), kPlaces - 1)] += 1;
            ends[std::min(bin(tree.boxes[member].max[axis]), kPlaces - 1)] += 1;
        }
        std::size_t below = 0;
        std::size_t above = members.size();
        for (std::size_t i = 1; i < kPlaces; ++i) {
            below += begins[i - 1];
            above -= ends[i - 1];
            Box left = region;
            Box right = region;
            const float place = low + size * (static_cast<float>(i) / static_cast<float>(kPlaces));
            left.max[axis] = place;
            right.min[axis] = place;
            const float tests = half_area(left) * static_cast<float>(below) +
                                half_area(right) * static_cast<float>(above);
            const float scale = below == 0 || above == 0 ? kEmptyBonus : 1.0f;
            const float cost = scale * (kPlaneCost + tests / area);
            if (cost < best_cost && place > low && place < region.max[axis]) {
                best_cost = cost;
                best = Plane{axis, place};
            }
        }
    }
    return best;
}

std::uint32_t Builder::build(const Members& members, const Box& region, int depth) {
    if (members.size() <= few || depth >= deepest) {
        return tree.add_leaf(members);
    }
    const auto plane = best_plane(members, region);
    if (!plane) {
        return tree.add_leaf(members);
    }
    Members low;
    Members high;
    for (const std::uint32_t member : members) {
        const Box& box = tree.boxes[member];
        if (box.min[plane->axis] <= plane->place) {
            low.push_back(member);
        }
        if (box.max[plane->axis] >= plane->place) {
            high.push_back(member);
        }
    }
    const auto most = static_cast<std::size_t>(kMostCopies * static_cast<double>(members.size()));
    const bool is_useless = low.size() + high.size() > members.size() + most;
    if (is_useless || (low.size() == members.size() && high.size() == members.size())) {
        return tree.add_leaf(members);
    }
    Box left = region;
    Box right = region;
    left.max[plane->axis] = plane->place;
    right.min[plane->axis] = plane->place;
    return tree.add_node(
        plane->place, static_cast<std::size_t>(plane->axis),
        [&] { return build(low, left, depth + 1); }, [&] { return build(high, right, depth + 1); });
}

}  // namespace

KdTree::KdTree(const Primitives& primitives, const StructureSizes& sizes)
    : PlanesTree({V3f(1, 0, 0), V3f(0, 1, 0), V3f(0, 0, 1)}, swept_boxes(primitives)) {
    if (!boxes.empty()) {
        Builder{*this, sizes.leaf_capacity_or(kFew), most_levels()}.build(all_shapes(), bounds, 0);
    }
}

}  // namespace carom::render
