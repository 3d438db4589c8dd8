#include "render/acceleration/triangle_batch_kernels.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/acceleration/triangle_batch_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/acceleration/packet_traversal-inl.h"
#include "render/triangle/moller_trumbore-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace kernels = triangle::HWY_NAMESPACE;

template <class D>
HWY_INLINE kernels::Triple<hn::Vec<D>> broadcast(D d, const V3f& v) {
    return {{hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)}};
}

/// The triangles of a leaf, from `lane` on, for one ray.
template <class D>
HWY_INLINE kernels::Triple<hn::Vec<D>> triangles(D d, const Lanes (&lanes)[3], int lane) {
    return {{hn::Load(d, lanes[0].values + lane), hn::Load(d, lanes[1].values + lane),
             hn::Load(d, lanes[2].values + lane)}};
}

/// One triangle of a leaf for all rays.
template <class D>
HWY_INLINE kernels::Triple<hn::Vec<D>> triangle_in_all(D d, const Lanes (&lanes)[3], int lane) {
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

struct alignas(64) PacketHits {
    std::int32_t object[kPacketLanes];
    std::int32_t primitive[kPacketLanes];
    float u[kPacketLanes], v[kPacketLanes];
};

/// Nearest hits of a packet; distances are the rays' limits.
struct ClosestOfPacket {
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
    const TriangleTree& tree;
    PacketRays& rays;

    HWY_INLINE void of_many(std::uint32_t leaf, hn::Vec<PacketTag> enter) const {
        const PacketTag d;
        const TriangleBlock& block = tree.blocks[leaf];
        const auto origin = load_packet(rays.origin);
        const auto direction = load_packet(rays.direction);
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
    traverse_packet(
        query.tree.tree, query.rays,
        [&](std::uint32_t leaf, hn::Vec<PacketTag> enter) HWY_ATTR { query.of_many(leaf, enter); },
        [&](std::uint32_t leaf, int ray, float enter)
            HWY_ATTR { return query.of_one(leaf, ray, enter); });
}

/// Rays with finite numbers only, as in safe_ray.h.
HWY_INLINE bool is_finite_ray(const RayBatch& rays, int i) {
    const float probe =
        0 *
        (((rays.origin[0][i] + rays.origin[1][i]) + (rays.origin[2][i] + rays.direction[0][i])) +
         ((rays.direction[1][i] + rays.direction[2][i]) + rays.time[i]));
    return probe == 0;
}

/// Loads the rays from `first` on. Returns those that are to be asked: finite ones with t > 0.
HWY_INLINE hn::Mask<PacketTag> load_rays(const RayBatch& batch, int first, hn::Vec<PacketTag> t,
                                         PacketRays& rays) {
    const PacketTag d;
    const auto zero = hn::Zero(d);
    hn::Vec<PacketTag> sum = hn::LoadU(d, batch.time + first);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto origin = hn::LoadU(d, batch.origin[axis] + first);
        const auto direction = hn::LoadU(d, batch.direction[axis] + first);
        sum = hn::Add(sum, hn::Add(origin, direction));
        hn::Store(origin, d, rays.origin[axis]);
        hn::Store(direction, d, rays.direction[axis]);
    }
    const auto finite = hn::Eq(hn::Mul(sum, zero), zero);
    const auto asked = hn::And(hn::And(finite, hn::Gt(t, zero)),
                               hn::FirstN(d, static_cast<std::size_t>(batch.count - first)));
    rays.t_min = 0;
    hn::Store(hn::IfThenElse(asked, hn::Min(t, hn::Set(d, kLargest)), hn::Set(d, -1.f)), d,
              rays.limit);
    return asked;
}

inline HWY_ATTR void closest(const TriangleTree& tree, const RayBatch& batch,
                             const HitArrays& hits) {
    if (tree.blocks.empty()) {
        return;
    }
    const PacketTag d;
    const hn::RebindToSigned<PacketTag> di;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    PacketRays rays;
    PacketHits nearest;
    for (int first = 0; first < batch.count; first += lanes) {
        const auto asked = load_rays(batch, first, hn::LoadU(d, hits.t + first), rays);
        if (hn::AllFalse(d, asked)) {
            continue;
        }
        hn::Store(hn::LoadU(di, hits.object + first), di, nearest.object);
        hn::Store(hn::LoadU(di, hits.primitive + first), di, nearest.primitive);
        hn::Store(hn::LoadU(d, hits.u + first), d, nearest.u);
        hn::Store(hn::LoadU(d, hits.v + first), d, nearest.v);
        const auto before = hn::Load(d, rays.limit);
        ask(ClosestOfPacket{tree, rays, nearest});
        // A ray without a hit keeps a t that may be infinite.
        const auto limit = hn::Load(d, rays.limit);
        const auto found = hn::Lt(limit, before);
        hn::StoreU(hn::IfThenElse(found, limit, hn::LoadU(d, hits.t + first)), d, hits.t + first);
        hn::StoreU(hn::Load(di, nearest.object), di, hits.object + first);
        hn::StoreU(hn::Load(di, nearest.primitive), di, hits.primitive + first);
        hn::StoreU(hn::Load(d, nearest.u), d, hits.u + first);
        hn::StoreU(hn::Load(d, nearest.v), d, hits.v + first);
    }
}

inline HWY_ATTR void occlude(const TriangleTree& tree, const RayBatch& batch, float* t) {
    if (tree.blocks.empty()) {
        return;
    }
    const auto lanes = static_cast<int>(hn::Lanes(PacketTag()));
    PacketRays rays;
    rays.t_min = 0;
    int index[kPacketLanes];
    int count = 0;
    const auto ask_now = [&]() HWY_ATTR {
        for (int i = count; i < lanes; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                rays.origin[axis][i] = 0;
                rays.direction[axis][i] = 0;
            }
            rays.limit[i] = -1;
        }
        ask(AnyOfPacket{tree, rays});
        for (int i = 0; i < count; ++i) {
            t[index[i]] = rays.limit[i] < 0 ? 0 : t[index[i]];
        }
        count = 0;
    };
    for (int i = 0; i < batch.count; ++i) {
        if (!(t[i] > 0) || !is_finite_ray(batch, i)) {
            continue;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            rays.origin[axis][count] = batch.origin[axis][i];
            rays.direction[axis][count] = batch.direction[axis][i];
        }
        rays.limit[count] = std::min(t[i], kLargest);
        index[count++] = i;
        if (count == lanes) {
            ask_now();
        }
    }
    if (count > 0) {
        ask_now();
    }
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
    if (tree.blocks.empty()) {
        return false;
    }
    PacketRays rays;
    PacketHits nearest;
    nearest.object[0] = -1;
    set_ray(ray, rays);
    const ClosestOfPacket query{tree, rays, nearest};
    traverse_alone(tree.tree, rays, 0, {ray.t_min, 0},
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
    if (tree.blocks.empty()) {
        return false;
    }
    PacketRays rays;
    set_ray(ray, rays);
    const AnyOfPacket query{tree, rays};
    traverse_alone(tree.tree, rays, 0, {ray.t_min, 0},
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
