// The tests of triangles in the leaves of a tree. Included once per instruction set.
#if defined(CAROM_TRIANGLE_QUERIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_TRIANGLE_QUERIES_INL_H
#undef CAROM_TRIANGLE_QUERIES_INL_H
#else
#define CAROM_TRIANGLE_QUERIES_INL_H
#endif

#include <algorithm>
#include <optional>

#include "render/acceleration/tree_traversal-inl.h"
#include "render/acceleration/triangle_tree.h"
#include "render/triangle/moller_trumbore-inl.h"
#include "render/triangle/moller_trumbore.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// Hits of which some lanes are in doubt, as `exact(lane)` has them there. Not inlined, because it
/// is rare.
template <class L, class Exact>
HWY_NOINLINE HWY_ATTR kernels::HitIn<L> without_doubt(ValueOf<L> t, ValueOf<L> u, ValueOf<L> v,
                                                      MaskOf<L> valid, MaskOf<L> is_doubtful,
                                                      const Exact& exact) {
    alignas(64) float doubts[16], ts[16], us[16], vs[16], is_hit[16];
    L::store(L::select(is_doubtful, L::all(1), L::all(0)), doubts);
    L::store(t, ts);
    L::store(u, us);
    L::store(v, vs);
    L::store(L::select(valid, L::all(1), L::all(0)), is_hit);
    for (int lane = 0; lane < L::count(); ++lane) {
        if (doubts[lane] == 0) {
            continue;
        }
        if (const std::optional<TriangleHit> found = exact(lane)) {
            ts[lane] = found->t;
            us[lane] = found->u;
            vs[lane] = found->v;
            is_hit[lane] = 1;
        }
    }
    return {L::load(ts), L::load(us), L::load(vs), L::is_less(L::all(0), L::load(is_hit))};
}

/// Tests rays with triangles, one of both in each lane, so that no ray passes between triangles
/// with a common edge. `exact(lane)` answers as triangle_hit() where that is in doubt.
template <class L, class Exact>
HWY_INLINE kernels::HitIn<L> test(const RayOf<L>& ray, ValueOf<L> t_min,
                                  const kernels::MollerTrumbore::Record<L>& triangles,
                                  ValueOf<L> error, const Exact& exact) {
    auto [hit, is_doubtful] = kernels::sure_hit<L>(
        kernels::RayIn<L>{ray.origin, ray.direction, t_min, L::all(kInfinity)}, triangles, error);
    if (HWY_UNLIKELY(!L::none(is_doubtful))) {
        const kernels::HitIn<L> sure =
            without_doubt<L>(hit.t, hit.u, hit.v, hit.valid, is_doubtful, exact);
        hit.t = sure.t;
        hit.u = sure.u;
        hit.v = sure.v;
        hit.valid = sure.valid;
    }
    return hit;
}

/// The error of test() for all triangles of a leaf: at least that of triangle_hit() for each.
template <class L>
HWY_INLINE ValueOf<L> doubt_in(const LeafSlab& slab, const RaySizeOf<L>& ray) {
    constexpr float kRounding = 1.0001f;
    return kernels::doubt<L>(ray.direction, L::all(kRounding * slab.edge),
                             ray.origin + L::all(3 * slab.size));
}

/// The triangles of a leaf, from `lane` on, for one ray.
HWY_INLINE kernels::HitIn<ChildLanes> test_block(const TriangleBlock& block, int lane,
                                                 const Ray& ray, float error) {
    using L = ChildLanes;
    const auto load = [&](const FloatLanes(&numbers)[3]) HWY_ATTR {
        const ChildTag d;
        return Vec3<L::Value>{hn::Load(d, numbers[0].values + lane),
                              hn::Load(d, numbers[1].values + lane),
                              hn::Load(d, numbers[2].values + lane)};
    };
    const auto triangles = kernels::MollerTrumbore::prepare<L>(
        {load(block.corners[0]), load(block.corners[1]), load(block.corners[2])});
    return test<L>({all_of<L>(ray.origin), all_of<L>(ray.direction)}, L::all(ray.t_min), triangles,
                   L::all(error), [&](int k) {
                       Ray whole = ray;
                       whole.t_max = kInfinity;
                       return triangle_hit(whole, block.corner(0, lane + k),
                                           block.corner(1, lane + k), block.corner(2, lane + k));
                   });
}

/// A ray of a search by itself.
struct SingleLine {
    Ray ray;  // t_max is not used
    RaySizeOf<ScalarLanes<float>> size;

    explicit HWY_INLINE SingleLine(const Ray& of)
        : SingleLine(of, size_of<ScalarLanes<float>>({all_of<ScalarLanes<float>>(of.origin),
                                                      all_of<ScalarLanes<float>>(of.direction)})) {}
    HWY_INLINE SingleLine(const Ray& of, const RaySizeOf<ScalarLanes<float>>& size_of_ray)
        : ray(of), size(size_of_ray) {}

