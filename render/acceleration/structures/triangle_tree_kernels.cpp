#include "render/acceleration/structures/triangle_tree.h"

// As in analytic_kernels.cpp.
#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/acceleration/structures/triangle_tree_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/acceleration/wide_traversal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using Tag = hn::CappedTag<float, kBlockLanes>;
using F = hn::Vec<Tag>;

struct F3 {
    F x, y, z;
};

HWY_INLINE F3 load(const Lanes (&lanes)[3], int lane) {
    const Tag d;
    return {hn::Load(d, lanes[0].values + lane), hn::Load(d, lanes[1].values + lane),
            hn::Load(d, lanes[2].values + lane)};
}
HWY_INLINE F3 broadcast(const V3f& v) {
    const Tag d;
    return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}
// Products and sums in the order of Imath's.
HWY_INLINE F dot(const F3& a, const F3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE F3 cross(const F3& a, const F3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct TriangleLanes {
    F t, u, v;
    hn::Mask<Tag> valid;
};

HWY_INLINE TriangleLanes meet(const TriangleBlock& block, int lane, const F3& origin,
                              const F3& direction, float t_min) {
    const Tag d;
    const F zero = hn::Zero(d);
    const F3 edge_b = load(block.edge_b, lane);
    const F3 edge_c = load(block.edge_c, lane);
    const F3 corner = load(block.corner, lane);
    const F3 p = cross(direction, edge_c);
    const F determinant = dot(edge_b, p);
    const F inverse = hn::Set(d, 1.0f) / determinant;
    const F3 from_a{origin.x - corner.x, origin.y - corner.y, origin.z - corner.z};
    const F u = dot(from_a, p) * inverse;
    const F3 q = cross(from_a, edge_b);
    const F v = dot(direction, q) * inverse;
    const F t = dot(edge_c, q) * inverse;
    const auto inside =
        hn::And(hn::And(hn::Ge(u, zero), hn::Ge(v, zero)), hn::Le(u + v, hn::Set(d, 1.0f)));
    const auto valid =
        hn::And(hn::And(inside, hn::Gt(t, hn::Set(d, t_min))), hn::Ne(determinant, zero));
    return {t, u, v, valid};
}

HWY_INLINE void offer(const TriangleBlock& block, const TriangleLanes& met, int lane, Hit& best) {
    const Tag d;
    alignas(32) float t[kBlockLanes], u[kBlockLanes], v[kBlockLanes];
    std::uint8_t bits[8] = {};
    const auto near = hn::And(met.valid, hn::Le(met.t, hn::Set(d, best.t)));
    if (hn::AllFalse(d, near)) {
        return;
    }
    hn::StoreMaskBits(d, near, bits);
    hn::Store(met.t, d, t);
    hn::Store(met.u, d, u);
    hn::Store(met.v, d, v);
    for (unsigned left = bits[0]; left != 0; left &= left - 1) {
        const int k = std::countr_zero(left);
        const auto object = static_cast<std::uint32_t>(block.object.values[lane + k]);
        const auto number = static_cast<std::uint32_t>(block.number.values[lane + k]);
        const bool is_lower =
            object < best.object || (object == best.object && number < best.primitive);
        if (t[k] < best.t || (t[k] == best.t && best.object != kNoObject && is_lower)) {
            best = {t[k], object, number, u[k], v[k]};
        }
    }
}

inline HWY_ATTR void closest_of_triangles(const TriangleTree& tree, const Ray& ray, Hit& best) {
    if (tree.blocks.empty()) {
        return;
    }
    const Tag d;
    const F3 origin = broadcast(ray.origin);
    const F3 direction = broadcast(ray.direction);
    traverse<false>(d, tree.tree, ray, best.t, [&](std::uint32_t leaf) HWY_ATTR {
        const TriangleBlock& block = tree.blocks[leaf];
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            offer(block, meet(block, lane, origin, direction, ray.t_min), lane, best);
        }
        return false;
    });
}

inline HWY_ATTR bool any_of_triangles(const TriangleTree& tree, const Ray& ray) {
    if (tree.blocks.empty()) {
        return false;
    }
    const Tag d;
    const F3 origin = broadcast(ray.origin);
    const F3 direction = broadcast(ray.direction);
    bool found = false;
    traverse<false>(d, tree.tree, ray, ray.t_max, [&](std::uint32_t leaf) HWY_ATTR {
        const TriangleBlock& block = tree.blocks[leaf];
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            const TriangleLanes met = meet(block, lane, origin, direction, ray.t_min);
            const auto before = hn::Lt(met.t, hn::Set(d, ray.t_max));
            found = found || !hn::AllFalse(d, hn::And(met.valid, before));
        }
        return found;
    });
    return found;
}

inline const TriangleTreeKernels& triangle_kernels_of_target() {
    static const TriangleTreeKernels kKernels = {closest_of_triangles, any_of_triangles};
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
