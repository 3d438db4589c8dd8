// Traversal of a wide tree by one ray; included once per instruction set.
#include <bit>
#include <cmath>
#include <utility>

#include "render/acceleration/wide_tree.h"
#include "render/geometry/scalar_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One ray in the form that box tests need. Boxes are widened by a fraction of the origin's
/// coordinates, so that rounding never makes a box test miss a shape that the shape's own test
/// hits.
template <class D>
struct TreeRay {
    hn::Vec<D> inverse[3];
    hn::Vec<D> near_origin[3], far_origin[3];  // origin / direction, moved apart
    hn::Vec<D> t_min;
    hn::Vec<D> time;
    int near_side[3];  // which of two planes the ray crosses first

    HWY_INLINE TreeRay(D d, const Ray& ray)
        : t_min(hn::Set(d, ray.t_min)), time(hn::Set(d, ray.time)) {
        constexpr float kMarginFraction = 0x1p-18f;
        const V3f& o = ray.origin;
        const float margin = kMarginFraction * (std::abs(o.x) + std::abs(o.y) + std::abs(o.z));
        for (int axis = 0; axis < 3; ++axis) {
            const float reciprocal = scalar::finite_reciprocal<scalar::One>(ray.direction[axis]);
            const float apart = std::copysign(margin, ray.direction[axis]);
            inverse[axis] = hn::Set(d, reciprocal);
            near_origin[axis] = hn::Set(d, (o[axis] + apart) * reciprocal);
            far_origin[axis] = hn::Set(d, (o[axis] - apart) * reciprocal);
            near_side[axis] = std::signbit(ray.direction[axis]) ? 1 : 0;
        }
    }
};

/// A bit for each child whose box the ray enters before `limit`, and the distances of entry.
template <bool kMoving, class D, class Nodes>
HWY_INLINE unsigned enter_children(D d, const TreeRay<D>& ray, const Nodes& tree,
                                   const WideNode& node, std::uint32_t index, float limit,
                                   float* HWY_RESTRICT enters) {
    unsigned children = 0;
    for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
        const auto plane = [&](int axis, int side) HWY_ATTR {
            hn::Vec<D> place = hn::LoadU(d, node.planes[axis][side].values + lane);
            if constexpr (kMoving) {
                const float* travel = tree.travel(index).planes[axis][side].values + lane;
                place = hn::MulAdd(ray.time, hn::LoadU(d, travel), place);
            }
            return place;
        };
        const auto near = [&](int axis) HWY_ATTR {
            return hn::MulSub(plane(axis, ray.near_side[axis]), ray.inverse[axis],
                              ray.near_origin[axis]);
        };
        const auto far = [&](int axis) HWY_ATTR {
            return hn::MulSub(plane(axis, 1 - ray.near_side[axis]), ray.inverse[axis],
                              ray.far_origin[axis]);
        };
        // In pairs: no result waits for more than two others.
        const hn::Vec<D> enter = hn::Max(hn::Max(near(0), near(1)), hn::Max(near(2), ray.t_min));
        const hn::Vec<D> leave =
            hn::Min(hn::Min(far(0), far(1)), hn::Min(far(2), hn::Set(d, limit)));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Le(enter, leave), bits);
        hn::StoreU(enter, d, enters + lane);
        children |= static_cast<unsigned>(bits[0]) << lane;
    }
    return children;
}

/// The order in which a node's children are visited.
enum class Order {
    nearest,
    any  // for any-hit queries, where sorting does not pay
};

/// Calls `visit(leaf)` for the leaves whose boxes the ray enters before `limit`, which visits may
/// lower; ends when a visit returns true. `tree`: a WideTree, or what has its functions.
template <bool kMoving, Order kOrder = Order::nearest, class D, class Nodes, class Visit>
HWY_INLINE void traverse(D d, const Nodes& tree, const Ray& ray, const float& limit,
                         const Visit& visit) {
    struct StackEntry {
        float enter;
        std::int32_t child;
    };
    StackEntry stack[7 * kWideTreeDepth + 8];
    int count = 0;
    const TreeRay<D> tree_ray(d, ray);
    alignas(32) float enters[kBlockLanes];
    // Insertion into the stack of waiting children, the farthest first; `before`: its size at the
    // node.
    const auto push = [&](const StackEntry& child, int before) HWY_ATTR {
        int at = count++;
        for (; kOrder == Order::nearest && at > before && stack[at - 1].enter < child.enter; --at) {
            stack[at] = stack[at - 1];
        }
        stack[at] = child;
    };
    std::int32_t current = 0;
    for (;;) {
        if (current >= 0) {
            const auto index = static_cast<std::uint32_t>(current);
            const WideNode& node = tree.node(index);
            unsigned children =
                enter_children<kMoving>(d, tree_ray, tree, node, index, limit, enters);
            if (children != 0) {
                const std::int32_t* below = node.children;
                const int lane = std::countr_zero(children);
                StackEntry first{enters[lane], below[lane]};
                const int before = count;
                for (children &= children - 1; children != 0; children &= children - 1) {
                    const int next = std::countr_zero(children);
                    StackEntry other{enters[next], below[next]};
                    if (kOrder == Order::nearest && other.enter < first.enter) {
                        std::swap(first, other);
                    }
                    push(other, before);
                }
                current = first.child;
                continue;
            }
        } else if (visit(static_cast<std::uint32_t>(-1 - current))) {
            return;
        }
        do {
            if (count == 0) {
                return;
            }
            --count;
        } while (stack[count].enter > limit);
        current = stack[count].child;
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
