// Traversal of a wide tree by a packet of rays, one in each vector lane; included once per
// instruction set.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "render/acceleration/wide_tree.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int kPacketLanes = 16;  // at most
inline constexpr float kLargest = std::numeric_limits<float>::max();

using PacketTag = hn::CappedTag<float, kPacketLanes>;
using ChildTag = hn::CappedTag<float, kBlockLanes>;  // a child's box in each lane

/// The rays of a packet. Boxes are widened by a fraction of the origin's coordinates, as in
/// wide_traversal-inl.h: `low_origin` is for their lower planes, `high_origin` for the upper ones.
/// Products and differences are not fused, so that every instruction set gives the same distances.
struct alignas(64) PacketRays {
    float origin[3][kPacketLanes];
    float direction[3][kPacketLanes];
    float low_origin[3][kPacketLanes];
    float high_origin[3][kPacketLanes];
    float inverse[3][kPacketLanes];
    float limit[kPacketLanes];  // the search ends here; -1 for lanes without a ray
    float t_min;                // the same for all

    HWY_INLINE void prepare() {
        const PacketTag d;
        for (int lane = 0; lane < kPacketLanes; lane += static_cast<int>(hn::Lanes(d))) {
            hn::Vec<PacketTag> at[3];
            for (int axis = 0; axis < 3; ++axis) {
                at[axis] = hn::Load(d, origin[axis] + lane);
            }
            const auto margin = margin_of(at);
            for (int axis = 0; axis < 3; ++axis) {
                hn::Store(hn::Add(at[axis], margin), d, low_origin[axis] + lane);
                hn::Store(hn::Sub(at[axis], margin), d, high_origin[axis] + lane);
                hn::Store(finite_inverse(hn::Load(d, direction[axis] + lane)), d,
                          inverse[axis] + lane);
            }
        }
    }

    static HWY_INLINE hn::Vec<PacketTag> margin_of(const hn::Vec<PacketTag> (&at)[3]) {
        const auto sum = hn::Add(hn::Add(hn::Abs(at[0]), hn::Abs(at[1])), hn::Abs(at[2]));
        return hn::Mul(sum, hn::Set(PacketTag(), 0x1p-18f));
    }
    static HWY_INLINE hn::Vec<PacketTag> finite_inverse(hn::Vec<PacketTag> toward) {
        const PacketTag d;
        const auto size = hn::Max(hn::Abs(toward), hn::Set(d, 1e-30f));
        return hn::Div(hn::Set(d, 1.f), hn::CopySign(size, toward));
    }
};

/// Where rays enter and leave a box.
struct Passage {
    hn::Vec<PacketTag> enter, leave;
};

/// `low` and `high`: PacketRays::low_origin and high_origin. Not cut at the rays' ends.
HWY_INLINE Passage passage(const float (&low_planes)[3], const float (&high_planes)[3],
                           const hn::Vec<PacketTag> (&low)[3], const hn::Vec<PacketTag> (&high)[3],
                           const hn::Vec<PacketTag> (&inverse)[3]) {
    const PacketTag d;
    hn::Vec<PacketTag> near[3];
    hn::Vec<PacketTag> far[3];
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = hn::Mul(hn::Sub(hn::Set(d, low_planes[axis]), low[axis]), inverse[axis]);
        const auto b = hn::Mul(hn::Sub(hn::Set(d, high_planes[axis]), high[axis]), inverse[axis]);
        near[axis] = hn::Min(a, b);
        far[axis] = hn::Max(a, b);
    }
    return {hn::Max(hn::Max(near[0], near[1]), near[2]), hn::Min(hn::Min(far[0], far[1]), far[2])};
}

/// Children that wait to be visited, and where each ray of a packet enters them: infinity for those
/// that miss.
struct alignas(64) WaitingPacket {
    float enter[kPacketLanes];
    std::int32_t child;
};

