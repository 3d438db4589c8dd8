// Queries of trees of analytic shapes by one ray; included once per instruction set.
#include "render/acceleration/analytic_kernels-inl.h"
#include "render/acceleration/analytic_tree.h"
#include "render/acceleration/moving_shape.h"
#include "render/acceleration/tree_traversal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// A query for the nearest hit.
struct ClosestInBlock {
    Hit* best;

    template <class D, class Block, class Test>
    HWY_INLINE bool operator()(D d, const RayLanes<D>& ray, const Block& block,
                               const Test& test) const {
        BestLanes<D> nearest{hn::Set(d, best->t),
                             hn::Set(Int<D>(), static_cast<std::int32_t>(best->object))};
        bool offered = false;
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            offered |= nearest.offer(test(d, ray, block, lane), block.object.values + lane);
        }
        if (offered) {
            Candidate candidate{best->t, best->object};
            nearest.reduce(d, candidate);
            if (candidate.t < best->t || candidate.object != best->object) {
                *best = {candidate.t, candidate.object, 0, 0, 0};
            }
        }
        return false;
    }

    bool operator()(const MovingShape& shape, const Ray& ray) const {
        Ray remaining = ray;
        const bool may_tie = best->object != kNoObject && shape.object < best->object;
        remaining.t_max = may_tie ? std::nextafter(best->t, kInfinity) : best->t;
        Hit hit;
        if (intersect_moving(shape, remaining, hit)) {
            *best = hit;
        }
        return false;
    }
};

/// A query for any hit.
struct AnyInBlock {
    float t_max;

    template <class D, class Block, class Test>
    HWY_INLINE bool operator()(D d, const RayLanes<D>& ray, const Block& block,
                               const Test& test) const {
        for (int lane = 0; lane < kBlockLanes; lane += static_cast<int>(hn::Lanes(d))) {
            if (is_any_before(d, test(d, ray, block, lane), hn::Set(d, t_max))) {
                return true;
            }
        }
        return false;
    }

    bool operator()(const MovingShape& shape, const Ray& ray) const {
        return occluded_by_moving(shape, ray);
    }
};

/// The tests of all shapes for one ray, set up once.
template <class D, class List>
struct RayTests;
template <class D, class... Shapes>
struct RayTests<D, ShapeList<Shapes...>> {
    template <class Shape>
    struct Of {
        [[no_unique_address]] decltype(test_for_ray(Shape(), D(), V3f())) test;
    };
    struct All : Of<Shapes>... {};
    All all;

    HWY_INLINE RayTests(D d, const V3f& direction)
        : all{Of<Shapes>{test_for_ray(Shapes(), d, direction)}...} {}

    template <class Shape>
    HWY_INLINE const auto& of() const {
        return static_cast<const Of<Shape>&>(all).test;
    }
};

template <class D, class Query>
struct VisitLeaf {
    const AnalyticTree& tree;
    const Ray& ray;
    RayLanes<D> lanes;
    RayTests<D, LaneShapes> tests;
    Query query;

    HWY_INLINE VisitLeaf(D d, const AnalyticTree& tree_of, const Ray& of, const Query& asked)
        : tree(tree_of), ray(of), lanes(broadcast(d, of)), tests(d, of.direction), query(asked) {}

    /// Returns true if the query is answered.
    HWY_INLINE bool operator()(std::uint32_t leaf) const {
        const std::uint32_t end = tree.first_part[leaf + 1];
        for (std::uint32_t i = tree.first_part[leaf]; i < end; ++i) {
            const TreePart& part = tree.parts[i];
            if (part.shape == TreePart::kMoving ? query(tree.moving[part.index], ray)
                                                : ask_one_of(LaneShapes(), part)) {
                return true;
            }
        }
        return false;
    }

  private:
    template <class... Shapes>
    HWY_INLINE bool ask_one_of(ShapeList<Shapes...> /*list*/, const TreePart& part) const {
        return ((part.shape == kLaneShape<Shapes> && ask<Shapes>(part.index)) || ...);
    }

    template <class Shape>
    HWY_INLINE bool ask(std::uint32_t block) const {
        if constexpr (Shape::kIsBounded) {
            return query(D(), lanes, tree.blocks.of<Shape>().blocks[block],
                         tests.template of<Shape>());
        } else {
            return false;
        }
    }
};

/// Asks `query` about the leaves that the ray enters before `limit`. `nodes`: those of the tree, as
/// traverse() needs them. Returns whether the query was answered before all leaves were visited.
template <class Nodes, class Query>
HWY_ATTR bool ask_tree(const AnalyticTree& tree, const Nodes& nodes, const Ray& ray,
                       const float& limit, const Query& query) {
    if (tree.tree.nodes.empty()) {
        return false;
    }
    const VisitLeaf<WideTag, Query> leaf(WideTag(), tree, ray, query);
    bool answered = false;
    const auto visit = [&](std::uint32_t index, const SingleRay::Entry& /*entry*/) HWY_ATTR {
        answered = leaf(index);
        return answered;
    };
    const SingleRay::Entry root{ray.t_min, 0};
    if (tree.tree.travels.empty()) {
        traverse<Order::nearest_first>(nodes, SingleRay(ray, limit), root, visit);
    } else {
        traverse<Order::nearest_first, true>(nodes, SingleRay(ray, limit), root, visit);
    }
    return answered;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
