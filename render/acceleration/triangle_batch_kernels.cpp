#include "render/acceleration/triangle_batch_kernels.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/acceleration/triangle_batch_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/acceleration/packet_traversal-inl.h"
#include "render/lanes/packed_lanes-inl.h"
#include "render/lanes/vector_lanes-inl.h"
#include "render/triangle/moller_trumbore-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace kernels = triangle::HWY_NAMESPACE;

#define CAROM_KERNEL HWY_INLINE
#define CAROM_KERNEL_ATTRIBUTE HWY_ATTR
#include "render/acceleration/kernels/culling.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

using PacketLanes = VectorLanes<PacketTag>;

template <class D>
HWY_INLINE kernels::Triple<hn::Vec<D>> broadcast(D d, const V3f& v) {
    return {{hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)}};
}

/// The triangles of a leaf, from `lane` on, for one ray.
template <class D>
HWY_INLINE kernels::Triple<hn::Vec<D>> triangles(D d, const FloatLanes (&lanes)[3], int lane) {
    return {{hn::Load(d, lanes[0].values + lane), hn::Load(d, lanes[1].values + lane),
             hn::Load(d, lanes[2].values + lane)}};
}

/// One triangle of a leaf for all rays.
template <class D>
HWY_INLINE kernels::Triple<hn::Vec<D>> triangle_in_all(D d, const FloatLanes (&lanes)[3],
                                                       int lane) {
    return {{hn::Set(d, lanes[0].values[lane]), hn::Set(d, lanes[1].values[lane]),
             hn::Set(d, lanes[2].values[lane])}};
}

template <class D>
HWY_INLINE kernels::HitIn<VectorLanes<D>> test(const kernels::Triple<hn::Vec<D>>& origin,
                                               const kernels::Triple<hn::Vec<D>>& direction,
                                               const kernels::Triple<hn::Vec<D>>& corner,
                                               const kernels::Triple<hn::Vec<D>>& edge_b,
                                               const kernels::Triple<hn::Vec<D>>& edge_c,
                                               float t_min) {
    using L = VectorLanes<D>;
    const D d;
    const kernels::RayIn<L> ray{origin, direction, hn::Set(d, t_min), hn::Set(d, kInfinity)};
    const kernels::MollerTrumbore::Record<L> record{corner, edge_b, edge_c};
    return kernels::MollerTrumbore::intersect<triangle::Division::early>(ray, record);
}

template <class D>
HWY_INLINE kernels::HitIn<VectorLanes<D>> test_block(const TriangleBlock& block, int lane,
                                                     const PacketRays& rays, int ray) {
    const D d;
    return test<D>(
        broadcast(d, V3f(rays.origin[0][ray], rays.origin[1][ray], rays.origin[2][ray])),
        broadcast(d, V3f(rays.direction[0][ray], rays.direction[1][ray], rays.direction[2][ray])),
        triangles(d, block.corner, lane), triangles(d, block.edge_b, lane),
        triangles(d, block.edge_c, lane), rays.t_min);
}

HWY_INLINE kernels::Triple<hn::Vec<PacketTag>> load_packet(const float (&lanes)[3][kPacketLanes]) {
    const PacketTag d;
    return {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2])}};
}

HWY_INLINE bool stays_beyond(const LeafSlab& slab, const PacketRays& rays, int ray) {
    const auto vector = [&](const float(&lanes)[3][kPacketLanes]) {
        return kernels::Triple<float>{{lanes[0][ray], lanes[1][ray], lanes[2][ray]}};
    };
    return stay_beyond<ScalarLanes<float>>(slab, vector(rays.origin), vector(rays.direction),
                                           rays.limit[ray]);
}

struct alignas(64) PacketHits {
    std::int32_t object[kPacketLanes];
    std::int32_t primitive[kPacketLanes];
    float u[kPacketLanes], v[kPacketLanes];
};

/// Nearest hits of a packet; distances are the rays' limits.
struct ClosestOfPacket {
    static constexpr Order kOrder = Order::nearest_first;
    const TriangleTree& tree;
    PacketRays& rays;
    PacketHits& hits;