struct WaitingChild {
    float enter;
    std::int32_t child;
};

/// The largest number of rays that go on alone.
inline constexpr int kFewRays = 3;
inline constexpr int kFewInLeaf = 6;

/// In which order the children of a node are visited.
enum class Order { nearest_first, any };

/// Visits the part of a tree below `start` with one ray of a packet. `visit(leaf, enter)` returns
/// true to end.
template <Order kOrder, class Visit>
HWY_INLINE void traverse_alone(const WideTree& tree, const PacketRays& rays, int ray,
                               WaitingChild start, const Visit& visit) {
    const ChildTag d;
    using F = hn::Vec<ChildTag>;
    WaitingChild stack[7 * kWideTreeDepth + 8];
    int count = 0;
    F origin[3][2];
    F inverse[3];
    int near_side[3];
    for (int axis = 0; axis < 3; ++axis) {
        origin[axis][0] = hn::Set(d, rays.low_origin[axis][ray]);
        origin[axis][1] = hn::Set(d, rays.high_origin[axis][ray]);
        inverse[axis] = hn::Set(d, rays.inverse[axis][ray]);
        near_side[axis] = rays.inverse[axis][ray] < 0 ? 1 : 0;
        if (near_side[axis] != 0) {
            std::swap(origin[axis][0], origin[axis][1]);
        }
    }
    alignas(32) float enters[kBlockLanes];
    const float& limit = rays.limit[ray];
    const F t_min = hn::Set(d, rays.t_min);
    WaitingChild current = start;
    for (;;) {
        if (current.child >= 0) {
            const WideNode& node = tree.nodes[static_cast<std::uint32_t>(current.child)];
            unsigned children = 0;
            for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
                const auto at = [&](int axis, int side) HWY_ATTR {
                    const F plane =
                        hn::Load(d, node.planes[axis][near_side[axis] ^ side].values + lane);
                    return hn::Mul(hn::Sub(plane, origin[axis][side]), inverse[axis]);
                };
                const F enter = hn::Max(hn::Max(at(0, 0), at(1, 0)), hn::Max(at(2, 0), t_min));
                const F leave =
                    hn::Min(hn::Min(at(0, 1), at(1, 1)), hn::Min(at(2, 1), hn::Set(d, limit)));
                std::uint8_t bits[8] = {};
                hn::StoreMaskBits(d, hn::Le(enter, leave), bits);
                hn::Store(enter, d, enters + lane);
                children |= static_cast<unsigned>(bits[0]) << lane;
            }
            if constexpr (kOrder == Order::any) {
                for (; children != 0; children &= children - 1) {
                    const int lane = std::countr_zero(children);
                    stack[count++] = {enters[lane], node.children[lane]};
                }
            }
            if (children != 0) {
                int lane = std::countr_zero(children);
                WaitingChild first{enters[lane], node.children[lane]};
                const int before = count;
                for (children &= children - 1; children != 0; children &= children - 1) {
                    lane = std::countr_zero(children);
                    WaitingChild other{enters[lane], node.children[lane]};
                    if (other.enter < first.enter) {
                        std::swap(first, other);
                    }
                    int place = count++;
                    for (; place > before && stack[place - 1].enter < other.enter; --place) {
                        stack[place] = stack[place - 1];
                    }
                    stack[place] = other;
                }
                current = first;
                continue;
            }
        } else if (visit(static_cast<std::uint32_t>(-1 - current.child), current.enter)) {
            return;
        }
        do {
            if (count == 0) {
                return;
            }
            --count;
        } while (stack[count].enter > limit);
        current = stack[count];
    }
}

