#include "render/acceleration/triangle_batch_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/acceleration/triangle_batch_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/acceleration/instance_queries-inl.h"
#include "render/lanes/packed_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// Rays of a batch, one in each lane, before they are asked.
struct CandidateRays {
    using L = PacketLanes;
    RayOf<L> line;
    L::Value limit;
    BoxLines<L> lines;

    [[nodiscard]] HWY_INLINE L::Mask meet(const PassageOf<L>& way) const {
        return L::is_at_most(L::larger(way.enter, L::all(0)), L::smaller(way.leave, limit));
    }
    [[nodiscard]] HWY_INLINE L::Mask meet(const Imath::Box3f& box) const {
        return meet(passage<L>(
            {{box.min.x, box.max.x}, {box.min.y, box.max.y}, {box.min.z, box.max.z}}, lines));
    }

    /// Whether they may hit a leaf, if the tree has one node. Most rays towards a lamp miss those
    /// of the shade around it.
    [[nodiscard]] HWY_INLINE L::Mask meet_leaves(const TriangleTree& tree) const {
        const WideNode& node = tree.tree.nodes[0];
        auto meets = L::first_lanes(0);
        for (int lane = 0; lane < kBlockLanes && node.children[lane] != 0; ++lane) {
            const LeafSlab& slab = tree.slabs[static_cast<std::uint32_t>(-1 - node.children[lane])];
            const auto gone = stay_beyond<L>(slab, line.origin, line.direction, limit);
            meets = L::either(meets, L::without(meet(passage(node, lane, lines)), gone));
        }
        return meets;
    }

    /// Those of some rays that may hit a tree whose box they meet: that do not pass above its
    /// horizon, and meet a leaf if there are few.
    [[nodiscard]] HWY_INLINE L::Mask may_hit(const TriangleTree& tree, L::Mask some) const {
        if (tree.horizon.width > 0) {
            some =
                L::without(some, pass_above<L>(tree.horizon.tables(), line.origin, line.direction));
        }
        const bool has_few_leaves = tree.tree.nodes.size() == 1;
        return has_few_leaves && !L::none(some) ? L::both(meet_leaves(tree), some) : some;
    }
    [[nodiscard]] HWY_INLINE L::Mask may_hit(const InstanceTree& /*tree*/, L::Mask some) const {
        return some;
    }
};

/// Rays of a batch that wait to be asked, without gaps.
class WaitingRays {
  public:
    /// Adds the rays from `first` on that may meet the tree before `t`: finite ones (safe_ray.h)
    /// that pass through its box.
    template <class Tree>
    HWY_INLINE void add(const Tree& tree, const RayBatch& batch, int first, PacketLanes::Value t) {
        using L = PacketLanes;
        CandidateRays rays;
        Vec3<L::Value>& origin = rays.line.origin;
        Vec3<L::Value>& direction = rays.line.direction;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            origin[axis] = L::load(batch.origin[axis] + first);
            direction[axis] = L::load(batch.direction[axis] + first);
        }
        rays.limit = L::smaller(t, L::all(L::kLargest));
        rays.lines =
            box_lines<L>({origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z});
        const auto has_way =
            L::both(is_finite<L>(rays.line, L::load(batch.time + first)), L::is_less(L::all(0), t));
        auto may_hit =
            L::both(L::both(has_way, L::first_lanes(batch.count - first)), rays.meet(tree.bounds));
        if (L::none(may_hit)) {
            return;
        }
        may_hit = rays.may_hit(tree, may_hit);
        if (L::none(may_hit)) {
            return;
        }
        const PackedLanes goes(may_hit);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            L::store(goes.pack(origin[axis]), origin_[axis] + count_);
            L::store(goes.pack(direction[axis]), direction_[axis] + count_);
        }
        L::store(goes.pack(rays.limit), limit_ + count_);
        L::store_int(goes.pack(L::from(first)), index_ + count_);
        count_ += goes.count();
    }

    [[nodiscard]] HWY_INLINE int count() const { return count_; }

    /// Moves the first rays to a packet, and their places in the batch to `index`. Returns how
    /// many.
    HWY_INLINE int take(PacketRays& rays, std::int32_t (&index)[kPacketLanes]) {
        const PacketTag d;
        const hn::RebindToSigned<PacketTag> di;
        const int taken = std::min(count_, kPacketLanes);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            hn::Store(hn::Load(d, origin_[axis]), d, rays.origin[axis]);
            hn::Store(hn::Load(d, direction_[axis]), d, rays.direction[axis]);
            hn::Store(hn::Load(d, origin_[axis] + kPacketLanes), d, origin_[axis]);
            hn::Store(hn::Load(d, direction_[axis] + kPacketLanes), d, direction_[axis]);
        }
        using L = PacketLanes;
        hn::Store(L::select(L::first_lanes(taken), hn::Load(d, limit_), L::all(-1)), d, rays.limit);
        hn::Store(hn::Load(d, limit_ + kPacketLanes), d, limit_);
        hn::Store(hn::Load(di, index_), di, index);
        hn::Store(hn::Load(di, index_ + kPacketLanes), di, index_);
        hn::Store(L::all(0), d, rays.start);
        rays.prepare();
        count_ -= taken;
        return taken;
    }

  private:
    alignas(64) float origin_[3][2 * kPacketLanes] = {};
    alignas(64) float direction_[3][2 * kPacketLanes] = {};
    alignas(64) float limit_[2 * kPacketLanes] = {};
    alignas(64) std::int32_t index_[2 * kPacketLanes] = {};
    int count_ = 0;
};