    HWY_INLINE void of_many(std::uint32_t leaf, hn::Vec<PacketTag> enter) const {
        const PacketTag d;
        const hn::RebindToSigned<PacketTag> di;
        const TriangleBlock& block = tree.blocks[leaf];
        const TriangleNames& names = tree.names[leaf];
        const auto origin = load_packet(rays.origin);
        const auto direction = load_packet(rays.direction);
        const auto gone =
            stay_beyond<PacketLanes>(tree.slabs[leaf], origin, direction, hn::Load(d, rays.limit));
        enter = hn::IfThenElse(gone, hn::Set(d, kInfinity), enter);
        if (hn::AllTrue(d, hn::Eq(enter, hn::Set(d, kInfinity)))) {
            return;
        }
        for (int k = 0; k < kBlockLanes && names.object.values[k] >= 0; ++k) {
            const auto hit = test<PacketTag>(origin, direction, triangle_in_all(d, block.corner, k),
                                             triangle_in_all(d, block.edge_b, k),
                                             triangle_in_all(d, block.edge_c, k), rays.t_min);
            const auto limit = hn::Load(d, rays.limit);
            const auto t = hn::Max(hit.t, enter);
            auto take = hn::And(hit.valid, hn::Le(t, limit));
            if (hn::AllFalse(d, take)) {
                continue;
            }
            const auto object = hn::Set(di, names.object.values[k]);
            const auto number = hn::Set(di, names.number.values[k]);
            const auto old_object = hn::Load(di, hits.object);
            const auto old_number = hn::Load(di, hits.primitive);
            const auto lower =
                hn::Or(hn::Lt(object, old_object),
                       hn::And(hn::Eq(object, old_object), hn::Lt(number, old_number)));
            take = hn::And(take, hn::Or(hn::Lt(t, limit), hn::RebindMask(d, lower)));
            hn::Store(hn::IfThenElse(take, t, limit), d, rays.limit);
            const auto take_int = hn::RebindMask(di, take);
            hn::Store(hn::IfThenElse(take_int, object, old_object), di, hits.object);
            hn::Store(hn::IfThenElse(take_int, number, old_number), di, hits.primitive);
            hn::Store(hn::IfThenElse(take, hit.u, hn::Load(d, hits.u)), d, hits.u);
            hn::Store(hn::IfThenElse(take, hit.v, hn::Load(d, hits.v)), d, hits.v);
        }
    }

    HWY_INLINE bool of_one(std::uint32_t leaf, int ray, float enter) const {
        if (stays_beyond(tree.slabs[leaf], rays, ray)) {
            return false;
        }
        const ChildTag d;
        const TriangleNames& names = tree.names[leaf];
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            const auto hit = test_block<ChildTag>(tree.blocks[leaf], lane, rays, ray);
            const auto distance = hn::Max(hit.t, hn::Set(d, enter));
            const auto near = hn::And(hit.valid, hn::Le(distance, hn::Set(d, rays.limit[ray])));
            if (hn::AllFalse(d, near)) {
                continue;
            }
            alignas(32) float t[kBlockLanes];
            alignas(32) float u[kBlockLanes];
            alignas(32) float v[kBlockLanes];
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, near, bits);
            hn::Store(distance, d, t);
            hn::Store(hit.u, d, u);
            hn::Store(hit.v, d, v);
            for (unsigned left = bits[0]; left != 0; left &= left - 1) {
                const int k = std::countr_zero(left);
                offer(ray, names.object.values[lane + k], names.number.values[lane + k], t[k], u[k],
                      v[k]);
            }
        }
        return false;
    }

    HWY_INLINE void offer(int ray, std::int32_t object, std::int32_t number, float t, float u,
                          float v) const {
        const bool is_lower = object < hits.object[ray] ||
                              (object == hits.object[ray] && number < hits.primitive[ray]);
        if (t < rays.limit[ray] || (t == rays.limit[ray] && is_lower)) {
            rays.limit[ray] = t;
            hits.object[ray] = object;
            hits.primitive[ray] = number;
            hits.u[ray] = u;
            hits.v[ray] = v;
        }
    }
};

/// Occlusion of a packet: limits become -1.
struct AnyOfPacket {
    static constexpr Order kOrder = Order::any;
    const TriangleTree& tree;
    PacketRays& rays;

