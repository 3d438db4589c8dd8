#include "render/acceleration/batch_kernels.h"

#include <algorithm>

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
        return Vec3<hn::Vec<BatchTag>>{hn::LoadU(d, numbers[0] + first),
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
    const Vec3<hn::Vec<BatchTag>> probe = rays.line.origin + rays.line.direction;
    const hn::Vec<BatchTag> sum = rays.time + probe.x + probe.y + probe.z;
    return hn::Eq(hn::Mul(sum, hn::Zero(d)), hn::Zero(d));
}

/// The reciprocals of rays' directions, which tests with boxes need.
using Reciprocals = Vec3<hn::Vec<BatchTag>>;

HWY_INLINE Reciprocals reciprocals_of(const RayLanes<BatchTag>& rays) {
    return finite_reciprocals<VectorLanes<BatchTag>>(rays.line.direction);
}

/// Whether rays may hit something in a box at up to `limit`, which is above 0 for rays that count.
HWY_INLINE hn::Mask<BatchTag> may_hit(const Imath::Box3f& box, const RayLanes<BatchTag>& rays,
                                      const Reciprocals& inverse, hn::Vec<BatchTag> limit) {
    using L = VectorLanes<BatchTag>;
    const BatchTag d;
    const hn::Vec<BatchTag> wider = hn::Set(d, 1.0001f);
    const BoxCrossingOf<L> crossing =
        cross_box<L>(rays.line.origin, inverse, all_of<L>(box.min), all_of<L>(box.max));
    const hn::Vec<BatchTag> enter = hn::Max(crossing.enter, hn::Zero(d));
    return hn::And(hn::Gt(limit, hn::Zero(d)),
                   hn::Le(enter, hn::Mul(hn::Min(crossing.leave, limit), wider)));
}

/// The rays of a vector, and how far each is tested; queries lower that.
struct Asking {
    RayLanes<BatchTag> rays;
    Reciprocals inverse;
    hn::Vec<BatchTag> limit;
};

/// Calls `query(block, shape, test)` for each shape of a list that the rays may hit, until one
/// returns true.
template <class Shape, class Query>
HWY_INLINE bool each_shape(const LoopBlocks& all, const Asking& asking, const Query& query) {
    const auto& blocks = all.blocks.of<Shape>().blocks;
    const auto test = test_for_rays(Shape(), asking.inverse);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const auto& block = blocks[i];
        if (Shape::kIsBounded && block.object.values[LoopBlocks::kFew] >= 0 &&
            hn::AllFalse(BatchTag(), may_hit(all.boxes[kLaneShape<Shape>][i], asking.rays,
                                             asking.inverse, asking.limit))) {
            continue;
        }
        for (int lane = 0; lane < kBlockLanes && block.object.values[lane] >= 0; ++lane) {
            if (query(block, InAll{lane}, test)) {
                return true;
            }
        }
    }
    return false;
}

template <class Query, class... Shapes>
HWY_INLINE void all_shapes(ShapeList<Shapes...> /*list*/, const LoopBlocks& blocks,
                           const Asking& asking, const Query& query) {
    static_cast<void>((each_shape<Shapes>(blocks, asking, query) || ...));
}

