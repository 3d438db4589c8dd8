#include "render/acceleration/batch_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/acceleration/batch_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/acceleration/shape_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using BatchTag = hn::CappedTag<float, 16>;

HWY_INLINE RayLanes<BatchTag> rays_from(const RayBatch& rays, int first) {
    const BatchTag d;
    RayLanes<BatchTag> lanes;
    const auto three = [&](const std::array<const float*, 3>& numbers) HWY_ATTR {
        return Three<hn::Vec<BatchTag>>{hn::LoadU(d, numbers[0] + first),
                                        hn::LoadU(d, numbers[1] + first),
                                        hn::LoadU(d, numbers[2] + first)};
    };
    lanes.line = {three(rays.origin), three(rays.direction)};
    lanes.t_min = hn::Zero(d);
    lanes.time = hn::LoadU(d, rays.time + first);
    return lanes;
}

/// Rays with finite numbers only, as in safe_ray.h; other rays hit nothing.
HWY_INLINE hn::Mask<BatchTag> finite_rays(const RayLanes<BatchTag>& rays) {
    const BatchTag d;
    const Three<hn::Vec<BatchTag>> probe = rays.line.origin + rays.line.direction;
    const hn::Vec<BatchTag> sum = rays.time + probe.x + probe.y + probe.z;
    return hn::Eq(hn::Mul(sum, hn::Zero(d)), hn::Zero(d));
}

/// Calls `query(block, shape, test)` for each shape of a list, until one returns true.
template <class Blocks, class Test, class Query>
HWY_INLINE bool each_shape(const Blocks& blocks, const Test& test, const Query& query) {
    for (const auto& block : blocks) {
        for (int lane = 0; lane < kBlockLanes && block.object.values[lane] >= 0; ++lane) {
            if (query(block, InAll{lane}, test)) {
                return true;
            }
        }
    }
    return false;
}

template <class Query, class... Shapes>
HWY_INLINE void all_shapes(ShapeList<Shapes...> /*list*/, const AnalyticBlocks& blocks,
                           const RayLanes<BatchTag>& rays, const Query& query) {
    static_cast<void>(
        (each_shape(blocks.of<Shapes>().blocks, test_for_rays(Shapes(), rays), query) || ...));
}

inline HWY_ATTR void closest(const AnalyticBlocks& blocks, const RayBatch& rays, float* t,
                             std::int32_t* object) {
    const BatchTag d;
    const Int<BatchTag> di;
    for (int first = 0; first < rays.count; first += static_cast<int>(hn::Lanes(d))) {
        const RayLanes<BatchTag> lanes = rays_from(rays, first);
        const hn::Mask<BatchTag> valid_rays = finite_rays(lanes);
        const hn::Vec<BatchTag> before = hn::LoadU(d, t + first);
        hn::Vec<BatchTag> nearest = hn::IfThenElseZero(valid_rays, before);
        hn::Vec<Int<BatchTag>> best = hn::LoadU(di, object + first);
        all_shapes(LaneShapes(), blocks, lanes,
                   [&](const auto& block, InAll shape, const auto& test) HWY_ATTR {
                       const auto [other_t, valid] = test(d, lanes, block, shape);
                       if (hn::AllFalse(d, hn::And(valid, hn::Le(other_t, nearest)))) {
                           return false;
                       }
                       const auto other = hn::Set(di, block.object.values[shape.lane]);
                       const hn::Mask<BatchTag> lower = hn::RebindMask(d, hn::Lt(other, best));
                       const hn::Mask<BatchTag> better = hn::Or(
                           hn::Lt(other_t, nearest), hn::And(hn::Eq(other_t, nearest), lower));
                       const hn::Mask<BatchTag> take = hn::And(valid, better);
                       nearest = hn::IfThenElse(take, other_t, nearest);
                       best = hn::IfThenElse(hn::RebindMask(di, take), other, best);
                       return false;
                   });
        hn::StoreU(hn::IfThenElse(valid_rays, nearest, before), d, t + first);
        hn::StoreU(best, di, object + first);
    }
}

inline HWY_ATTR void occlude(const AnalyticBlocks& blocks, const RayBatch& rays, float* t) {
    const BatchTag d;
    const hn::Vec<BatchTag> zero = hn::Zero(d);
    for (int first = 0; first < rays.count; first += static_cast<int>(hn::Lanes(d))) {
        const hn::Vec<BatchTag> before = hn::LoadU(d, t + first);
        if (hn::AllFalse(d, hn::Gt(before, zero))) {
            continue;
        }
        const RayLanes<BatchTag> lanes = rays_from(rays, first);
        const hn::Mask<BatchTag> valid_rays = finite_rays(lanes);
        hn::Vec<BatchTag> t_max = hn::IfThenElseZero(valid_rays, before);
        all_shapes(LaneShapes(), blocks, lanes,
                   [&](const auto& shapes, InAll shape, const auto& test) HWY_ATTR {
                       const auto [other_t, valid] = test(d, lanes, shapes, shape);
                       const hn::Mask<BatchTag> occluded = hn::And(valid, hn::Lt(other_t, t_max));
                       if (hn::AllFalse(d, occluded)) {
                           return false;
                       }
                       t_max = hn::IfThenElse(occluded, zero, t_max);
                       return hn::AllFalse(d, hn::Gt(t_max, zero));
                   });
        hn::StoreU(hn::IfThenElse(valid_rays, t_max, before), d, t + first);
    }
}

inline HWY_ATTR std::uint64_t meet_box(const Imath::Box3f& box, const RayBatch& rays,
                                       const float* t) {
    using L = VectorLanes<BatchTag>;
    const BatchTag d;
    const hn::Vec<BatchTag> zero = hn::Zero(d);
    const hn::Vec<BatchTag> wider = hn::Set(d, 1.0001f);
    std::uint64_t result = 0;
    for (int first = 0; first < rays.count; first += static_cast<int>(hn::Lanes(d))) {
        const RayLanes<BatchTag> lanes = rays_from(rays, first);
        const BoxCrossingOf<L> crossing =
            cross_box<L>(lanes.line.origin, finite_reciprocals<L>(lanes.line.direction),
                         all_of<L>(box.min), all_of<L>(box.max));
        const hn::Vec<BatchTag> enter = hn::Max(crossing.enter, zero);
        const hn::Vec<BatchTag> limit = hn::LoadU(d, t + first);
        hn::Mask<BatchTag> meets = hn::And(hn::Le(enter, hn::Mul(crossing.leave, wider)),
                                           hn::Le(enter, hn::Mul(limit, wider)));
        meets = hn::And(meets, finite_rays(lanes));
        meets =
            hn::And(meets, hn::And(hn::Gt(limit, zero),
                                   hn::FirstN(d, static_cast<std::size_t>(rays.count - first))));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, meets, bits);
        result |= (bits[0] | static_cast<std::uint64_t>(bits[1]) << 8u) << first;
    }
    return result;
}

inline const BatchKernels& batch_kernels_of_target() {
    static constexpr BatchKernels kKernels = {closest, occlude, meet_box};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(batch_kernels_of_target);

const BatchKernels& best_batch_kernels() {
    return HWY_DYNAMIC_DISPATCH(batch_kernels_of_target)();
}

}  // namespace carom::render

#endif