/// Calls `ask(rays, index, count)` with packets of the rays of a batch that may meet the tree
/// before `t`.
template <class Tree, class Ask>
HWY_INLINE void for_packets(const Tree& tree, const RayBatch& batch, const float* t,
                            const Ask& ask) {
    if (tree.tree.nodes.empty()) {
        return;
    }
    WaitingRays waiting;
    PacketRays rays;
    alignas(64) std::int32_t index[kPacketLanes];
    const auto ask_some = [&]() HWY_ATTR {
        const int count = waiting.take(rays, index);
        if constexpr (std::is_same_v<Tree, InstanceTree>) {
            const PacketTag d;
            const auto time = PacketLanes::gather(batch.time, PacketLanes::load_int(index));
            hn::Store(time, d, rays.time);
        }
        ask(rays, index, count);
    };
    for (int first = 0; first < batch.count; first += kPacketLanes) {
        waiting.add(tree, batch, first, PacketLanes::load(t + first));
        if (waiting.count() >= kPacketLanes) {
            ask_some();
        }
    }
    if (waiting.count() > 0) {
        ask_some();
    }
}

HWY_INLINE ClosestOfPacket closest_query(const TriangleTree& tree, PacketRays& rays,
                                         PacketHits& hits) {
    return {{{tree}, rays}, hits};
}
HWY_INLINE ClosestInstanceOfPacket closest_query(const InstanceTree& tree, PacketRays& rays,
                                                 PacketHits& hits) {
    return {{tree, rays}, hits};
}
HWY_INLINE ClosestOfRay closest_query(const TriangleTree& tree, const Ray& ray,
                                      const NearestOfRay& nearest) {
    return {{tree}, SingleLine(ray), nearest};
}
HWY_INLINE ClosestInstanceOfRay closest_query(const InstanceTree& tree, const Ray& ray,
                                              const NearestOfRay& nearest) {
    return {tree, ray, nearest};
}
HWY_INLINE AnyOfPacket any_query(const TriangleTree& tree, PacketRays& rays) {
    return {{{tree}, rays}};
}
HWY_INLINE AnyInstanceOfPacket any_query(const InstanceTree& tree, PacketRays& rays) {
    return {{tree, rays}};
}
HWY_INLINE AnyOfRay any_query(const TriangleTree& tree, const Ray& ray, float& limit) {
    return {tree, SingleLine(ray), limit};
}
HWY_INLINE AnyInstanceOfRay any_query(const InstanceTree& tree, const Ray& ray, float& limit) {
    return {tree, ray, limit};
}

