#include "render/acceleration/analytic_kernels.h"

#include <vector>

#include <gtest/gtest.h>

#include "render/acceleration/hybrid_structure.h"
#include "tests/render/acceleration/owned_batch.h"
#include "tests/render/acceleration/random_shapes.h"
#include "tests/render/every_target.h"
#include "tests/render/geometry/intersect.h"

namespace carom::render {
namespace {

/// The nearest hits of rays alone, under a tree and in a batch, and whether each ray hits anything.
struct Answers {
    std::vector<Hit> alone, in_tree, in_batch;
    std::vector<bool> any;

    Answers(const ShapeSet& shapes, const std::vector<Ray>& rays) : in_batch(rays.size()) {
        constexpr std::size_t kNeverATree = 100'000;
        const HybridStructure structure(shapes, kNeverATree);
        const HybridStructure tree(shapes, 0);
        for (const Ray& ray : rays) {
            static_cast<void>(structure.closest_hit(ray, alone.emplace_back()));
            static_cast<void>(tree.closest_hit(ray, in_tree.emplace_back()));
            any.push_back(structure.any_hit(ray));
        }
        const test::OwnedBatch batch(rays);
        structure.closest_hits(batch.rays(), in_batch.data());
    }
};

bool is_same(const Hit& a, const Hit& b) {
    return a.object == b.object && a.t == b.t && a.primitive == b.primitive && a.u == b.u &&
           a.v == b.v;
}

TEST(AnalyticKernels, EveryInstructionSet_GivesTheSameBits) {
    test::TestRandom random(1);
    test::RandomScene scene;
    scene.add_static(random, 9);
    scene.add_moving(random, 6);
    scene.add_static_meshes(random, 2);
    std::vector<Ray> rays;
    for (int i = 0; i < 20'000; ++i) {
        rays.push_back(test::random_ray_toward(random, 3, 2));
    }
    const Answers best(scene.shapes, rays);
    test::for_each_instruction_set([&](const char* name) {
        const Answers other(scene.shapes, rays);
        int hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits += best.alone[i].object != kNoObject ? 1 : 0;
            ASSERT_TRUE(is_same(best.alone[i], other.alone[i])) << name << ", ray " << i;
            ASSERT_TRUE(is_same(best.alone[i], other.in_tree[i])) << name << ", ray " << i;
            ASSERT_TRUE(is_same(best.alone[i], other.in_batch[i])) << name << ", ray " << i;
            ASSERT_EQ(best.any[i], other.any[i]) << name << ", ray " << i;
        }
        EXPECT_GT(hits, 10'000);
    });
}

/// Every ray must hit the shapes of a kind at the distance that a single ray's test finds.
template <class Shape>
void compare_with_single_rays(const AnalyticBlocks& blocks, const std::vector<Ray>& rays) {
    int hits = 0;
    const BlockList<Shape>& list = blocks.of<Shape>();
    for (std::uint32_t index = 0; index < list.size; ++index) {
        const auto& block = list.blocks[index / kBlockLanes];
        const int lane = static_cast<int>(index % kBlockLanes);
        if (block.one_sided.values[lane] != 0) {
            continue;
        }
        const Affine unit_from_world = block.unit_from_world(lane);
        for (const Ray& ray : rays) {
            const UnitRay in_unit{unit_from_world.point(ray.origin),
                                  unit_from_world.vector(ray.direction), ray.t_min, ray.t_max};
            const auto expected =
                intersect_unit_shape<Shape::kKind>(in_unit, block.parameters_of(lane));
            float t = ray.t_max;
            const bool found = best_kernels().one(blocks, kLaneShape<Shape>, index, ray, t);
            EXPECT_EQ(found, expected.has_value());
            EXPECT_EQ(t, expected.value_or(ray.t_max));
            hits += found ? 1 : 0;
        }
    }
    EXPECT_GT(hits, 100) << static_cast<int>(Shape::kKind);
}

TEST(AnalyticKernels, Lanes_GiveTheBitsOfSingleRays) {
    test::TestRandom random(2);
    test::RandomScene scene;
    scene.add_static(random, 9);
    std::vector<Ray> rays;
    for (int i = 0; i < 50'000; ++i) {
        rays.push_back(test::random_ray_toward(random, 3, 2));
        rays.back().t_min = i % 5 == 0 ? random.between(0, 3) : 0;
        rays.back().t_max = i % 3 == 0 ? random.between(0.1f, 5) : kInfinity;
    }
    const auto compare_all = [&]<class... Shapes>(ShapeList<Shapes...>) {
        (compare_with_single_rays<Shapes>(scene.shapes.blocks, rays), ...);
    };
    compare_all(UnitShapes());
}

TEST(Candidate, Offer_TakesNearerThenLower) {
    Candidate best{5, kNoObject};
    best.offer(5, 3);  // not nearer than the ray's end
    EXPECT_EQ(best.object, kNoObject);
    best.offer(4, 3);
    best.offer(4, 7);
    EXPECT_EQ(best.object, 3u);
    best.offer(4, 1);
    EXPECT_EQ(best.object, 1u);
    best.offer(3, 9);
    EXPECT_EQ(best.object, 9u);
}

}  // namespace
}  // namespace carom::render
