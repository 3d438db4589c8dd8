#include "render/acceleration/triangle_tree.h"

// See analytic_kernels.cpp.
#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/acceleration/triangle_tree_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/acceleration/wide_traversal-inl.h"
#include "render/triangle/moller_trumbore-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using Tag = hn::CappedTag<float, kBlockLanes>;
using F = hn::Vec<Tag>;
namespace kernels = triangle::HWY_NAMESPACE;
using L = VectorLanes<Tag>;
using TriangleLanes = kernels::HitIn<L>;

HWY_INLINE kernels::Triple<F> load(const Lanes (&lanes)[3], int lane) {
    const Tag d;
    return {{hn::Load(d, lanes[0].values + lane), hn::Load(d, lanes[1].values + lane),
             hn::Load(d, lanes[2].values + lane)}};
}
HWY_INLINE kernels::Triple<F> broadcast(const V3f& v) {
    const Tag d;
    return {{hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)}};
}

HWY_INLINE kernels::RayIn<L> ray_in_all(const Ray& ray, float t_max) {
    const Tag d;
    return {broadcast(ray.origin), broadcast(ray.direction), hn::Set(d, ray.t_min),
            hn::Set(d, t_max)};
}

HWY_INLINE TriangleLanes intersect(const TriangleBlock& block, int lane,
                                   const kernels::RayIn<L>& ray) {
    const kernels::MollerTrumbore::Record<L> triangles{
        load(block.corner, lane), load(block.edge_b, lane), load(block.edge_c, lane)};
    return kernels::MollerTrumbore::intersect<triangle::Division::early>(ray, triangles);
}

HWY_INLINE void offer(const TriangleNames& names, const TriangleLanes& hit, int lane, Hit& best) {
    const Tag d;
    alignas(32) float t[kBlockLanes], u[kBlockLanes], v[kBlockLanes];
    std::uint8_t bits[8] = {};
    const auto near = hn::And(hit.valid, hn::Le(hit.t, hn::Set(d, best.t)));
    if (hn::AllFalse(d, near)) {
        return;
    }
    hn::StoreMaskBits(d, near, bits);
    hn::Store(hit.t, d, t);
    hn::Store(hit.u, d, u);
    hn::Store(hit.v, d, v);
    for (unsigned left = bits[0]; left != 0; left &= left - 1) {
        const int k = std::countr_zero(left);
        const auto object = static_cast<std::uint32_t>(names.object.values[lane + k]);
        const auto number = static_cast<std::uint32_t>(names.number.values[lane + k]);
        const bool is_lower =
            object < best.object || (object == best.object && number < best.primitive);
        if (t[k] < best.t || (t[k] == best.t && best.object != kNoObject && is_lower)) {
            best = {t[k], object, number, u[k], v[k]};
        }
    }
}

template <class Tally>
HWY_INLINE void find_closest(const TriangleTree& tree, const Ray& ray, const Tally& tally,
                             Hit& best) {
    if (tree.blocks.empty()) {
        return;
    }
    const Tag d;
    // offer() decides between equally near hits.
    const auto lanes = ray_in_all(ray, kInfinity);
    const auto visit = [&](std::uint32_t leaf) HWY_ATTR {
        tally.shapes(tree.names[leaf].object);
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            offer(tree.names[leaf], intersect(tree.blocks[leaf], lane, lanes), lane, best);
        }
        return false;
    };
    traverse<false>(d, tree.tree, ray, best.t, tally, visit,
                    [&](std::uint32_t leaf) HWY_ATTR { prefetch(tree.blocks[leaf]); });
}

template <class Tally>
HWY_INLINE bool find_any(const TriangleTree& tree, const Ray& ray, const Tally& tally) {
    if (tree.blocks.empty()) {
        return false;
    }
    const Tag d;
    const auto lanes = ray_in_all(ray, ray.t_max);
    bool found = false;
    const auto visit = [&](std::uint32_t leaf) HWY_ATTR {
        tally.shapes(tree.names[leaf].object);
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            found = found || !L::none(intersect(tree.blocks[leaf], lane, lanes).valid);
        }
        return found;
    };
    traverse<false, Order::any>(d, tree.tree, ray, ray.t_max, tally, visit,
                                [&](std::uint32_t leaf) HWY_ATTR { prefetch(tree.blocks[leaf]); });
    return found;
}

inline HWY_ATTR void closest_of_triangles(const TriangleTree& tree, const Ray& ray, Hit& best) {
    find_closest(tree, ray, NoTally(), best);
}
inline HWY_ATTR bool any_of_triangles(const TriangleTree& tree, const Ray& ray) {
    return find_any(tree, ray, NoTally());
}
inline HWY_ATTR void closest_counted(const TriangleTree& tree, const Ray& ray, Hit& best,
                                     KindCounts& counts) {
    find_closest(tree, ray, Tally(counts), best);
}
inline HWY_ATTR bool any_counted(const TriangleTree& tree, const Ray& ray, KindCounts& counts) {
    return find_any(tree, ray, Tally(counts));
}

inline const TriangleTreeKernels& triangle_kernels_of_target() {
    static const TriangleTreeKernels kKernels = {closest_of_triangles, any_of_triangles,
                                                 closest_counted, any_counted};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(triangle_kernels_of_target);

const TriangleTreeKernels& best_triangle_kernels() {
    return HWY_DYNAMIC_DISPATCH(triangle_kernels_of_target)();
}

}  // namespace carom::render

#endif
