// The way of a ray through a wide tree, for one instruction set; included once per set.
#include <bit>
#include <cmath>

#include "render/acceleration/wide_tree.h"
#include "render/geometry/intersect.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One ray as box tests take it. Boxes are widened by a share of the origin's coordinates, so that
/// no box is missed whose shape's own test, rounded otherwise, would hit.
template <class D>
struct TreeRay {
    hn::Vec<D> inverse[3];
    hn::Vec<D> near_share[3], far_share[3];  // origin / direction, moved apart
    hn::Vec<D> t_min;
    hn::Vec<D> time;
    int near_side[3];  // which of two planes the ray meets first

    HWY_INLINE TreeRay(D d, const Ray& ray)
        : t_min(hn::Set(d, ray.t_min)), time(hn::Set(d, ray.time)) {
        constexpr float kShare = 0x1p-18f;
        const V3f& o = ray.origin;
        const float margin = kShare * (std::abs(o.x) + std::abs(o.y) + std::abs(o.z));
        for (int axis = 0; axis < 3; ++axis) {
            const float reciprocal = finite_reciprocal(ray.direction[axis]);
            const float apart = std::copysign(margin, ray.direction[axis]);
            inverse[axis] = hn::Set(d, reciprocal);
            near_share[axis] = hn::Set(d, (o[axis] + apart) * reciprocal);
            far_share[axis] = hn::Set(d, (o[axis] - apart) * reciprocal);
            near_side[axis] = std::signbit(ray.direction[axis]) ? 1 : 0;
        }
    }
};

/// The children whose boxes the ray meets before `limit`, a bit for each, and where it enters them.
template <bool kMoving, class D>
HWY_INLINE unsigned enter_children(D d, const TreeRay<D>& ray, const WideTree& tree,
                                   std::uint32_t index, float limit, float* HWY_RESTRICT enters) {
    const WideNode& node = tree.nodes[index];
    unsigned children = 0;
    for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
        const auto plane = [&](int axis, int side) HWY_ATTR {
            hn::Vec<D> place = hn::LoadU(d, node.planes[axis][side].values + lane);
            if constexpr (kMoving) {
                const float* travel = tree.travels[index].planes[axis][side].values + lane;
                place = hn::MulAdd(ray.time, hn::LoadU(d, travel), place);
            }
            return place;
        };
        hn::Vec<D> enter = ray.t_min;
        hn::Vec<D> leave = hn::Set(d, limit);
        for (int axis = 0; axis < 3; ++axis) {
            const int side = ray.near_side[axis];
            enter = hn::Max(enter,
                            hn::MulSub(plane(axis, side), ray.inverse[axis], ray.near_share[axis]));
            leave = hn::Min(
                leave, hn::MulSub(plane(axis, 1 - side), ray.inverse[axis], ray.far_share[axis]));
        }
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Le(enter, leave), bits);
        hn::StoreU(enter, d, enters + lane);
        children |= static_cast<unsigned>(bits[0]) << lane;
    }
    return children;
}

/// Calls `visit(leaf)` for leaves that the ray meets before `limit`, which visits may lower, the
/// nearest of each node's children first; ends when one returns true.
template <bool kMoving, class D, class Visit>
HWY_INLINE void traverse(D d, const WideTree& tree, const Ray& ray, const float& limit,
                         const Visit& visit) {
    struct Waiting {
        float enter;
        std::int32_t child;
    };
    Waiting waiting[7 * kWideTreeDepth + 8];
    int count = 0;
    const TreeRay<D> tree_ray(d, ray);
    alignas(32) float enters[kBlockLanes];
    std::int32_t current = 0;
    for (;;) {
        if (current >= 0) {
            unsigned children = enter_children<kMoving>(
                d, tree_ray, tree, static_cast<std::uint32_t>(current), limit, enters);
            const std::int32_t* below = tree.nodes[static_cast<std::uint32_t>(current)].children;
            // Into the list, the farthest first.
            const int before = count;
            for (; children != 0; children &= children - 1) {
                const int lane = std::countr_zero(children);
                int at = count++;
                for (; at > before && waiting[at - 1].enter < enters[lane]; --at) {
                    waiting[at] = waiting[at - 1];
                }
                waiting[at] = {enters[lane], below[lane]};
            }
        } else if (visit(static_cast<std::uint32_t>(-1 - current))) {
            return;
        }
        do {
            if (count == 0) {
                return;
            }
            --count;
        } while (waiting[count].enter > limit);
        current = waiting[count].child;
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
