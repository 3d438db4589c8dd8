#include "lab/structures/counted_trees.h"

#include <algorithm>

#include <hwy/highway.h>

#include "render/acceleration/analytic_tree_queries-inl.h"
#include "render/acceleration/instance_queries-inl.h"
#include "render/triangle/moller_trumbore.h"

// One instruction set is enough, since all give the same bits and nobody measures the time.
HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace {

/// The nodes of a tree, which counts those that are visited.
struct CountedNodes {
    const WideTree& tree;
    KindCounts& counts;

    [[nodiscard]] const WideNode& node(std::uint32_t index) const {
        const WideNode& node = tree.node(index);
        counts.nodes += 1;
        counts.boxes += static_cast<std::uint64_t>(
            std::ranges::count_if(node.children, [](std::int32_t child) { return child != 0; }));
        return node;
    }
    [[nodiscard]] const WideTravel& travel(std::uint32_t index) const { return tree.travel(index); }
};

void count_shapes(const ObjectLanes& objects, KindCounts& counts) {
    counts.objects += static_cast<std::uint64_t>(
        std::ranges::count_if(objects.values, [](std::int32_t object) { return object >= 0; }));
}

/// A query of analytic shapes that counts its tests.
template <class Question>
struct Noted {
    Question question;
    KindCounts* counts;

    template <class D, class Block, class Test>
    bool operator()(D d, const RayLanes<D>& ray, const Block& block, const Test& test) const {
        count_shapes(block.object, *counts);
        return question(d, ray, block, test);
    }
    bool operator()(const MovingShape& shape, const Ray& ray) const {
        counts->objects += 1;
        return question(shape, ray);
    }
};

/// Calls `found(hit)` for each hit of a triangle in a leaf until it returns true.
template <class Found>
bool test_leaf(const TriangleTree& tree, std::uint32_t leaf, const Ray& ray, float enter,
               const Found& found) {
    const TriangleBlock& block = tree.blocks[leaf];
    const TriangleNames& names = tree.names[leaf];
    Ray whole = ray;
    whole.t_max = kInfinity;
    for (int k = 0; k < kBlockLanes && names.object.values[k] >= 0; ++k) {
        const auto hit =
            triangle_hit(whole, block.corner(0, k), block.corner(1, k), block.corner(2, k));
        if (hit &&
            found(Hit{std::max(hit->t, enter), static_cast<std::uint32_t>(names.object.values[k]),
                      static_cast<std::uint32_t>(names.number.values[k]), hit->u, hit->v})) {
            return true;
        }
    }
    return false;
}

/// Calls `found(hit)` for hits before `limit` until it returns true.
template <Order kOrder, class Found>
void ask_triangles(const TriangleTree& tree, const Ray& ray, const float& limit, KindCounts& counts,
                   const Found& found) {
    if (tree.blocks.empty()) {
        return;
    }
    traverse<kOrder>(CountedNodes{tree.tree, counts}, SingleRay(ray, limit), {ray.t_min, 0},
                     [&](std::uint32_t leaf, const SingleRay::Entry& entry) {
                         count_shapes(tree.names[leaf].object, counts);
                         return test_leaf(tree, leaf, ray, entry.enter, found);
                     });
}

/// Asks a tree of instances with one of their queries.
template <Order kOrder, class Query>
void ask_instances(const InstanceTree& tree, const Ray& ray, const float& limit, KindCounts& counts,
                   const Query& query) {
    if (!tree.instances.empty()) {
        traverse<kOrder>(CountedNodes{tree.tree, counts}, SingleRay(ray, limit), {ray.t_min, 0},
                         [&](std::uint32_t leaf, const SingleRay::Entry& entry) {
                             counts.objects += 1;
                             return query(leaf, entry);
                         });
    }
}

}  // namespace

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

namespace carom::render {

using namespace HWY_NAMESPACE;

void closest_counted(const AnalyticTree& tree, const Ray& ray, Hit& best, KindCounts& counts) {
    (void)ask_tree(tree, CountedNodes{tree.tree, counts}, ray, best.t,
                   Noted<ClosestInBlock>{{&best}, &counts});
}

bool any_counted(const AnalyticTree& tree, const Ray& ray, KindCounts& counts) {
    return ask_tree(tree, CountedNodes{tree.tree, counts}, ray, ray.t_max,
                    Noted<AnyInBlock>{{ray.t_max}, &counts});
}

void closest_counted(const TriangleTree& tree, const Ray& ray, Hit& best, KindCounts& counts) {
    ask_triangles<Order::nearest_first>(tree, ray, best.t, counts, [&](const Hit& hit) {
        const bool is_lower = hit.object < best.object ||
                              (hit.object == best.object && hit.primitive < best.primitive);
        if (hit.t < best.t || (hit.t == best.t && best.object != kNoObject && is_lower)) {
            best = hit;
        }
        return false;
    });
}

bool any_counted(const TriangleTree& tree, const Ray& ray, KindCounts& counts) {
    bool found = false;
    ask_triangles<Order::any>(tree, ray, ray.t_max, counts, [&](const Hit& hit) {
        found = hit.t < ray.t_max;
        return found;
    });
    return found;
}

void closest_counted(const InstanceTree& tree, const Ray& ray, Hit& best, KindCounts& counts) {
    float limit = std::min(best.t, PacketLanes::kLargest);
    const float before = limit;
    auto object = static_cast<std::int32_t>(best.object);
    auto primitive = static_cast<std::int32_t>(best.primitive);
    ask_instances<Order::nearest_first>(
        tree, ray, limit, counts,
        ClosestInstanceOfRay{tree, ray, {limit, object, primitive, best.u, best.v}});
    if (limit < before || object != static_cast<std::int32_t>(best.object)) {
        best.t = limit;
        best.object = static_cast<std::uint32_t>(object);
        best.primitive = static_cast<std::uint32_t>(primitive);
    }
}

bool any_counted(const InstanceTree& tree, const Ray& ray, KindCounts& counts) {
    float limit = std::min(ray.t_max, PacketLanes::kLargest);
    ask_instances<Order::any>(tree, ray, limit, counts, AnyInstanceOfRay{tree, ray, limit});
    return limit < 0;
}

}  // namespace carom::render
