// The structures for comparison: they give the same hits as brute force to the last bit, and
// correct counts.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lab/structures/embree_structure.h"
#include "lab/structures/make_structure.h"
#include "lab/structures/primitives.h"
#include "lab/structures/test_counts.h"
#include "lab/triangle/kernel_test.h"
#include "lab/triangle/variants.h"
#include "render/acceleration/hybrid_structure.h"
#include "tests/render/acceleration/random_shapes.h"
#include "tests/render/hits.h"

namespace carom::render {

inline void PrintTo(const AccelerationName& named, std::ostream* out) {
    *out << named.name;
}

namespace {

using test::RandomScene;
using test::TestRandom;

using Named = AccelerationName;

/// All that give the bits of brute force for every shape.
std::vector<Named> exact_structures() {
    std::vector<Named> all;
    std::ranges::copy_if(kAccelerationNames, std::back_inserter(all), [](const Named& named) {
        return named.kind != AccelerationKind::hybrid && named.kind != AccelerationKind::embree;
    });
    return all;
}

std::unique_ptr<AccelerationStructure> make(const RandomScene& scene, AccelerationKind kind,
                                            const StructureOptions& options = {}) {
    return make_structure(kind, scene.shapes, scene.static_meshes, options).structure;
}

/// A structure whose tests are counted.
class CountingStructure {
  public:
    CountingStructure(const RandomScene& scene, AccelerationKind kind,
                      StructureOptions options = {}) {
        options.counts = &counts_;
        made_ = make_structure(kind, scene.shapes, scene.static_meshes, options);
    }
    const AccelerationStructure* operator->() const { return made_.structure.get(); }
    const AccelerationStructure& operator*() const { return *made_.structure; }
    [[nodiscard]] std::size_t bytes() const { return made_.bytes; }
    TestCounts counts() {
        const TestCounts more = counts_.take();
        for (std::size_t kind = 0; kind < more.of.size(); ++kind) {
            total_.of[kind] += more.of[kind];
        }
        return total_;
    }

  private:
    SharedCounts counts_;
    TestCounts total_;
    MadeStructure made_;
};

class Laboratory : public testing::TestWithParam<Named> {};

/// Rays from within, from outside and from far away, some along an axis, some short.
Ray ray_number(int i, TestRandom& random) {
    constexpr float kSize = 2;
    const float from = i % 4 == 0 ? 0.3f * kSize : (i % 4 == 3 ? 100 * kSize : 3 * kSize);
    Ray ray = test::random_ray_toward(random, from, kSize);
    ray.t_max = i % 3 == 0 ? random.between(0.1f, 2 * from) : kInfinity;
    ray.t_min = i % 5 == 0 ? random.between(0, kSize) : 0;
    if (i % 7 == 0) {
        ray.direction = V3f(0, 0, 0);
        ray.direction[i % 3] = i % 2 == 0 ? 1.f : -1.f;
    }
    return ray;
}

struct Asked {
    Ray ray;
    Hit hit;  // of brute force, or without an object
};

std::vector<Asked> asked_of_brute_force(const RandomScene& scene, int rays) {
    const auto brute_force = make(scene, AccelerationKind::brute_force);
    TestRandom random(42);
    std::vector<Asked> asked;
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        asked.push_back({ray_number(i, random), {}});
        hits += brute_force->closest_hit(asked.back().ray, asked.back().hit) ? 1 : 0;
    }
    EXPECT_GT(hits, rays / 5);
    return asked;
}

void expect_bits(const AccelerationStructure& structure, const std::vector<Asked>& asked) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto& [ray, expected] = asked[i];
        const bool found = expected.object != kNoObject;
        Hit hit;
        ASSERT_EQ(structure.closest_hit(ray, hit), found)
            << i << ": " << expected.object << " at " << expected.t;
        ASSERT_EQ(hit.object, expected.object) << i << ": at " << expected.t << " and " << hit.t;
        ASSERT_TRUE(hit.t == expected.t && hit.primitive == expected.primitive &&
                    hit.u == expected.u && hit.v == expected.v)
            << i;
        ASSERT_EQ(structure.any_hit(ray), found) << i;
    }
}