    HWY_INLINE void of_many(std::uint32_t leaf, hn::Vec<PacketTag> enter) const {
        const PacketTag d;
        const TriangleBlock& block = tree.blocks[leaf];
        const auto origin = load_packet(rays.origin);
        const auto direction = load_packet(rays.direction);
        const auto gone =
            stay_beyond<PacketLanes>(tree.slabs[leaf], origin, direction, hn::Load(d, rays.limit));
        enter = hn::IfThenElse(gone, hn::Set(d, kInfinity), enter);
        if (hn::AllTrue(d, hn::Eq(enter, hn::Set(d, kInfinity)))) {
            return;
        }
        auto limit = hn::Load(d, rays.limit);
        for (int k = 0; k < kBlockLanes && tree.names[leaf].object.values[k] >= 0; ++k) {
            const auto hit = test<PacketTag>(origin, direction, triangle_in_all(d, block.corner, k),
                                             triangle_in_all(d, block.edge_b, k),
                                             triangle_in_all(d, block.edge_c, k), rays.t_min);
            const auto found = hn::And(hit.valid, hn::Lt(hn::Max(hit.t, enter), limit));
            limit = hn::IfThenElse(found, hn::Set(d, -1.f), limit);
        }
        hn::Store(limit, d, rays.limit);
    }

    HWY_INLINE bool of_one(std::uint32_t leaf, int ray, float enter) const {
        if (stays_beyond(tree.slabs[leaf], rays, ray)) {
            return false;
        }
        const ChildTag d;
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            const auto hit = test_block<ChildTag>(tree.blocks[leaf], lane, rays, ray);
            const auto distance = hn::Max(hit.t, hn::Set(d, enter));
            if (!hn::AllFalse(d,
                              hn::And(hit.valid, hn::Lt(distance, hn::Set(d, rays.limit[ray]))))) {
                rays.limit[ray] = -1;
                return true;
            }
        }
        return false;
    }
};

template <class Query>
HWY_INLINE void ask(const Query& query) {
    query.rays.prepare();
    traverse_packet<Query::kOrder>(
        query.tree.tree, query.rays,
        [&](std::uint32_t leaf, hn::Vec<PacketTag> enter) HWY_ATTR { query.of_many(leaf, enter); },
        [&](std::uint32_t leaf, int ray, float enter)
            HWY_ATTR { return query.of_one(leaf, ray, enter); });
}

/// Tests rays with boxes, widened as in a traversal.
class BoxTest {
  public:
    HWY_INLINE BoxTest(const kernels::Triple<hn::Vec<PacketTag>>& origin,
                       const kernels::Triple<hn::Vec<PacketTag>>& direction) {
        const auto margin = PacketRays::margin_of(origin.at);
        for (int axis = 0; axis < 3; ++axis) {
            low_[axis] = hn::Add(origin.at[axis], margin);
            high_[axis] = hn::Sub(origin.at[axis], margin);
            inverse_[axis] = PacketRays::finite_inverse(direction.at[axis]);
        }
    }
    [[nodiscard]] HWY_INLINE hn::Mask<PacketTag> meets(const float (&low_planes)[3],
                                                       const float (&high_planes)[3],
                                                       hn::Vec<PacketTag> limit) const {
        const Passage way = passage(low_planes, high_planes, low_, high_, inverse_);
        return hn::Le(hn::Max(way.enter, hn::Zero(PacketTag())), hn::Min(way.leave, limit));
    }
    [[nodiscard]] HWY_INLINE hn::Mask<PacketTag> meets(const Imath::Box3f& box,
                                                       hn::Vec<PacketTag> limit) const {
        return meets({box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}, limit);
    }

  private:
    hn::Vec<PacketTag> low_[3], high_[3], inverse_[3];
};

