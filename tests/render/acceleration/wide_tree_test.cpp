// Trees against brute force: the hits have the same bits.
#include "render/acceleration/wide_tree.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "render/acceleration/hybrid_structure.h"
#include "render/threads/thread_arena.h"
#include "tests/render/acceleration/random_shapes.h"

namespace carom::render {
namespace {

using test::RandomScene;
using test::TestRandom;

constexpr std::size_t kAlways = 0;
constexpr std::size_t kNever = 1'000'000'000;

void expect_same_bits(const Ray& ray, const HybridStructure& tree, const HybridStructure& loops,
                      int& hits) {
    Hit a;
    Hit b;
    const bool found = tree.closest_hit(ray, a);
    ASSERT_EQ(found, loops.closest_hit(ray, b))
        << a.object << " at " << a.t << ", " << b.object << " at " << b.t;
    ASSERT_EQ(a.object, b.object);
    ASSERT_EQ(a.t, b.t);
    ASSERT_EQ(a.primitive, b.primitive);
    ASSERT_EQ(a.u, b.u);
    ASSERT_EQ(a.v, b.v);
    ASSERT_EQ(tree.any_hit(ray), loops.any_hit(ray));
    hits += found ? 1 : 0;
}

void compare(const ShapeSet& shapes, int rays, float size, std::uint64_t seed) {
    const HybridStructure tree(shapes, kAlways);
    const HybridStructure loops(shapes, kNever);
    TestRandom random(seed);
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        // From inside, from outside, from far away.
        const float from = i % 4 == 0 ? 0.3f * size : (i % 4 == 3 ? 200 * size : 3 * size);
        Ray ray = test::random_ray_toward(random, from, size);
        ray.t_max = i % 3 == 0 ? random.between(0.1f, 2 * from) : kInfinity;
        ray.t_min = i % 5 == 0 ? random.between(0, size) : 0;
        if (i % 7 == 0) {  // along an axis
            ray.direction = V3f(0, 0, 0);
            ray.direction[i % 3] = i % 2 == 0 ? 1.f : -1.f;
        }
        expect_same_bits(ray, tree, loops, hits);
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
    EXPECT_GT(hits, rays / 5);
}

TEST(AnalyticTree, EveryKindOfShape_SameBitsAsBruteForce) {
    for (const int count : {1, 3, 40}) {
        TestRandom random(21);
        RandomScene scene;
        scene.add_static(random, count);
        scene.add_moving(random, count);
        scene.add_static_meshes(random, 1);
        compare(scene.shapes, 60'000, 2, 22);
    }
}

TEST(AnalyticTree, ManyMovingSpheresWithImpacts_SameBitsAsBruteForce) {
    TestRandom random(23);
    RandomScene scene;
    for (int i = 0; i < 600; ++i) {
        const RigidMotion motion(test::random_track(random, 2), random.unit(), 1);
        test::add_moving_sphere(scene.shapes, motion, random.between(0.02f, 0.1f),
                                scene.object_count++);
    }
    compare(scene.shapes, 60'000, 2, 24);
}

TEST(AnalyticTree, ManyStaticSpheres_SameBitsAsBruteForce) {
    TestRandom random(25);
    ShapeSet shapes;
    for (std::uint32_t i = 0; i < 5'000; ++i) {
        SphereSegment sphere;
        sphere.path.c[0] = test::random_point(random, 2);
        // A few large ones among many small.
        sphere.radius = i % 100 == 0 ? 0.3f : 0.02f;
        sphere.object = i;
        shapes.add_sphere(sphere);
    }
    compare(shapes, 20'000, 2, 26);
}

TEST(AnalyticTree, AllInOnePlace_LowestObjectIsReported) {
    ShapeSet shapes;
    for (std::uint32_t i = 0; i < 1'000; ++i) {
        SphereSegment sphere;
        sphere.radius = 0.5f;
        sphere.object = 999 - i;
        shapes.add_sphere(sphere);
    }
    const HybridStructure tree(shapes, kAlways);
    Ray ray;
    ray.origin = V3f(0.1f, 0.2f, -3);
    Hit hit;
    ASSERT_TRUE(tree.closest_hit(ray, hit));
    EXPECT_EQ(hit.object, 0u);
}

TEST(AnalyticTree, SpheresAsStarsFarApart_AreAllFound) {
    // Each sphere is a hundred times as far away as the previous one: the heuristic splits them off
    // one by one.
    ShapeSet shapes;
    float place = 1e-6f;
    for (std::uint32_t i = 0; i < 200; ++i) {
        SphereSegment sphere;
        sphere.path.c[0] = V3f(i % 2 == 0 ? place : -place, 0, 0);
        sphere.radius = 0.2f * place;
        sphere.object = i;
        shapes.add_sphere(sphere);
        place *= 1.15f;
    }
    const HybridStructure tree(shapes, kAlways);
    for (std::uint32_t i = 0; i < 200; ++i) {
        const StaticSphereBlock& block = shapes.blocks.of<StaticSphere>().blocks[i / kBlockLanes];
        const V3f centre(block.centre[0].values[i % kBlockLanes], 0, 0);
        Ray ray;
        ray.origin = centre + V3f(0, 0, -1);
        Hit hit;
        ASSERT_TRUE(tree.closest_hit(ray, hit)) << i;
    }
}

TEST(AnalyticTree, NoShapeAtAll_NoHit) {
    const HybridStructure tree(ShapeSet{}, kAlways);
    Hit hit;
    EXPECT_FALSE(tree.closest_hit(Ray{}, hit));
    EXPECT_FALSE(tree.any_hit(Ray{}));
}

TEST(WideTree, AnyNumberOfThreads_SameTree) {
    TestRandom random(41);
    std::vector<MovingBounds> items;
    for (int i = 0; i < 100'000; ++i) {
        const V3f low = test::random_point(random, 10);
        const Imath::Box3f box(low, low + V3f(random.between(0, 0.2f)));
        items.push_back({box, box});
    }
    const auto built_by = [&](int threads) {
        ThreadArena arena(threads);
        return arena.execute([&] { return build_wide_tree(items); });
    };
    const WideTree one = built_by(1);
    for (const int threads : {2, 3, 8}) {
        const WideTree tree = built_by(threads);
        EXPECT_EQ(tree.order, one.order);
        ASSERT_EQ(tree.nodes.size(), one.nodes.size());
        EXPECT_EQ(
            std::memcmp(tree.nodes.data(), one.nodes.data(), one.nodes.size() * sizeof(WideNode)),
            0);
    }
}

TEST(WideTree, EveryItemIsInOneLeafOfAtMostEight) {
    TestRandom random(27);
    std::vector<MovingBounds> items;
    for (int i = 0; i < 3'000; ++i) {
        const V3f low = test::random_point(random, 1);
        const V3f high = low + V3f(0.01f);
        items.push_back({{low, high}, {low, high}});
    }
    const WideTree tree = build_wide_tree(items);
    EXPECT_TRUE(tree.travels.empty());
    std::vector<std::uint32_t> seen = tree.order;
    std::sort(seen.begin(), seen.end());
    for (std::uint32_t i = 0; i < seen.size(); ++i) {
        ASSERT_EQ(seen[i], i);
    }
    std::uint32_t held = 0;
    for (const WideLeaf& leaf : tree.leaves) {
        ASSERT_LE(leaf.count, 8u);
        held += leaf.count;
    }
    EXPECT_EQ(held, items.size());
    EXPECT_LT(tree.leaves.size(), items.size() / 4);  // leaves are well filled
    EXPECT_EQ(build_wide_tree(items).order, tree.order);
}

TEST(BoundsOf, MovingSpheres_HoldThemAtEveryTimeInForce) {
    TestRandom random(28);
    for (int repeat = 0; repeat < 200; ++repeat) {
        ShapeSet shapes;
        const RigidMotion motion(test::random_track(random, 2), random.unit(), 1);
        test::add_moving_sphere(shapes, motion, 0.1f, 0);
        const BlockList<MovingSphere>& list = shapes.blocks.of<MovingSphere>();
        EXPECT_EQ(list.size, motion.path().size());
        for (std::uint32_t index = 0; index < list.size; ++index) {
            const SphereSegment sphere =
                list.blocks[index / kBlockLanes].sphere(static_cast<int>(index % kBlockLanes));
            const MovingBounds bounds = bounds_of(list, index);
            const float from = std::max(sphere.start, 0.f);
            const float to = std::min(sphere.end, 1.f);
            for (int i = 0; i <= 20 && from <= to; ++i) {
                const float time = from + (to - from) * static_cast<float>(i) / 20;
                const V3f low = bounds.open.min + time * (bounds.close.min - bounds.open.min);
                const V3f high = bounds.open.max + time * (bounds.close.max - bounds.open.max);
                const V3f centre = position_on(sphere.path, time);
                for (int axis = 0; axis < 3; ++axis) {
                    ASSERT_LE(low[axis], centre[axis] - 0.1f);
                    ASSERT_GE(high[axis], centre[axis] + 0.1f);
                }
            }
        }
    }
}

}  // namespace
}  // namespace carom::render