    [[nodiscard]] HWY_INLINE float doubt(const LeafSlab& slab) const {
        return doubt_in<ScalarLanes<float>>(slab, size);
    }
};

/// Whether no triangle of a leaf can be hit before `limit`.
HWY_INLINE bool stays_beyond(const LeafSlab& slab, const Ray& ray, float limit) {
    using L = ScalarLanes<float>;
    return stay_beyond<L>(slab, all_of<L>(ray.origin), all_of<L>(ray.direction), limit);
}

/// The nearest hit of one ray, wherever that is kept.
struct NearestOfRay {
    float& limit;  // its distance, or where the search ends
    std::int32_t& object;
    std::int32_t& primitive;
    float& u;
    float& v;

    HWY_INLINE void offer(std::int32_t other, std::int32_t number, float t, float at_u,
                          float at_v) const {
        const bool is_lower = other < object || (other == object && number < primitive);
        if (t < limit || (t == limit && is_lower)) {
            limit = t;
            object = other;
            primitive = number;
            u = at_u;
            v = at_v;
        }
    }
};

/// A tree, and the number that its first object has among those of the scene.
struct NumberedTree {
    const TriangleTree& tree;
    std::int32_t first_object = 0;
};

/// The nearest hit of one ray.
struct ClosestOfRay {
    NumberedTree all;
    SingleLine line;
    NearestOfRay nearest;

    HWY_INLINE bool operator()(std::uint32_t leaf, const SingleRay::Entry& entry) const {
        const TriangleTree& tree = all.tree;
        if (stays_beyond(tree.slabs[leaf], line.ray, nearest.limit)) {
            return false;
        }
        using L = ChildLanes;
        const ChildTag d;
        const TriangleNames& names = tree.names[leaf];
        const float error = line.doubt(tree.slabs[leaf]);
        for (int lane = 0; lane < kBlockLanes; lane += L::count()) {
            const auto hit = test_block(tree.blocks[leaf], lane, line.ray, error);
            const auto distance = L::larger(hit.t, L::all(entry.enter));
            const auto near = L::both(hit.valid, L::is_at_most(distance, L::all(nearest.limit)));
            if (L::none(near)) {
                continue;
            }
            alignas(32) float t[kBlockLanes];
            alignas(32) float us[kBlockLanes];
            alignas(32) float vs[kBlockLanes];
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, near, bits);
            hn::Store(distance, d, t);
            hn::Store(hit.u, d, us);
            hn::Store(hit.v, d, vs);
            for (unsigned left = bits[0]; left != 0; left &= left - 1) {
                const int k = std::countr_zero(left);
                nearest.offer(names.object.values[lane + k] + all.first_object,
                              names.number.values[lane + k], t[k], us[k], vs[k]);
            }
        }
        return false;
    }
};

/// Occlusion of one ray, whose limit becomes -1.
struct AnyOfRay {
    const TriangleTree& tree;
    SingleLine line;
    float& limit;

    HWY_INLINE bool operator()(std::uint32_t leaf, const SingleRay::Entry& entry) const {
        if (stays_beyond(tree.slabs[leaf], line.ray, limit)) {
            return false;
        }
        using L = ChildLanes;
        const float error = line.doubt(tree.slabs[leaf]);
        for (int lane = 0; lane < kBlockLanes; lane += L::count()) {
            const auto hit = test_block(tree.blocks[leaf], lane, line.ray, error);
            const auto distance = L::larger(hit.t, L::all(entry.enter));
            if (!L::none(L::both(hit.valid, L::is_less(distance, L::all(limit))))) {
                limit = -1;
                return true;
            }
        }
        return false;
    }
};

[[nodiscard]] HWY_INLINE SingleLine one_of(const PacketRays& rays, int i) {
    Ray ray;
    ray.origin = V3f(rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]);
    ray.direction = V3f(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
    return {ray, {rays.origin_size[i], rays.direction_size[i]}};
}

/// The edges of a leaf's triangles from their first corners.
struct BlockEdges {
    FloatLanes b[3], c[3];  // by axis

    explicit HWY_INLINE BlockEdges(const TriangleBlock& block) {
        const ChildTag d;
        for (int axis = 0; axis < 3; ++axis) {
            const auto store = [&](const TriangleBlock& of, int k, FloatLanes& edge) HWY_ATTR {
                for (int lane = 0; lane < kBlockLanes; lane += ChildLanes::count()) {
                    const auto first = hn::Load(d, of.corners[0][axis].values + lane);
                    hn::Store(hn::Load(d, of.corners[k][axis].values + lane) - first, d,
                              edge.values + lane);
                }
            };
            store(block, 1, b[axis]);
            store(block, 2, c[axis]);
        }
    }
};

/// What both queries of packets share.
struct PacketQuery {
    NumberedTree all;
    PacketRays& rays;