/// Rays of a batch that wait to be asked, without gaps.
class WaitingRays {
  public:
    /// Adds the rays from `first` on that may meet the tree before `t`: finite ones (safe_ray.h)
    /// that pass through its box and not above its horizon, and meet a leaf if there are few.
    HWY_INLINE void add(const TriangleTree& tree, const RayBatch& batch, int first,
                        hn::Vec<PacketTag> t) {
        const PacketTag d;
        const auto zero = hn::Zero(d);
        hn::Vec<PacketTag> sum = hn::LoadU(d, batch.time + first);
        kernels::Triple<hn::Vec<PacketTag>> origin;
        kernels::Triple<hn::Vec<PacketTag>> direction;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            origin.at[axis] = hn::LoadU(d, batch.origin[axis] + first);
            direction.at[axis] = hn::LoadU(d, batch.direction[axis] + first);
            sum = hn::Add(sum, hn::Add(origin.at[axis], direction.at[axis]));
        }
        const auto is_finite = hn::Eq(hn::Mul(sum, zero), zero);
        const auto is_asked = hn::And(hn::And(is_finite, hn::Gt(t, zero)),
                                      hn::FirstN(d, static_cast<std::size_t>(batch.count - first)));
        const auto limit = hn::Min(t, hn::Set(d, kLargest));
        const BoxTest boxes(origin, direction);
        auto may_hit = hn::And(is_asked, boxes.meets(tree.bounds, limit));
        if (tree.horizon.width > 0) {
            may_hit = hn::AndNot(pass_above<PacketLanes>(tree.horizon, origin, direction), may_hit);
        }
        if (tree.tree.nodes.size() == 1 && !hn::AllFalse(d, may_hit)) {
            may_hit = hn::And(meet_leaves(tree, boxes, origin, direction, limit), may_hit);
        }
        const PackedLanes goes(may_hit);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            hn::StoreU(goes.pack(origin.at[axis]), d, origin_[axis] + count_);
            hn::StoreU(goes.pack(direction.at[axis]), d, direction_[axis] + count_);
        }
        hn::StoreU(goes.pack(limit), d, limit_ + count_);
        const hn::RebindToSigned<PacketTag> di;
        hn::StoreU(goes.pack(hn::Iota(di, first)), di, index_ + count_);
        count_ += goes.count();
    }

    [[nodiscard]] HWY_INLINE int count() const { return count_; }

    /// Moves the first rays to a packet, and their places in the batch to `index`. Returns how
    /// many.
    HWY_INLINE int take(PacketRays& rays, std::int32_t (&index)[kPacketLanes]) {
        const PacketTag d;
        const hn::RebindToSigned<PacketTag> di;
        const int taken = std::min(count_, kLanes);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            hn::Store(hn::Load(d, origin_[axis]), d, rays.origin[axis]);
            hn::Store(hn::Load(d, direction_[axis]), d, rays.direction[axis]);
            hn::Store(hn::Load(d, origin_[axis] + kLanes), d, origin_[axis]);
            hn::Store(hn::Load(d, direction_[axis] + kLanes), d, direction_[axis]);
        }
        hn::Store(hn::IfThenElse(hn::FirstN(d, static_cast<std::size_t>(taken)),
                                 hn::Load(d, limit_), hn::Set(d, -1.f)),
                  d, rays.limit);
        hn::Store(hn::Load(d, limit_ + kLanes), d, limit_);
        hn::Store(hn::Load(di, index_), di, index);
        hn::Store(hn::Load(di, index_ + kLanes), di, index_);
        rays.t_min = 0;
        count_ -= taken;
        return taken;
    }

  private:
    static constexpr int kLanes = static_cast<int>(HWY_LANES(float)) < kPacketLanes
                                      ? static_cast<int>(HWY_LANES(float))
                                      : kPacketLanes;

    /// Whether rays may hit a leaf of a tree of one node. Most rays towards a lamp miss those of
    /// the shade around it.
    static HWY_INLINE hn::Mask<PacketTag> meet_leaves(
        const TriangleTree& tree, const BoxTest& boxes,
        const kernels::Triple<hn::Vec<PacketTag>>& origin,
        const kernels::Triple<hn::Vec<PacketTag>>& direction, hn::Vec<PacketTag> limit) {
        const WideNode& node = tree.tree.nodes[0];
        const auto planes = [&](int side, int lane, float(&three)[3]) HWY_ATTR {
            for (int axis = 0; axis < 3; ++axis) {
                three[axis] = node.planes[axis][side].values[lane];
            }
        };
        auto meets = hn::MaskFromVec(hn::Zero(PacketTag()));
        for (int lane = 0; lane < kBlockLanes && node.children[lane] != 0; ++lane) {
            float low[3];
            float high[3];
            planes(0, lane, low);
            planes(1, lane, high);
            const LeafSlab& slab = tree.slabs[static_cast<std::uint32_t>(-1 - node.children[lane])];
            meets =
                hn::Or(meets, hn::AndNot(stay_beyond<PacketLanes>(slab, origin, direction, limit),
                                         boxes.meets(low, high, limit)));
        }
        return meets;
    }

    alignas(64) float origin_[3][2 * kPacketLanes] = {};
    alignas(64) float direction_[3][2 * kPacketLanes] = {};
    alignas(64) float limit_[2 * kPacketLanes] = {};
    alignas(64) std::int32_t index_[2 * kPacketLanes] = {};
    int count_ = 0;
};