template <class Tree>
HWY_ATTR void closest(const Tree& tree, const RayBatch& batch, const HitArrays& hits) {
    PacketHits nearest;
    const auto ask = [&](PacketRays& rays, const std::int32_t* index, int count) HWY_ATTR {
        const PacketTag d;
        alignas(64) float before[kPacketLanes];
        hn::Store(hn::Load(d, rays.limit), d, before);
        for (int i = 0; i < count; ++i) {
            nearest.object[i] = hits.object[index[i]];
            nearest.primitive[i] = hits.primitive[index[i]];
        }
        traverse<Order::nearest_first>(tree.tree, rays, rays.root(),
                                       closest_query(tree, rays, nearest));
        for (int i = 0; i < count; ++i) {
            const int at = index[i];
            const bool is_nearer = rays.limit[i] < before[i];
            if (is_nearer || nearest.object[i] != hits.object[at]) {
                // A ray without a hit keeps a t that may be infinite.
                hits.t[at] = is_nearer ? rays.limit[i] : hits.t[at];
                hits.object[at] = nearest.object[i];
                hits.primitive[at] = nearest.primitive[i];
                hits.u[at] = nearest.u[i];
                hits.v[at] = nearest.v[i];
            }
        }
    };
    for_packets(tree, batch, hits.t, ask);
}

template <class Tree>
HWY_ATTR void occlude(const Tree& tree, const RayBatch& batch, float* t) {
    const auto ask = [&](PacketRays& rays, const std::int32_t* index, int count) HWY_ATTR {
        traverse<Order::any>(tree.tree, rays, rays.root(), any_query(tree, rays));
        for (int i = 0; i < count; ++i) {
            t[index[i]] = rays.limit[i] < 0 ? 0 : t[index[i]];
        }
    };
    for_packets(tree, batch, t, ask);
}

HWY_INLINE bool may_hit(const TriangleTree& tree, const Ray& ray) {
    using L = ScalarLanes<float>;
    const HorizonTables map = tree.horizon.tables();
    const bool is_above = map.width > 0 && ray.t_min >= 0 &&
                          pass_above<L>(map, all_of<L>(ray.origin), all_of<L>(ray.direction));
    return !tree.blocks.empty() && !is_above;
}
HWY_INLINE bool may_hit(const InstanceTree& tree, const Ray& /*ray*/) {
    return !tree.instances.empty();
}

template <class Tree>
HWY_ATTR bool closest_of_ray(const Tree& tree, const Ray& ray, Hit& hit) {
    if (!may_hit(tree, ray)) {
        return false;
    }
    float limit = std::min(ray.t_max, PacketLanes::kLargest);
    std::int32_t object = -1;
    std::int32_t primitive = 0;
    float u = 0;
    float v = 0;
    traverse<Order::nearest_first>(tree.tree, SingleRay(ray, limit), {ray.t_min, 0},
                                   closest_query(tree, ray, {limit, object, primitive, u, v}));
    if (object < 0) {
        return false;
    }
    hit = {limit, static_cast<std::uint32_t>(object), static_cast<std::uint32_t>(primitive), u, v};
    return true;
}

template <class Tree>
HWY_ATTR bool any_of_ray(const Tree& tree, const Ray& ray) {
    if (!may_hit(tree, ray)) {
        return false;
    }
    float limit = std::min(ray.t_max, PacketLanes::kLargest);
    traverse<Order::any>(tree.tree, SingleRay(ray, limit), {ray.t_min, 0},
                         any_query(tree, ray, limit));
    return limit < 0;
}

template <class Tree>
inline constexpr TreeBatchKernels<Tree> kKernelsOfTarget = {closest<Tree>, occlude<Tree>,
                                                            closest_of_ray<Tree>, any_of_ray<Tree>};

inline const TriangleBatchKernels& triangle_batch_kernels_of_target() {
    return kKernelsOfTarget<TriangleTree>;
}
inline const InstanceBatchKernels& instance_batch_kernels_of_target() {
    return kKernelsOfTarget<InstanceTree>;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(triangle_batch_kernels_of_target);
HWY_EXPORT(instance_batch_kernels_of_target);

const TriangleBatchKernels& best_triangle_batch_kernels() {
    return HWY_DYNAMIC_DISPATCH(triangle_batch_kernels_of_target)();
}
const InstanceBatchKernels& best_instance_batch_kernels() {
    return HWY_DYNAMIC_DISPATCH(instance_batch_kernels_of_target)();
}

}  // namespace carom::render

#endif