    /// Calls `offer(k, hit)` for each triangle of a leaf with the hits of all rays; the distances
    /// of rays that do not meet the leaf are infinite.
    template <class Offer>
    HWY_INLINE void test_leaf(std::uint32_t leaf, const PacketRays::Entry& entry,
                              const Offer& offer) const {
        using L = PacketLanes;
        const PacketTag d;
        const TriangleTree& tree = all.tree;
        const RayOf<L> line{load_vector(rays.origin), load_vector(rays.direction)};
        const auto gone =
            stay_beyond<L>(tree.slabs[leaf], line.origin, line.direction, hn::Load(d, rays.limit));
        const auto meets = L::without(rays.active(entry), gone);
        if (L::none(meets)) {
            return;
        }
        const auto enter = L::select(meets, hn::Load(d, entry.enter), L::all(kInfinity));
        const TriangleBlock& block = tree.blocks[leaf];
        const auto error = doubt_in<L>(
            tree.slabs[leaf], {hn::Load(d, rays.origin_size), hn::Load(d, rays.direction_size)});
        const BlockEdges edges(block);
        for (int k = 0; k < kBlockLanes && tree.names[leaf].object.values[k] >= 0; ++k) {
            const auto in_all = [&](const FloatLanes(&numbers)[3]) HWY_ATTR {
                return Vec3<L::Value>{L::all(numbers[0].values[k]), L::all(numbers[1].values[k]),
                                      L::all(numbers[2].values[k])};
            };
            auto hit = test<L>(line, L::all(0),
                               {in_all(block.corners[0]), in_all(edges.b), in_all(edges.c)}, error,
                               [&](int lane) {
                                   return triangle_hit(one_of(rays, lane).ray, block.corner(0, k),
                                                       block.corner(1, k), block.corner(2, k));
                               });
            hit.t = L::larger(hit.t, enter);
            offer(k, hit);
        }
    }
};

struct alignas(64) PacketHits {
    std::int32_t object[kPacketLanes];
    std::int32_t primitive[kPacketLanes];
    float u[kPacketLanes], v[kPacketLanes];

    [[nodiscard]] HWY_INLINE NearestOfRay of_one(int i, float& limit) {
        return {limit, object[i], primitive[i], u[i], v[i]};
    }
};

/// Nearest hits of a packet; distances are the rays' limits.
struct ClosestOfPacket : PacketQuery {
    static constexpr Order kOrder = Order::nearest_first;
    PacketHits& hits;

    [[nodiscard]] HWY_INLINE ClosestOfRay of_one(int i) const {
        return {all, one_of(rays, i), hits.of_one(i, rays.limit[i])};
    }

    HWY_INLINE bool operator()(std::uint32_t leaf, const PacketRays::Entry& entry) const {
        using L = PacketLanes;
        const PacketTag d;
        const L::IntTag di;
        const TriangleNames& names = all.tree.names[leaf];
        test_leaf(leaf, entry, [&](int k, const kernels::HitIn<L>& hit) HWY_ATTR {
            const auto limit = hn::Load(d, rays.limit);
            if (L::none(L::both(hit.valid, L::is_at_most(hit.t, limit)))) {
                return;
            }
            const auto object = L::all_int(names.object.values[k] + all.first_object);
            const auto number = L::all_int(names.number.values[k]);
            const auto old_object = hn::Load(di, hits.object);
            const auto old_number = hn::Load(di, hits.primitive);
            const auto is_lower = L::either(
                L::is_less_int(object, old_object),
                L::both(L::is_equal_int(object, old_object), L::is_less_int(number, old_number)));
            const auto take = is_better<L>({hit.t, hit.valid}, limit, is_lower);
            hn::Store(L::select(take, hit.t, limit), d, rays.limit);
            hn::Store(L::select_int(take, object, old_object), di, hits.object);
            hn::Store(L::select_int(take, number, old_number), di, hits.primitive);
            hn::Store(L::select(take, hit.u, hn::Load(d, hits.u)), d, hits.u);
            hn::Store(L::select(take, hit.v, hn::Load(d, hits.v)), d, hits.v);
        });
        return false;
    }
};

/// Occlusion of a packet: limits become -1.
struct AnyOfPacket : PacketQuery {
    static constexpr Order kOrder = Order::any;

    [[nodiscard]] HWY_INLINE AnyOfRay of_one(int i) const {
        return {all.tree, one_of(rays, i), rays.limit[i]};
    }

    HWY_INLINE bool operator()(std::uint32_t leaf, const PacketRays::Entry& entry) const {
        using L = PacketLanes;
        const PacketTag d;
        auto limit = hn::Load(d, rays.limit);
        test_leaf(leaf, entry, [&](int /*k*/, const kernels::HitIn<L>& hit) HWY_ATTR {
            const auto found = L::both(hit.valid, L::is_less(hit.t, limit));
            limit = L::select(found, L::all(-1), limit);
        });
        hn::Store(limit, d, rays.limit);
        return false;
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
