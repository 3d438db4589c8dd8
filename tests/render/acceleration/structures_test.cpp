// The structures against each other and against plain loops over scalar code.
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "lab/structures/embree_structure.h"
#include "render/acceleration/hybrid_structure.h"
#include "tests/render/acceleration/owned_batch.h"
#include "tests/render/acceleration/random_shapes.h"
#include "tests/render/geometry/intersect.h"
#include "tests/render/hits.h"

namespace carom::render {
namespace {

using test::OwnedBatch;
using test::RandomScene;
using test::TestRandom;

struct Structures {
    explicit Structures(const RandomScene& scene)
        : hybrid(scene.shapes),
          tree(scene.shapes, 0),
          embree(make_embree_device(), scene.shapes, scene.static_meshes) {}
    HybridStructure hybrid;
    HybridStructure tree;
    EmbreeStructure embree;
};

/// Whether two hits, or misses, are the same. Embree has its own test of triangles, so that
/// distances of meshes may differ in their last bits.
bool is_same(const Hit& a, const Hit& b) {
    return a.object == b.object && a.primitive == b.primitive &&
           (a.t == b.t || (test::is_on_mesh(a) && test::is_on_mesh(b) &&
                           std::abs(a.t - b.t) <= 2e-6f * (1 + a.t)));
}

void expect_same_hits(const RandomScene& scene, int rays, std::uint64_t seed) {
    const Structures structures(scene);
    TestRandom random(seed);
    int hits = 0;
    int unlike_embree = 0;
    for (int i = 0; i < rays; ++i) {
        Ray ray = test::random_ray_toward(random, 3, 2);
        ray.t_max = i % 3 == 0 ? random.between(0.1f, 3) : kInfinity;
        ray.t_min = i % 5 == 0 ? random.between(0, 1) : 0;
        Hit a;
        Hit b;
        const bool found = structures.hybrid.closest_hit(ray, a);
        const bool also = structures.embree.closest_hit(ray, b);
        // A ray along an edge of a mesh may hit another triangle, or pass.
        if (test::is_on_mesh(a) || test::is_on_mesh(b)) {
            unlike_embree += is_same(a, b) ? 0 : 1;
        } else {
            ASSERT_EQ(also, found) << "ray " << i;
            ASSERT_TRUE(is_same(a, b)) << "ray " << i;
        }
        if (found) {
            ASSERT_GT(a.t, ray.t_min);
            ASSERT_LT(a.t, ray.t_max);
            ++hits;
        }
        ASSERT_EQ(structures.hybrid.any_hit(ray), found) << "ray " << i;
        Hit c;
        ASSERT_EQ(structures.tree.closest_hit(ray, c), found) << "ray " << i;
        ASSERT_TRUE(c.object == a.object && c.t == a.t && c.primitive == a.primitive) << i;
        ASSERT_EQ(structures.tree.any_hit(ray), found) << "ray " << i;
        ASSERT_EQ(structures.embree.any_hit(ray), also) << "ray " << i;
    }
    EXPECT_GT(hits, rays / 3);
    EXPECT_LE(unlike_embree, 2);
}

TEST(Structures, StaticShapes_SameHits) {
    TestRandom random(1);
    RandomScene scene;
    scene.add_static(random, 9);
    scene.add_static_meshes(random, 3);
    expect_same_hits(scene, 100'000, 2);
}

TEST(Structures, MovingShapes_SameHits) {
    TestRandom random(3);
    RandomScene scene;
    scene.add_moving(random, 6);
    scene.add_static(random, 3);
    scene.add_static_meshes(random, 2);
    expect_same_hits(scene, 100'000, 4);
}

TEST(Structures, InstancesOfOneMesh_SameHits) {
    TestRandom random(31);
    RandomScene scene;
    scene.add_instances(random, 60);
    scene.add_static(random, 2);
    scene.add_static_meshes(random, 2);
    expect_same_hits(scene, 100'000, 32);
}

/// The number of rays that get another answer in a batch than alone.
int differing_in_batches(const AccelerationStructure& structure, int count, std::uint64_t seed) {
    TestRandom random(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        rays.push_back(test::random_ray_toward(random, 3, 2));
        rays.back().t_max = i % 3 == 0 ? kInfinity : i % 7 == 0 ? 0 : random.between(0.1f, 4);
    }
    OwnedBatch batch(rays);
    std::vector<Hit> hits(rays.size());
    structure.closest_hits(batch.rays(), hits.data());
    structure.test_occlusion(batch.rays(), batch.values[7].data());
    int differing = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Ray unbounded = rays[i];
        unbounded.t_max = kInfinity;
        Hit alone;
        const bool found = structure.closest_hit(unbounded, alone);
        EXPECT_EQ(found, hits[i].object != kNoObject);
        const bool is_same = alone.object == hits[i].object &&
                             alone.primitive == hits[i].primitive && alone.t == hits[i].t &&
                             alone.u == hits[i].u && alone.v == hits[i].v;
        const float expected = rays[i].t_max > 0 && structure.any_hit(rays[i]) ? 0 : rays[i].t_max;
        differing += is_same && batch.values[7][i] == expected ? 0 : 1;
    }
    return differing;
}

TEST(Structures, Batches_AreAnsweredAsTheirRays) {
    TestRandom random(21);
    RandomScene scene;
    scene.add_moving(random, 6);
    scene.add_static(random, 3);
    constexpr std::size_t kNeverATree = 100'000;
    for (const int count : {1, 15, 16, 17, 64, 65, 20'000}) {
        EXPECT_EQ(differing_in_batches(HybridStructure(scene.shapes, kNeverATree), count, 22), 0);
    }
    EXPECT_EQ(differing_in_batches(HybridStructure(scene.shapes, 0), 20'000, 23), 0);
    EXPECT_EQ(differing_in_batches(Structures(scene).embree, 5'000, 24), 0);
    scene.add_static_meshes(random, 2);
    scene.add_instances(random, 50);
    EXPECT_EQ(differing_in_batches(HybridStructure(scene.shapes, kNeverATree), 20'000, 25), 0);
}

TEST(Structures, BatchesWithBadRays_HitNothing) {
    TestRandom random(14);
    RandomScene scene;
    scene.add_static(random, 9);
    scene.add_static_meshes(random, 2);
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    std::vector<Ray> rays(3);
    rays[0].direction = V3f(kNan, 0, 1);
    rays[1].origin = V3f(0, kNan, 0);
    rays[2].origin = V3f(0, 0, kInfinity);
    OwnedBatch batch(rays);
    std::vector<Hit> hits(rays.size());
    const HybridStructure structure(scene.shapes, 100'000);
    structure.closest_hits(batch.rays(), hits.data());
    structure.test_occlusion(batch.rays(), batch.values[7].data());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(hits[i].object, kNoObject) << i;
        EXPECT_EQ(batch.values[7][i], kInfinity) << i;
    }
}

TEST(Structures, MoreSpheresThanLanes_SameHits) {
    for (const int count : {1, 7, 8, 9, 17, 33}) {
        TestRandom random(static_cast<std::uint64_t>(count));
        RandomScene scene;
        for (int i = 0; i < count; ++i) {
            test::add_moving_sphere(scene.shapes, RigidMotion(test::random_track(random, 1), 0, 1),
                                    0.2f, scene.object_count++);
        }
        const HybridStructure hybrid(scene.shapes);
        const EmbreeStructure embree(make_embree_device(), scene.shapes, {});
        for (int i = 0; i < 3'000; ++i) {
            const Ray ray = test::random_ray(random, 2);
            Hit a;
            Hit b;
            ASSERT_EQ(hybrid.closest_hit(ray, a), embree.closest_hit(ray, b));
            ASSERT_EQ(a.object, b.object);
            ASSERT_EQ(a.t, b.t);
        }
    }
}

/// Nearest hit of all spheres in double precision, from the object's position at that time.
Hit nearest_sphere(const std::vector<sim::Track>& tracks, const std::vector<float>& radii,
                   const Ray& ray) {
    Hit best;
    for (std::uint32_t i = 0; i < tracks.size(); ++i) {
        const Vec3 centre = tracks[i].sample(static_cast<double>(ray.time)).position;
        const auto radius = static_cast<double>(radii[i]);
        const auto t = intersect_unit_shape<ShapeKind::sphere>(
            RaySegment<double>{(Vec3(ray.origin) - centre) / radius, Vec3(ray.direction) / radius});
        if (t && static_cast<float>(*t) < best.t) {
            best = {static_cast<float>(*t), i, 0, 0, 0};
        }
    }
    return best;
}

TEST(HybridStructure, SpheresWithImpacts_ExactPathOfTheTimeline) {
    TestRandom random(5);
    std::vector<sim::Track> tracks;
    std::vector<float> radii;
    ShapeSet shapes;
    for (std::uint32_t i = 0; i < 16; ++i) {
        tracks.push_back(test::random_track(random, 1));
        radii.push_back(random.between(0.05f, 0.2f));
        test::add_moving_sphere(shapes, RigidMotion(tracks.back(), 0, 1), radii.back(), i);
    }
    const HybridStructure hybrid(shapes);
    int compared = 0;
    int differing = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Ray ray = test::random_ray_toward(random, 2, 1);
        Hit hit;
        const bool found = hybrid.closest_hit(ray, hit);
        ASSERT_EQ(found, hit.object != kNoObject);
        const Hit expected = nearest_sphere(tracks, radii, ray);
        if (hit.object != expected.object) {
            ++differing;  // rays that graze a sphere, or where two spheres intersect
            continue;
        }
        if (hit.object != kNoObject) {
            ++compared;
            // Float positions are accurate to 1e-7 m; at grazing incidence that is sqrt(2 R 1e-7)
            // along the ray.
            ASSERT_NEAR(hit.t, expected.t, 3e-4f);
        }
    }
    EXPECT_GT(compared, 10'000);
    EXPECT_LE(differing, 3);
}

TEST(HybridStructure, ZeroLengthShutter_AnyTimeGivesTheSameBits) {
    TestRandom random(6);
    ShapeSet shapes;
    for (std::uint32_t i = 0; i < 8; ++i) {
        const sim::Track track = test::random_track(random, 1);
        test::add_moving_sphere(shapes, RigidMotion(track, 0.4, 0.4), 0.2f, i);
    }
    const HybridStructure hybrid(shapes);
    for (int i = 0; i < 5'000; ++i) {
        Ray ray = test::random_ray(random, 2);
        Hit a;
        Hit b;
        const bool found = hybrid.closest_hit(ray, a);
        ray.time = random.unit();
        ASSERT_EQ(hybrid.closest_hit(ray, b), found);
        ASSERT_EQ(a.object, b.object);
        ASSERT_EQ(a.t, b.t);
    }
}

TEST(Structures, SameDistance_LowerObjectIsReported) {
    TestRandom random(7);
    RandomScene scene;
    // The same shapes twice, in different orders: spheres, boxes and rectangles.
    for (int i = 0; i < 12; ++i) {
        SphereSegment sphere;
        sphere.path.c[0] = V3f(static_cast<float>(i % 3), 0, 0);
        sphere.radius = 0.3f;
        sphere.object = static_cast<std::uint32_t>(11 - i);
        scene.shapes.add_sphere(sphere);
        const float x = static_cast<float>(i % 4);
        test::add_aligned_box(scene.shapes, V3f(x, 1, 0), V3f(x + 1, 2, 1),
                              static_cast<std::uint32_t>(30 - i));
    }
    const Structures structures(scene);
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = test::random_ray(random, 4);
        Hit hit;
        if (!structures.hybrid.closest_hit(ray, hit)) {
            continue;
        }
        ASSERT_TRUE(hit.object <= 2 || (hit.object >= 19 && hit.object <= 22)) << hit.object;
        Hit other;
        ASSERT_TRUE(structures.embree.closest_hit(ray, other));
        ASSERT_EQ(hit.object, other.object);
    }
}

TEST(Structures, NothingInTheScene_NoHit) {
    const RandomScene scene;
    const HybridStructure hybrid(scene.shapes);
    const EmbreeStructure embree(make_embree_device(), scene.shapes, {});
    for (const AccelerationStructure* structure :
         {static_cast<const AccelerationStructure*>(&hybrid),
          static_cast<const AccelerationStructure*>(&embree)}) {
        Hit hit;
        hit.u = 0.25f;
        EXPECT_FALSE(structure->closest_hit(Ray{}, hit));
        EXPECT_EQ(hit.u, 0.25f);
        EXPECT_FALSE(structure->any_hit(Ray{}));
    }
}

TEST(Structures, BadRays_MissInsteadOfAborting) {
    TestRandom random(8);
    RandomScene scene;
    scene.add_static(random, 2);
    scene.add_moving(random, 2);
    scene.add_static_meshes(random, 1);
    const Structures structures(scene);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<Ray> bad;
    for (const float value : {nan, kInfinity, -kInfinity}) {
        for (int axis = 0; axis < 3; ++axis) {
            Ray ray;
            ray.origin[axis] = value;
            bad.push_back(ray);
            ray = Ray{};
            ray.direction[axis] = value;
            bad.push_back(ray);
        }
        Ray ray;
        ray.time = value;
        bad.push_back(ray);
    }
    Ray ray;
    ray.direction = V3f(0, 0, 0);
    bad.push_back(ray);
    ray = Ray{};
    ray.t_max = nan;
    bad.push_back(ray);
    ray.t_max = -1;
    bad.push_back(ray);
    ray = Ray{};
    ray.t_min = 5;
    ray.t_max = 4;
    bad.push_back(ray);
    ray = Ray{};
    ray.t_min = nan;
    bad.push_back(ray);
    for (const Ray& r : bad) {
        Hit hit;
        EXPECT_FALSE(structures.hybrid.closest_hit(r, hit));
        EXPECT_FALSE(structures.embree.closest_hit(r, hit));
        EXPECT_FALSE(structures.hybrid.any_hit(r));
        EXPECT_FALSE(structures.tree.closest_hit(r, hit));
        EXPECT_FALSE(structures.tree.any_hit(r));
        EXPECT_FALSE(structures.embree.any_hit(r));
    }
}

TEST(Structures, OddIntervalsAndTimes_AreMadeSafe) {
    TestRandom random(9);
    RandomScene scene;
    scene.add_moving(random, 3);
    scene.add_static_meshes(random, 2);
    const Structures structures(scene);
    for (int i = 0; i < 5'000; ++i) {
        Ray odd = test::random_ray(random, 2);
        Ray plain = odd;
        odd.t_min = -1;
        odd.time = i % 3 == 0 ? -0.5f : 1.5f;
        plain.time = i % 3 == 0 ? 0.f : 1.f;
        Hit a;
        Hit b;
        Hit c;
        const bool found = structures.hybrid.closest_hit(plain, a);
        ASSERT_EQ(found, structures.hybrid.closest_hit(odd, b));
        ASSERT_EQ(found, structures.embree.closest_hit(odd, c));
        ASSERT_EQ(a.t, b.t);
        ASSERT_TRUE(is_same(a, c));
    }
}

}  // namespace
}  // namespace carom::render