inline HWY_ATTR void closest(const TriangleTree& tree, const RayBatch& batch,
                             const HitArrays& hits) {
    if (tree.blocks.empty()) {
        return;
    }
    const PacketTag d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    WaitingRays waiting;
    PacketRays rays;
    PacketHits nearest;
    alignas(64) std::int32_t index[kPacketLanes];
    const auto ask_now = [&]() HWY_ATTR {
        const int count = waiting.take(rays, index);
        alignas(64) float before[kPacketLanes];
        hn::Store(hn::Load(d, rays.limit), d, before);
        for (int i = 0; i < count; ++i) {
            nearest.object[i] = hits.object[index[i]];
            nearest.primitive[i] = hits.primitive[index[i]];
        }
        ask(ClosestOfPacket{tree, rays, nearest});
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
    for (int first = 0; first < batch.count; first += lanes) {
        waiting.add(tree, batch, first, hn::LoadU(d, hits.t + first));
        if (waiting.count() >= lanes) {
            ask_now();
        }
    }
    if (waiting.count() > 0) {
        ask_now();
    }
}

inline HWY_ATTR void occlude(const TriangleTree& tree, const RayBatch& batch, float* t) {
    if (tree.blocks.empty()) {
        return;
    }
    const PacketTag d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    WaitingRays waiting;
    PacketRays rays;
    alignas(64) std::int32_t index[kPacketLanes];
    const auto ask_now = [&]() HWY_ATTR {
        const int count = waiting.take(rays, index);
        ask(AnyOfPacket{tree, rays});
        for (int i = 0; i < count; ++i) {
            t[index[i]] = rays.limit[i] < 0 ? 0 : t[index[i]];
        }
    };
    for (int first = 0; first < batch.count; first += lanes) {
        waiting.add(tree, batch, first, hn::LoadU(d, t + first));
        if (waiting.count() >= lanes) {
            ask_now();
        }
    }
    if (waiting.count() > 0) {
        ask_now();
    }
}

HWY_INLINE bool passes_above(const Horizon& map, const Ray& ray) {
    const auto triple = [](const V3f& v) { return kernels::Triple<float>{{v.x, v.y, v.z}}; };
    return map.width > 0 && ray.t_min >= 0 &&
           pass_above<ScalarLanes<float>>(map, triple(ray.origin), triple(ray.direction));
}

/// A packet of one ray.
HWY_INLINE void set_ray(const Ray& ray, PacketRays& rays) {
    for (int axis = 0; axis < 3; ++axis) {
        std::fill_n(rays.origin[axis], kPacketLanes, ray.origin[axis]);
        std::fill_n(rays.direction[axis], kPacketLanes, ray.direction[axis]);
    }
    rays.limit[0] = std::min(ray.t_max, kLargest);
    rays.t_min = ray.t_min;
    rays.prepare();
}

inline HWY_ATTR bool closest_of_ray(const TriangleTree& tree, const Ray& ray, Hit& hit) {
    if (tree.blocks.empty() || passes_above(tree.horizon, ray)) {
        return false;
    }
    PacketRays rays;
    PacketHits nearest;
    nearest.object[0] = -1;
    set_ray(ray, rays);
    const ClosestOfPacket query{tree, rays, nearest};
    traverse_alone<Order::nearest_first>(tree.tree, rays, 0, {ray.t_min, 0},
                                         [&](std::uint32_t leaf, float enter)
                                             HWY_ATTR { return query.of_one(leaf, 0, enter); });
    if (nearest.object[0] < 0) {
        return false;
    }
    hit = {rays.limit[0], static_cast<std::uint32_t>(nearest.object[0]),
           static_cast<std::uint32_t>(nearest.primitive[0]), nearest.u[0], nearest.v[0]};
    return true;
}

inline HWY_ATTR bool any_of_ray(const TriangleTree& tree, const Ray& ray) {
    if (tree.blocks.empty() || passes_above(tree.horizon, ray)) {
        return false;
    }
    PacketRays rays;
    set_ray(ray, rays);
    const AnyOfPacket query{tree, rays};
    traverse_alone<Order::any>(tree.tree, rays, 0, {ray.t_min, 0},
                               [&](std::uint32_t leaf, float enter)
                                   HWY_ATTR { return query.of_one(leaf, 0, enter); });
    return rays.limit[0] < 0;
}

inline const TriangleBatchKernels& triangle_batch_kernels_of_target() {
    static constexpr TriangleBatchKernels kKernels = {closest, occlude, closest_of_ray, any_of_ray};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(triangle_batch_kernels_of_target);

const TriangleBatchKernels& best_triangle_batch_kernels() {
    return HWY_DYNAMIC_DISPATCH(triangle_batch_kernels_of_target)();
}

}  // namespace carom::render

#endif
