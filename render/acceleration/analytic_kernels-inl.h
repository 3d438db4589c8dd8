// The kernels of analytic_kernels.h for one instruction set; included once per set by the .cpp.
#include "render/acceleration/analytic_kernels.h"
#include "render/acceleration/shape_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

template <class D>
struct BestLanes {
    using L = VectorLanes<D>;
    ValueOf<L> t;
    IntOf<L> object;

    /// Accepts nearer hits, and of equally near ones the lower object. Object -1, no hit yet, is
    /// never replaced at equal distance.
    /// Returns whether there is any.
    HWY_INLINE bool offer(const LaneHits<D>& hits, const std::int32_t* objects) {
        if (L::none(L::both(hits.valid, L::is_at_most(hits.t, t)))) {
            return false;
        }
        const IntOf<L> other = L::load_int(objects);
        const auto take = is_better<L>(hits, t, L::is_less_int(other, object));
        t = L::select(take, hits.t, t);
        object = L::select_int(take, other, object);
        return true;
    }

    HWY_INLINE void reduce(D d, Candidate& best) const {
        const typename L::IntTag di;
        const float nearest = hn::GetLane(hn::MinOfLanes(d, t));
        const auto at_nearest = L::is_equal(t, L::all(nearest));
        if (L::none(at_nearest)) {
            return;  // all are infinite; Highway's emulated target takes infinity for the largest
                     // float
        }
        const auto candidates =
            L::select_int(at_nearest, object, L::all_int(hwy::LimitsMax<std::int32_t>()));
        const std::int32_t lowest = L::first_of(hn::MinOfLanes(di, candidates));
        best = {nearest, static_cast<std::uint32_t>(lowest)};
    }
};

template <class D, class Block, class Test>
HWY_INLINE void scan(D d, const RayLanes<D>& ray, const std::vector<Block>& blocks,
                     const Test& test, BestLanes<D>& best) {
    for (const Block& block : blocks) {
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            best.offer(test(d, ray, block, lane), block.object.values + lane);
        }
    }
}

template <class D>
HWY_INLINE bool is_any_before(D /*d*/, const LaneHits<D>& hits, hn::Vec<D> t_max) {
    using L = VectorLanes<D>;
    return !L::none(L::both(hits.valid, L::is_less(hits.t, t_max)));
}

template <class D, class Block, class Test>
HWY_INLINE bool scan_any(D d, const RayLanes<D>& ray, hn::Vec<D> t_max,
                         const std::vector<Block>& blocks, const Test& test) {
    for (const Block& block : blocks) {
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            if (is_any_before(d, test(d, ray, block, lane), t_max)) {
                return true;
            }
        }
    }
    return false;
}

using WideTag = hn::CappedTag<float, kBlockLanes>;
using OneTag = hn::CappedTag<float, 1>;

template <class... Shapes>
HWY_INLINE void scan_all(ShapeList<Shapes...> /*list*/, const AnalyticBlocks& blocks,
                         const Ray& ray, const RayLanes<WideTag>& lanes,
                         BestLanes<WideTag>& nearest) {
    const WideTag d;
    (scan(d, lanes, blocks.of<Shapes>().blocks, test_for_ray(Shapes(), d, ray.direction), nearest),
     ...);
}

inline HWY_ATTR void closest(const AnalyticBlocks& blocks, const Ray& ray, Candidate& best) {
    const WideTag d;
    const RayLanes<WideTag> lanes = broadcast(d, ray);
    BestLanes<WideTag> nearest{hn::Set(d, best.t),
                               hn::Set(Int<WideTag>(), static_cast<std::int32_t>(best.object))};
    scan_all(LaneShapes(), blocks, ray, lanes, nearest);
    nearest.reduce(d, best);
}

template <class... Shapes>
HWY_INLINE bool hits_any(ShapeList<Shapes...> /*list*/, const AnalyticBlocks& blocks,
                         const Ray& ray, const RayLanes<WideTag>& lanes) {
    const WideTag d;
    const hn::Vec<WideTag> t_max = hn::Set(d, ray.t_max);
    return (scan_any(d, lanes, t_max, blocks.of<Shapes>().blocks,
                     test_for_ray(Shapes(), d, ray.direction)) ||
            ...);
}

inline HWY_ATTR bool any(const AnalyticBlocks& blocks, const Ray& ray) {
    return hits_any(LaneShapes(), blocks, ray, broadcast(WideTag(), ray));
}

template <class Block, class Test>
HWY_INLINE bool hit_one(const Block& block, int lane, const RayLanes<OneTag>& ray, const Test& test,
                        float& t) {
    const OneTag d;
    const LaneHits<OneTag> hit = test(d, ray, block, lane);
    if (!is_any_before(d, hit, hn::Set(d, t))) {
        return false;
    }
    t = hn::GetLane(hit.t);
    return true;
}

template <class Shape>
HWY_INLINE bool hit_listed(const BlockList<Shape>& list, std::uint32_t index, const Ray& ray,
                           float& t) {
    const RayLanes<OneTag> lanes = broadcast(OneTag(), ray);
    return hit_one(list.blocks[index / kBlockLanes], static_cast<int>(index % kBlockLanes), lanes,
                   test_for_ray(Shape(), OneTag(), ray.direction), t);
}

template <class... Shapes>
HWY_ATTR bool one_of(ShapeList<Shapes...> /*list*/, const AnalyticBlocks& blocks,
                     std::uint32_t shape, std::uint32_t index, const Ray& ray, float& t) {
    return ((shape == kLaneShape<Shapes> && hit_listed(blocks.of<Shapes>(), index, ray, t)) || ...);
}

inline HWY_ATTR bool one(const AnalyticBlocks& blocks, std::uint32_t shape, std::uint32_t index,
                         const Ray& ray, float& t) {
    return one_of(LaneShapes(), blocks, shape, index, ray, t);
}

inline const AnalyticKernels& kernels_of_target() {
    static const AnalyticKernels kKernels = {closest, any, one, hwy::TargetName(HWY_TARGET)};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
