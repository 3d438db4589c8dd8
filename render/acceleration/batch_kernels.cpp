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
    const auto three = [&](const std::array<const float*, 3>& numbers) HWY_ATTR {
        return Vec3<Lanes::Value>{Lanes::load(numbers[0] + first), Lanes::load(numbers[1] + first),
                                  Lanes::load(numbers[2] + first)};
    };
    return {
        {three(rays.origin), three(rays.direction)}, Lanes::all(0), Lanes::load(rays.time + first)};
}

HWY_INLINE Lanes::Mask finite_rays(const RayLanes<BatchTag>& rays) {
    return is_finite<Lanes>(rays.line, rays.time);
}

/// The reciprocals of rays' directions, which tests with boxes need.
using Reciprocals = Vec3<Lanes::Value>;

HWY_INLINE Reciprocals reciprocals_of(const RayLanes<BatchTag>& rays) {
    return finite_reciprocals<Lanes>(rays.line.direction);
}

/// Whether rays may hit something in a box at up to `limit`, which is above 0 for rays that count.
HWY_INLINE Lanes::Mask may_hit(const Imath::Box3f& box, const RayLanes<BatchTag>& rays,
                               const Reciprocals& inverse, Lanes::Value limit) {
    const Lanes::Value wider = Lanes::all(1.0001f);
    const BoxCrossingOf<Lanes> crossing =
        cross_box<Lanes>(rays.line.origin, inverse, all_of<Lanes>(box.min), all_of<Lanes>(box.max));
    const Lanes::Value enter = Lanes::larger(crossing.enter, Lanes::all(0));
    return Lanes::both(Lanes::is_less(Lanes::all(0), limit),
                       Lanes::is_at_most(enter, Lanes::smaller(crossing.leave, limit) * wider));
}

/// The rays of a vector, and how far each is tested; queries lower that.
struct Asking {
    RayLanes<BatchTag> rays;
    Reciprocals inverse;
    Lanes::Value limit;
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
            Lanes::none(may_hit(all.boxes[kLaneShape<Shape>][i], asking.rays, asking.inverse,
                                asking.limit))) {
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
    for (int first = 0; first < rays.count; first += Lanes::count()) {
        const RayLanes<BatchTag> lanes = rays_from(rays, first);
        const Lanes::Mask valid_rays = finite_rays(lanes);
        const Lanes::Value before = Lanes::load(t + first);
        Asking asking{lanes, reciprocals_of(lanes),
                      Lanes::select(valid_rays, before, Lanes::all(0))};
        Lanes::Value& nearest = asking.limit;
        Lanes::Int best = Lanes::load_int(object + first);
        all_shapes(LaneShapes(), blocks, asking,
                   [&](const auto& block, InAll shape, const auto& test) HWY_ATTR {
                       const auto hit = test(BatchTag(), lanes, block, shape);
                       if (Lanes::none(Lanes::both(hit.valid, Lanes::is_at_most(hit.t, nearest)))) {
                           return false;
                       }
                       const auto other = Lanes::all_int(block.object.values[shape.lane]);
                       const auto take =
                           is_better<Lanes>(hit, nearest, Lanes::is_less_int(other, best));
                       nearest = Lanes::select(take, hit.t, nearest);
                       best = Lanes::select_int(take, other, best);
                       return false;
                   });
        Lanes::store(Lanes::select(valid_rays, nearest, before), t + first);
        Lanes::store_int(best, object + first);
    }
}

inline HWY_ATTR void occlude(const LoopBlocks& blocks, const RayBatch& rays, float* t) {
    const Lanes::Value zero = Lanes::all(0);
    for (int first = 0; first < rays.count; first += Lanes::count()) {
        const Lanes::Value before = Lanes::load(t + first);
        if (Lanes::none(Lanes::is_less(zero, before))) {
            continue;
        }
        const RayLanes<BatchTag> lanes = rays_from(rays, first);
        const Lanes::Mask valid_rays = finite_rays(lanes);
        Asking asking{lanes, reciprocals_of(lanes), Lanes::select(valid_rays, before, zero)};
        Lanes::Value& t_max = asking.limit;
        all_shapes(LaneShapes(), blocks, asking,
                   [&](const auto& shapes, InAll shape, const auto& test) HWY_ATTR {
                       const auto hit = test(BatchTag(), lanes, shapes, shape);
                       const auto occluded = Lanes::both(hit.valid, Lanes::is_less(hit.t, t_max));
                       if (Lanes::none(occluded)) {
                           return false;
                       }
                       t_max = Lanes::select(occluded, zero, t_max);
                       return Lanes::none(Lanes::is_less(zero, t_max));
                   });
        Lanes::store(Lanes::select(valid_rays, t_max, before), t + first);
    }
}

inline HWY_ATTR void meet_boxes(std::span<const Imath::Box3f> boxes, const RayBatch& rays,
                                const float* t, std::uint64_t* rays_of_box) {
    const BatchTag d;
    std::fill_n(rays_of_box, boxes.size(), std::uint64_t{0});
    for (int first = 0; first < rays.count; first += Lanes::count()) {
        const RayLanes<BatchTag> lanes = rays_from(rays, first);
        const auto counts = Lanes::both(finite_rays(lanes), Lanes::first_lanes(rays.count - first));
        const auto limit = Lanes::select(counts, Lanes::load(t + first), Lanes::all(0));
        if (Lanes::none(Lanes::is_less(Lanes::all(0), limit))) {
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
    const AffineOf<Lanes> unit_from_body = affine_of<Lanes>(shape.unit_from_body);
    const UnitFormOf<Lanes> form{all_of<Lanes>(shape.parameters), Lanes::all(0)};
    const MotionPieces motion = shape.motion->pieces();
    for (int first = 0; first < count; first += Lanes::count()) {
        const Lanes::Int number = Lanes::load_int(numbers + first);
        const auto three = [&](const std::array<const float*, 3>& from) HWY_ATTR {
            return Vec3<Lanes::Value>{Lanes::gather(from[0], number),
                                      Lanes::gather(from[1], number),
                                      Lanes::gather(from[2], number)};
        };
        const PoseOf<Lanes> pose = pose_at<Lanes>(motion, Lanes::gather(rays.time, number));
        const RayOf<Lanes> ray = pose.in_body({three(rays.origin), three(rays.direction)});
        const DistanceOf<Lanes> hit =
            hit_unit_shape<Shape::kKind, Lanes>(unit_from_body.ray(ray), Lanes::all(0), form);
        Lanes::store(Lanes::select(hit.valid, hit.t, Lanes::all(kInfinity)), distances + first);
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