inline HWY_ATTR void closest(const LoopBlocks& blocks, const RayBatch& rays, float* t,
                             std::int32_t* object) {
    const BatchTag d;
    const Int<BatchTag> di;
    for (int first = 0; first < rays.count; first += static_cast<int>(hn::Lanes(d))) {
        const RayLanes<BatchTag> lanes = rays_from(rays, first);
        const hn::Mask<BatchTag> valid_rays = finite_rays(lanes);
        const hn::Vec<BatchTag> before = hn::LoadU(d, t + first);
        Asking asking{lanes, reciprocals_of(lanes), hn::IfThenElseZero(valid_rays, before)};
        hn::Vec<BatchTag>& nearest = asking.limit;
        hn::Vec<Int<BatchTag>> best = hn::LoadU(di, object + first);
        all_shapes(LaneShapes(), blocks, asking,
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

inline HWY_ATTR void occlude(const LoopBlocks& blocks, const RayBatch& rays, float* t) {
    const BatchTag d;
    const hn::Vec<BatchTag> zero = hn::Zero(d);
    for (int first = 0; first < rays.count; first += static_cast<int>(hn::Lanes(d))) {
        const hn::Vec<BatchTag> before = hn::LoadU(d, t + first);
        if (hn::AllFalse(d, hn::Gt(before, zero))) {
            continue;
        }
        const RayLanes<BatchTag> lanes = rays_from(rays, first);
        const hn::Mask<BatchTag> valid_rays = finite_rays(lanes);
        Asking asking{lanes, reciprocals_of(lanes), hn::IfThenElseZero(valid_rays, before)};
        hn::Vec<BatchTag>& t_max = asking.limit;
        all_shapes(LaneShapes(), blocks, asking,
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

inline HWY_ATTR void meet_boxes(std::span<const Imath::Box3f> boxes, const RayBatch& rays,
                                const float* t, std::uint64_t* rays_of_box) {
    const BatchTag d;
    std::fill_n(rays_of_box, boxes.size(), std::uint64_t{0});
    for (int first = 0; first < rays.count; first += static_cast<int>(hn::Lanes(d))) {
        const RayLanes<BatchTag> lanes = rays_from(rays, first);
        const hn::Mask<BatchTag> counts = hn::And(
            finite_rays(lanes), hn::FirstN(d, static_cast<std::size_t>(rays.count - first)));
        const hn::Vec<BatchTag> limit = hn::IfThenElseZero(counts, hn::LoadU(d, t + first));
        if (hn::AllFalse(d, hn::Gt(limit, hn::Zero(d)))) {
            continue;
        }
        const Reciprocals inverse = reciprocals_of(lanes);
        for (std::size_t box = 0; box < boxes.size(); ++box) {
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, may_hit(boxes[box], lanes, inverse, limit), bits);
            rays_of_box[box] |= (bits[0] | static_cast<std::uint64_t>(bits[1]) << 8u) << first;
        }
    }
}

template <class Shape>
HWY_ATTR void hit_moving_shape(const MovingShape& shape, const RayBatch& rays,
                               const std::int32_t* numbers, int count, float* distances) {
    using L = VectorLanes<BatchTag>;
    const BatchTag d;
    const AffineOf<L> unit_from_body = affine_of<L>(shape.unit_from_body);
    const UnitFormOf<L> form{all_of<L>(shape.parameters), hn::Zero(d)};
    const MotionPieces motion = shape.motion->pieces();
    for (int first = 0; first < count; first += static_cast<int>(hn::Lanes(d))) {
        const L::Int number = hn::LoadU(L::IntTag(), numbers + first);
        const auto three = [&](const std::array<const float*, 3>& from) HWY_ATTR {
            return Vec3<L::Value>{L::gather(from[0], number), L::gather(from[1], number),
                                  L::gather(from[2], number)};
        };
        const PoseOf<L> pose = pose_at<L>(motion, L::gather(rays.time, number));
        const RayOf<L> ray = pose.in_body({three(rays.origin), three(rays.direction)});
        const DistanceOf<L> hit =
            hit_unit_shape<Shape::kKind, L>(unit_from_body.ray(ray), hn::Zero(d), form);
        hn::StoreU(hn::IfThenElse(hit.valid, hit.t, hn::Set(d, kInfinity)), d, distances + first);
    }
}

inline HWY_ATTR void hit_moving(const MovingShape& shape, const RayBatch& rays,
                                const std::int32_t* numbers, int count, float* distances) {
    visit_shape(shape.kind, [&](auto unit_shape) HWY_ATTR {
        hit_moving_shape<decltype(unit_shape)>(shape, rays, numbers, count, distances);
    });
}

inline const BatchKernels& batch_kernels_of_target() {
    static constexpr BatchKernels kKernels = {closest, occlude, meet_boxes, hit_moving};
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