/// Visits a tree with a packet. `leaf_of_many(leaf, enter)` and `leaf_of_one(leaf, ray, enter)`
/// test the triangles of a leaf and lower limits.
template <Order kOrder, class LeafOfMany, class LeafOfOne>
HWY_INLINE void traverse_packet(const WideTree& tree, const PacketRays& rays,
                                const LeafOfMany& leaf_of_many, const LeafOfOne& leaf_of_one) {
    const PacketTag d;
    using F = hn::Vec<PacketTag>;
    constexpr int kMost = 7 * kWideTreeDepth + 9;
    WaitingPacket stack[kMost];
    int count = 0;
    const auto limit_now = [&]() HWY_ATTR { return hn::Load(d, rays.limit); };
    const F t_min = hn::Set(d, rays.t_min);
    hn::Store(t_min, d, stack[0].enter);
    stack[0].child = 0;
    count = 1;
    WaitingPacket found[kBlockLanes];
    struct Place {
        float nearest;
        int at;
    };
    Place order[kBlockLanes];
    while (count > 0) {
        const WaitingPacket& top = stack[--count];
        const F entered = hn::Load(d, top.enter);
        const F limit = limit_now();
        const auto active = hn::Le(entered, limit);
        const auto many = static_cast<int>(hn::CountTrue(d, active));
        const std::int32_t current = top.child;
        if (many <= (current < 0 ? kFewInLeaf : kFewRays)) {
            if (many == 0) {
                continue;
            }
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, active, bits);
            for (unsigned left = bits[0] | static_cast<unsigned>(bits[1]) << 8u; left != 0;
                 left &= left - 1) {
                const int ray = std::countr_zero(left);
                traverse_alone<kOrder>(tree, rays, ray, {stack[count].enter[ray], current},
                                       [&](std::uint32_t leaf, float enter)
                                           HWY_ATTR { return leaf_of_one(leaf, ray, enter); });
            }
            continue;
        }
        if (current < 0) {
            leaf_of_many(static_cast<std::uint32_t>(-1 - current),
                         hn::IfThenElse(active, entered, hn::Set(d, kInfinity)));
            continue;
        }
        const WideNode& node = tree.nodes[static_cast<std::uint32_t>(current)];
        F inverse[3];
        F low[3];
        F high[3];
        for (int axis = 0; axis < 3; ++axis) {
            inverse[axis] = hn::Load(d, rays.inverse[axis]);
            low[axis] = hn::Load(d, rays.low_origin[axis]);
            high[axis] = hn::Load(d, rays.high_origin[axis]);
        }
        int children = 0;
        for (int lane = 0; lane < kBlockLanes && node.children[lane] != 0; ++lane) {
            const float low_planes[3] = {node.planes[0][0].values[lane],
                                         node.planes[1][0].values[lane],
                                         node.planes[2][0].values[lane]};
            const float high_planes[3] = {node.planes[0][1].values[lane],
                                          node.planes[1][1].values[lane],
                                          node.planes[2][1].values[lane]};
            const Passage way = passage(low_planes, high_planes, low, high, inverse);
            const F enter = hn::Max(way.enter, t_min);
            const auto inside = hn::And(hn::Le(enter, hn::Min(way.leave, limit)), active);
            if (hn::AllFalse(d, inside)) {
                continue;
            }
            const F kept = hn::IfThenElse(inside, enter, hn::Set(d, kInfinity));
            if constexpr (kOrder == Order::any) {
                hn::Store(kept, d, stack[count].enter);
                stack[count].child = node.children[lane];
                ++count;
                continue;
            }
            hn::Store(kept, d, found[children].enter);
            found[children].child = node.children[lane];
            const float nearest = hn::GetLane(hn::MinOfLanes(d, kept));
            int place = children;
            for (; place > 0 && order[place - 1].nearest < nearest; --place) {
                order[place] = order[place - 1];
            }
            order[place] = {nearest, children};
            ++children;
        }
        for (int i = 0; i < children; ++i) {
            const WaitingPacket& next = found[order[i].at];
            hn::Store(hn::Load(d, next.enter), d, stack[count].enter);
            stack[count].child = next.child;
            ++count;
        }
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