RandomScene everything(int fixed, int moving, int meshes) {
    TestRandom random(7);
    RandomScene scene;
    scene.add_static(random, fixed);
    scene.add_moving(random, moving);
    scene.add_instances(random, moving);
    scene.add_static_meshes(random, meshes);
    return scene;
}

// One test for all structures, because brute force takes the longest.
TEST(LaboratoryOfAll, EveryKindOfShape_BitsOfBruteForce) {
    const RandomScene scene = everything(4, 3, 1);
    const std::vector<Asked> asked = asked_of_brute_force(scene, 100'000);
    for (const Named& named : exact_structures()) {
        SCOPED_TRACE(named.name);
        expect_bits(*make(scene, named.kind), asked);
    }
}

TEST(LaboratoryOfAll, ManySpheresAndMeshes_BitsOfBruteForce) {
    TestRandom random(8);
    RandomScene scene = everything(0, 0, 2);
    for (int i = 0; i < 500; ++i) {
        SphereSegment sphere;
        sphere.path.c[0] = test::random_point(random, 2);
        sphere.radius = i % 100 == 0 ? 0.4f : 0.04f;
        sphere.object = scene.object_count++;
        scene.shapes.add_sphere(sphere);
    }
    const std::vector<Asked> asked = asked_of_brute_force(scene, 6'000);
    for (const Named& named : exact_structures()) {
        SCOPED_TRACE(named.name);
        expect_bits(*make(scene, named.kind), asked);
    }
}

TEST_P(Laboratory, ShapesInOnePlace_LowestObjectIsReported) {
    RandomScene scene;
    for (std::uint32_t i = 0; i < 300; ++i) {
        SphereSegment sphere;
        sphere.radius = 0.5f;
        sphere.object = 299 - i;
        scene.shapes.add_sphere(sphere);
    }
    Ray ray;
    ray.origin = V3f(0.1f, 0.2f, -3);
    Hit hit;
    ASSERT_TRUE(make(scene, GetParam().kind)->closest_hit(ray, hit));
    EXPECT_EQ(hit.object, 0u);
}

TEST_P(Laboratory, NothingAtAll_HitsNothing) {
    const auto structure = make(RandomScene(), GetParam().kind);
    Hit hit;
    EXPECT_FALSE(structure->closest_hit(Ray{}, hit));
    EXPECT_FALSE(structure->any_hit(Ray{}));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(structure->any_hit(Ray{V3f(nan), V3f(0, 0, 1)}));
}

TEST_P(Laboratory, Counts_AreOfTheRaysAndFewerThanBruteForces) {
    TestRandom random(9);
    RandomScene scene;
    for (std::uint32_t i = 0; i < 400; ++i) {
        SphereSegment sphere;
        sphere.path.c[0] = test::random_point(random, 2);
        sphere.radius = 0.08f;
        sphere.object = i;
        scene.shapes.add_sphere(sphere);
    }
    CountingStructure structure(scene, GetParam().kind);
    Hit hit;
    for (int i = 0; i < 300; ++i) {
        Ray ray = test::random_ray_toward(random, 3, 2);
        ray.kind = i < 100 ? RayKind::primary : RayKind::secondary;
        static_cast<void>(i < 200 ? structure->closest_hit(ray, hit) : structure->any_hit(ray));
    }
    const TestCounts counts = structure.counts();
    const bool is_brute = GetParam().kind == AccelerationKind::brute_force;
    for (const KindCounts& kind : counts.of) {
        EXPECT_EQ(kind.rays, 100u);
        EXPECT_GT(kind.objects, 0u);
        EXPECT_LT(kind.objects, is_brute ? 40'001u : 4'000u);
    }
    if (is_brute) {
        EXPECT_EQ(counts[RayKind::primary].objects, 40'000u);
        EXPECT_LT(counts[RayKind::shadow].objects, 40'000u);
    }
}

TEST_P(Laboratory, ShadowRaysThatDoNotStop_TestMore) {
    const RandomScene scene = everything(6, 0, 0);
    CountingStructure stops(scene, GetParam().kind);
    CountingStructure goes_on(scene, GetParam().kind, {.shadow_rays_stop = false});
    TestRandom random(10);
    for (int i = 0; i < 2'000; ++i) {
        const Ray ray = test::random_ray_toward(random, 3, 2);
        ASSERT_EQ(stops->any_hit(ray), goes_on->any_hit(ray));
    }
    EXPECT_LT(stops.counts().total().objects, goes_on.counts().total().objects);
}

RandomScene row_of_spheres(std::uint32_t count) {
    RandomScene scene;
    for (std::uint32_t i = 0; i < count; ++i) {
        SphereSegment sphere;
        sphere.path.c[0] = V3f(static_cast<float>(i), 0, 0);
        sphere.radius = 0.4f;
        sphere.object = i;
        scene.shapes.add_sphere(sphere);
    }
    return scene;
}

Ray down_at(float x) {
    Ray ray;
    ray.kind = RayKind::primary;
    ray.origin = V3f(x, 0, 3);
    ray.direction = V3f(0, 0, -1);
    return ray;
}

// Halves of equal number: of eight spheres in a row, pairs are two levels below the root. Every
// sphere is in one leaf, whose box is that of the pair.
TEST(LaboratoryOfMedianKdTree, RowOfSpheres_IsHalvedByNumberIntoPairs) {
    const RandomScene scene = row_of_spheres(8);
    CountingStructure structure(scene, AccelerationKind::kd_tree_median);
    Hit hit;
    ASSERT_TRUE(structure->closest_hit(down_at(5), hit));
    EXPECT_EQ(hit.object, 5u);
    const TestCounts counts = structure.counts();
    EXPECT_EQ(counts[RayKind::primary].nodes, 2u);    // of eight spheres and of four
    EXPECT_EQ(counts[RayKind::primary].boxes, 4u);    // two in each
    EXPECT_EQ(counts[RayKind::primary].objects, 2u);  // both of the leaf
}

// Long shapes side by side overlap any plane across them: a tree that divides space lists them many
// times, one that divides the shapes does not.
TEST(LaboratoryOfMedianKdTree, ManyShapesInOnePlace_AreEachInOneLeaf) {
    RandomScene scene;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        SphereSegment sphere;
        sphere.path.c[0] = V3f(0.001f * static_cast<float>(i), 0, 0);
        sphere.radius = 0.5f;
        sphere.object = i;
        scene.shapes.add_sphere(sphere);
    }
    CountingStructure structure(scene, AccelerationKind::kd_tree_median);
    Hit hit;
    ASSERT_TRUE(structure->closest_hit(down_at(0.5f), hit));
    EXPECT_LE(structure.counts()[RayKind::primary].objects, 1000u);
    EXPECT_LE(structure.counts()[RayKind::primary].boxes, 2u * 511);
    EXPECT_LT(structure.bytes(), 1000u * 100);
}

TEST(LaboratoryOfSingleBoxes, EveryRay_TestsAllBoxesAndTheShapesOfThoseItEnters) {
    CountingStructure structure(row_of_spheres(10), AccelerationKind::single_boxes);
    Hit hit;
    ASSERT_TRUE(structure->closest_hit(down_at(5), hit));
    ASSERT_FALSE(structure->closest_hit(down_at(5.5f), hit));
    const TestCounts counts = structure.counts();
    EXPECT_EQ(counts[RayKind::primary].boxes, 20u);
    EXPECT_EQ(counts[RayKind::primary].objects, 1u);
    EXPECT_EQ(structure.bytes(), 10 * sizeof(Imath::Box3f));
}

SphereSegment sphere_at(const V3f& centre, float radius, std::uint32_t object) {
    SphereSegment sphere;
    sphere.path.c[0] = centre;
    sphere.radius = radius;
    sphere.object = object;
    return sphere;
}

/// A small sphere in each corner of a cube, and a larger one in its middle.
RandomScene corners_and_middle() {
    RandomScene scene;
    for (std::uint32_t i = 0; i < 8; ++i) {
        const V3f corner(i & 1u ? 3.f : -3.f, i & 2u ? 3.f : -3.f, i & 4u ? 3.f : -3.f);
        scene.shapes.add_sphere(sphere_at(corner, 0.5f, i));
    }
    scene.shapes.add_sphere(sphere_at(V3f(0, 0, 0), 1, 8));
    return scene;
}

KindCounts counts_of(AccelerationKind kind, const RandomScene& scene, const Ray& ray,
                     const StructureSizes& sizes = {}) {
    CountingStructure structure(scene, kind, {.sizes = sizes});
    Hit hit;
    static_cast<void>(structure->closest_hit(ray, hit));
    return structure.counts()[RayKind::primary];
}

std::size_t bytes_of(AccelerationKind kind, const RandomScene& scene,
                     const StructureSizes& sizes = {}) {
    return make_structure(kind, scene.shapes, scene.static_meshes, {.sizes = sizes}).bytes;
}

// What each placement does with the sphere across the middle of the cube.
TEST(LaboratoryOfOctrees, ShapeAcrossTheMiddle_IsWhereItsPlacementPutsIt) {
    const RandomScene scene = corners_and_middle();
    Ray past = down_at(2.5f);  // through the lower of two corners, where no sphere is hit
    past.origin.y = 2.5f;
    past.origin.z = 10;
    const auto counts = [&](AccelerationKind kind) { return counts_of(kind, scene, past); };
    // The centre belongs to one of the eight parts. Seven hold one sphere each, which is an entry
    // of the root, the eighth is a node.
    EXPECT_EQ(counts(AccelerationKind::octree).boxes, 8u);
    // So it does where cubes are twice as wide.
    EXPECT_EQ(counts(AccelerationKind::octree_loose).boxes, 8u);
    // The root holds it beside the eight others.
    EXPECT_EQ(counts(AccelerationKind::octree_enclosing).boxes, 9u);
    // Each of the eight parts holds it; a ray enters two of them, with two shapes each.
    EXPECT_EQ(counts(AccelerationKind::octree_overlapping).boxes, 8u + 4);
    EXPECT_EQ(counts(AccelerationKind::octree_cut).boxes, 8u + 4);
    const auto size = [&](AccelerationKind kind) { return bytes_of(kind, scene); };
    EXPECT_GT(size(AccelerationKind::octree_cut), size(AccelerationKind::octree));
}

// In four of the parts that a ray through the middle enters there is a piece of the sphere.
TEST(LaboratoryOfOctrees, ShapeInSeveralLeaves_IsTestedOnce) {
    const RandomScene scene = corners_and_middle();
    Ray through = down_at(0);
    through.origin.z = 10;
    for (const AccelerationKind kind :
         {AccelerationKind::octree_overlapping, AccelerationKind::octree_cut}) {
        const KindCounts counts = counts_of(kind, scene, through);
        EXPECT_EQ(counts.objects, 1u);
        EXPECT_GT(counts.nodes, 2u);
    }
}

// A rod along x is in two parts, each of which has a sphere in its corner. A ray across its one end
// enters only the box of the piece there; the other part reaches as far as its whole cube does.
TEST(LaboratoryOfOctrees, Pieces_EndAtTheirCubes) {
    RandomScene scene = corners_and_middle();
    test::add_aligned_box(scene.shapes, V3f(-3, 1.1f, 1.1f), V3f(3, 1.2f, 1.2f), 9);
    Ray across = down_at(-2);
    across.origin.y = 1.15f;
    across.origin.z = 10;
    EXPECT_EQ(counts_of(AccelerationKind::octree_cut, scene, across).nodes, 2u);
    const KindCounts whole = counts_of(AccelerationKind::octree_overlapping, scene, across);
    EXPECT_EQ(whole.nodes, 2u);
    EXPECT_EQ(whole.objects, 1u);
}

TEST(LaboratoryOfOctrees, OneQueueForAllLevels_TestsNoMoreShapes) {
    TestRandom random(12);
    const RandomScene scene = everything(30, 0, 0);
    CountingStructure stack(scene, AccelerationKind::octree);
    CountingStructure queue(scene, AccelerationKind::octree_queue);
    EXPECT_EQ(stack.bytes(), queue.bytes());
    Hit hit;
    for (int i = 0; i < 3000; ++i) {
        const Ray ray = test::random_ray_toward(random, 3, 2);
        ASSERT_EQ(stack->closest_hit(ray, hit), queue->closest_hit(ray, hit));
    }
    EXPECT_LT(queue.counts().total().objects, stack.counts().total().objects);
    EXPECT_LT(queue.counts().total().boxes, stack.counts().total().boxes);
}

TEST(LaboratoryOfRTrees, CyclicSort_TakesMoreTestsThanTiles) {
    TestRandom random(13);
    RandomScene scene;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        scene.shapes.add_sphere(sphere_at(test::random_point(random, 2), 0.05f, i));
    }
    CountingStructure cyclic(scene, AccelerationKind::r_tree_cyclic);
    CountingStructure tiles(scene, AccelerationKind::r_tree);
    EXPECT_EQ(cyclic.bytes(), tiles.bytes());
    for (int i = 0; i < 1000; ++i) {
        const Ray ray = test::random_ray_toward(random, 3, 2);
        ASSERT_EQ(cyclic->any_hit(ray), tiles->any_hit(ray));
    }
    EXPECT_GT(5 * cyclic.counts().total().boxes, 6 * tiles.counts().total().boxes);
}

// Sixty-four spheres in a square: sorted by x, four share a node if they are in one half of a
// column; sorted by y, four nodes are a quarter of the square. A ray along a column enters two
// quarters.
TEST(LaboratoryOfRTrees, CyclicSort_TakesTheAxesInTurn) {
    RandomScene scene;
    for (std::uint32_t i = 0; i < 64; ++i) {
        const V3f centre(static_cast<float>(i / 8), static_cast<float>(i % 8), 0);
        scene.shapes.add_sphere(sphere_at(centre, 0.3f, i));
    }
    Ray along;
    along.kind = RayKind::primary;
    along.origin = V3f(2.2f, -3, 0.29f);  // inside the boxes, past the spheres
    along.direction = V3f(0, 1, 0);
    const KindCounts counts = counts_of(AccelerationKind::r_tree_cyclic, scene, along);
    EXPECT_EQ(counts.nodes, 1u + 2 + 2);
    EXPECT_EQ(counts.boxes, 4u + 8 + 8);
    EXPECT_EQ(counts.objects, 8u);
}

/// A long cylinder along the diagonal of x and y.
RandomScene diagonal_cylinder() {
    RandomScene scene;
    Mat44 world_from_unit;
    world_from_unit.scale(Vec3(0.1, 0.1, 2));
    Mat44 turn;
    turn.rotate(Vec3(1.5707963267948966, 0, 0.7853981633974483));
    test::add_mapped<UnitFrustum>(
        scene.shapes, Affine::narrowed((world_from_unit * turn).inverse()), 0, V3f(1, 0, 0));
    return scene;
}

// The box along the axes is a square, the cylinder a thin line across it.
TEST(LaboratoryOfVolumes, OrientedBox_IsTightWhereOthersAreNot) {
    const RandomScene scene = diagonal_cylinder();
    Ray beside = down_at(1);
    beside.origin.y = 1;
    Ray opposite = beside;
    opposite.origin.y = -1;
    const std::array<KindCounts, 2> along{
        counts_of(AccelerationKind::oriented_box_volumes, scene, beside),
        counts_of(AccelerationKind::oriented_box_volumes, scene, opposite)};
    EXPECT_EQ(along[0].objects + along[1].objects, 1u);  // the one that hits
    for (const AccelerationKind kind :
         {AccelerationKind::box_volumes, AccelerationKind::sphere_volumes}) {
        EXPECT_EQ(counts_of(kind, scene, beside).objects, 1u);
        EXPECT_EQ(counts_of(kind, scene, opposite).objects, 1u);
    }
}

TEST(LaboratoryOfVolumes, SphereAroundASphere_LeavesOutTheCornersOfItsBox) {
    RandomScene scene;
    scene.shapes.add_sphere(sphere_at(V3f(0, 0, 0), 1, 0));
    Ray corner = down_at(0.9f);
    corner.origin.y = 0.9f;
    EXPECT_EQ(counts_of(AccelerationKind::box_volumes, scene, corner).objects, 1u);
    EXPECT_EQ(counts_of(AccelerationKind::sphere_volumes, scene, corner).objects, 0u);
    EXPECT_EQ(counts_of(AccelerationKind::sphere_volumes, scene, corner).boxes, 1u);
}

// Only the volumes differ.
TEST(LaboratoryOfVolumes, Trees_HaveTheSameNodes) {
    const RandomScene scene = everything(20, 0, 1);
    const std::size_t leaf_and_links = 8;
    const auto nodes = [&](AccelerationKind kind, std::size_t volume) {
        const std::size_t bytes = bytes_of(kind, scene);
        EXPECT_EQ(bytes % (volume + leaf_and_links), 0u);
        return bytes / (volume + leaf_and_links);
    };
    const std::size_t boxes = nodes(AccelerationKind::box_volumes, 24);
    EXPECT_GT(boxes, 100u);
    EXPECT_EQ(nodes(AccelerationKind::sphere_volumes, 16), boxes);
    EXPECT_EQ(nodes(AccelerationKind::oriented_box_volumes, 60), boxes);
    EXPECT_EQ(nodes(AccelerationKind::slabs, 56), boxes);
}

// A ball that goes right and back again has two legs. While it is on one of them, the line of the
// other leads away from it; a box around that line would be entered beyond the ball's way.
TEST(LaboratoryOfMotion, LegOfAPath_IsBoundedOnlyDuringItsTime) {
    RandomScene scene;
    for (const bool is_back : {false, true}) {
        SphereSegment leg;
        leg.path.c[0] = V3f(is_back ? 10.f : 0.f, 0, 0);
        leg.path.c[1] = V3f(is_back ? -20.f : 20.f, 0, 0);
        leg.path.start = is_back ? 0.5f : 0.f;
        leg.start = is_back ? 0.5f : -kInfinity;
        leg.end = is_back ? kInfinity : 0.5f;
        leg.radius = 0.5f;
        scene.shapes.add_sphere(leg);
    }
    Ray hitting = down_at(9);
    hitting.time = 0.45f;
    Ray beyond = down_at(15);
    for (const AccelerationKind kind : {AccelerationKind::bvh, AccelerationKind::slabs}) {
        CountingStructure structure(scene, kind);
        Hit hit;
        ASSERT_TRUE(structure->closest_hit(hitting, hit));
        const std::uint64_t before = structure.counts().total().objects;
        ASSERT_FALSE(structure->closest_hit(beyond, hit));
        EXPECT_EQ(structure.counts().total().objects, before);
    }
}

TEST(LaboratorySizes, LeafCapacity_DecidesWhenShapesAreNotDivided) {
    const RandomScene scene = row_of_spheres(8);
    const KindCounts pairs = counts_of(AccelerationKind::kd_tree_median, scene, down_at(5));
    EXPECT_EQ(pairs.objects, 2u);
    const KindCounts single =
        counts_of(AccelerationKind::kd_tree_median, scene, down_at(5), {.leaf_capacity = 1});
    EXPECT_EQ(single.objects, 1u);
    EXPECT_EQ(single.boxes, 6u);
    const KindCounts all =
        counts_of(AccelerationKind::kd_tree_median, scene, down_at(5), {.leaf_capacity = 8});
    EXPECT_EQ(all.objects, 8u);
    EXPECT_EQ(all.boxes, 1u);
    for (const AccelerationKind kind : {AccelerationKind::octree, AccelerationKind::kd_tree,
                                        AccelerationKind::bsp_tree, AccelerationKind::bvh}) {
        EXPECT_LE(counts_of(kind, scene, down_at(5), {.leaf_capacity = 8}).nodes, 1u);
        EXPECT_GT(counts_of(kind, scene, down_at(5), {.leaf_capacity = 1}).nodes, 1u);
    }
}

TEST(LaboratorySizes, NodeCapacity_IsTheNumberOfChildren) {
    const RandomScene scene = row_of_spheres(64);
    for (const AccelerationKind kind : {AccelerationKind::r_tree, AccelerationKind::r_tree_hilbert,
                                        AccelerationKind::r_tree_cyclic}) {
        EXPECT_EQ(counts_of(kind, scene, down_at(5)).nodes, 3u);  // 64 = 4 * 4 * 4
        EXPECT_EQ(counts_of(kind, scene, down_at(5)).boxes, 12u);
        EXPECT_EQ(counts_of(kind, scene, down_at(5), {.node_capacity = 8}).boxes, 16u);
        EXPECT_EQ(counts_of(kind, scene, down_at(5), {.node_capacity = 64}).boxes, 64u);
    }
}

TEST(LaboratorySizes, GridDensity_IsTheNumberOfCellsPerShape) {
    const RandomScene scene = corners_and_middle();
    const auto cells = [&](double density) {
        return bytes_of(AccelerationKind::grid, scene, {.grid_density = density});
    };
    EXPECT_GT(cells(1000), 5 * cells(10));
    EXPECT_EQ(cells(4), cells(0));
}

// With other sizes the structures are others, but the hits are the same.
TEST(LaboratorySizes, Any_GivesTheBitsOfBruteForce) {
    const RandomScene scene = everything(4, 3, 1);
    const std::vector<Asked> asked = asked_of_brute_force(scene, 4'000);
    for (const Named& named : exact_structures()) {
        SCOPED_TRACE(named.name);
        for (const StructureSizes& sizes :
             {StructureSizes{1, 2, 0.1}, StructureSizes{16, 16, 20}}) {
            expect_bits(*make(scene, named.kind, {.sizes = sizes}), asked);
        }
    }
}

// Five spheres fit into one leaf: its box is the only one, and empty lanes are not counted.
TEST(LaboratoryOfWideBvh, OneLeaf_CountsItsShapes) {
    RandomScene scene;
    for (std::uint32_t i = 0; i < 5; ++i) {
        SphereSegment sphere;
        sphere.path.c[0] = V3f(0, 0, static_cast<float>(i));
        sphere.radius = 0.5f;
        sphere.object = i;
        scene.shapes.add_sphere(sphere);
    }
    CountingStructure structure(scene, AccelerationKind::wide_bvh);
    Ray through;
    through.kind = RayKind::primary;
    through.origin = V3f(0, 0, -3);
    through.direction = V3f(0, 0, 1);
    Ray past = through;
    past.origin = V3f(2, 0, -3);
    Hit hit;
    ASSERT_TRUE(structure->closest_hit(through, hit));
    ASSERT_FALSE(structure->closest_hit(past, hit));
    ASSERT_TRUE(structure->any_hit(through));
    const TestCounts counts = structure.counts();
    EXPECT_EQ(counts[RayKind::primary].rays, 2u);
    EXPECT_EQ(counts[RayKind::primary].objects, 5u);
    EXPECT_EQ(counts[RayKind::primary].boxes, 2u);
    EXPECT_EQ(counts[RayKind::primary].nodes, 2u);
    EXPECT_EQ(counts[RayKind::shadow].rays, 1u);
    EXPECT_EQ(counts[RayKind::shadow].objects, 5u);
}

INSTANTIATE_TEST_SUITE_P(All, Laboratory, testing::ValuesIn(exact_structures()),
                         [](const auto& named) { return std::string(named.param.name); });

/// Tests the primitive of the hit alone.
Hit alone(const Primitives& primitives, const Hit& hit, const Ray& ray) {
    Hit best;
    const auto ask = [&](const Primitive& primitive) {
        Hit found;
        const bool is_it =
            primitive.object == hit.object &&
            (primitive.shape != Primitive::kMeshTriangle || primitive.number == hit.primitive);
        if (is_it && primitives.closest(primitive, ray, found) && found.t < best.t) {
            best = found;
        }
    };
    for (const Primitive& primitive : primitives.bounded()) {
        ask(primitive);
    }
    for (const Primitive& plane : primitives.planes()) {
        ask(plane);
    }
    return best;
}

// Embree has its own triangle test: the primitive that it finds may differ at edges.
TEST(LaboratoryPeers, HybridAndEmbree_FindTheSamePrimitives) {
    const RandomScene scene = everything(3, 2, 2);
    ShapeSet with_meshes = scene.shapes;
    with_meshes.meshes = std::make_shared<TriangleScene>(scene.static_meshes);
    const HybridStructure hybrid(with_meshes);
    const EmbreeStructure embree(make_embree_device(), scene.shapes, scene.static_meshes);
    const auto brute_force =
        make_structure(AccelerationKind::brute_force, scene.shapes, scene.static_meshes).structure;
    const Primitives primitives(scene.shapes, scene.static_meshes);
    TestRandom random(11);
    std::array<int, 2> differing{};
    for (int i = 0; i < 100'000; ++i) {
        Ray ray = test::random_ray_toward(random, 3, 2);
        Hit expected;
        const bool found = brute_force->closest_hit(ray, expected);
        int which = 0;
        for (const AccelerationStructure* structure :
             {static_cast<const AccelerationStructure*>(&hybrid),
              static_cast<const AccelerationStructure*>(&embree)}) {
            Hit hit;
            const bool also = structure->closest_hit(ray, hit);
            const bool is_same = also == found && hit.object == expected.object &&
                                 hit.primitive == expected.primitive;
            differing[static_cast<std::size_t>(which++)] += is_same ? 0 : 1;
            if (is_same && found && i % 50 == 0) {
                const Hit again = alone(primitives, hit, ray);
                EXPECT_TRUE(again.t == expected.t && again.u == expected.u &&
                            again.v == expected.v);
            }
        }
    }
    EXPECT_EQ(differing[0], 0);
    EXPECT_LE(differing[1], 1);
}

// A kernel's own rounding moves a hit, and decides at edges.
TEST(LaboratoryOfKernels, EveryKernelInAStructure_FindsTheTrianglesOfTheRenderers) {
    const RandomScene scene = everything(0, 0, 8);
    const auto usual = make(scene, AccelerationKind::bvh);
    for (const triangle::KernelFacts& kernel : triangle::kKernels) {
        SCOPED_TRACE(kernel.name);
        const auto structure = make(scene, AccelerationKind::bvh,
                                    {.triangle_test = triangle::triangle_test(kernel.kernel)});
        TestRandom random(13);
        int hits = 0;
        int differing = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Ray ray = test::random_ray_toward(random, 3, 2);
            Hit a;
            Hit b;
            const bool found = usual->closest_hit(ray, a);
            const bool also = structure->closest_hit(ray, b);
            const bool is_same = found == also && a.object == b.object &&
                                 a.primitive == b.primitive &&
                                 (!found || std::abs(a.t - b.t) < 1e-4f);
            differing += is_same ? 0 : 1;
            hits += found ? 1 : 0;
        }
        EXPECT_GT(hits, 1000);
        EXPECT_LE(differing, hits / 100);
    }
}

}  // namespace
}  // namespace carom::render
