// Batches of rays against a tree of triangles: the same bits as for single rays, by brute force,
// and on every instruction set.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include "render/acceleration/hybrid_structure.h"
#include "render/acceleration/triangle_scene.h"
#include "render/triangle/moller_trumbore.h"
#include "tests/render/acceleration/owned_batch.h"
#include "tests/render/acceleration/random_shapes.h"

namespace carom::render {
namespace {

using test::OwnedBatch;
using test::TestRandom;

/// Hits of a batch, as bits.
struct Answers {
    std::vector<float> t, u, v;
    std::vector<std::int32_t> object, primitive;
    std::vector<float> t_max;  // of the occlusion query

    bool operator==(const Answers&) const = default;
};

Answers ask(const TriangleScene& scene, const std::vector<Ray>& rays) {
    OwnedBatch batch(rays);
    const std::size_t room = rays.size() + RayBatch::kBeyond;
    Answers answers;
    answers.t = batch.values[7];
    answers.u.assign(room, 0);
    answers.v.assign(room, 0);
    answers.object.assign(room, -1);
    answers.primitive.assign(room, 0);
    scene.closest_hits(batch.rays(),
                       {answers.t.data(), answers.object.data(), answers.primitive.data(),
                        answers.u.data(), answers.v.data()});
    answers.t_max = batch.values[7];
    scene.test_occlusion(batch.rays(), answers.t_max.data());
    for (std::vector<float>* numbers : {&answers.t, &answers.u, &answers.v, &answers.t_max}) {
        numbers->resize(rays.size());
    }
    answers.object.resize(rays.size());
    answers.primitive.resize(rays.size());
    return answers;
}

/// Balls, a stack of coinciding sheets, long thin triangles and degenerate ones.
struct Meshes {
    Meshes() {
        TestRandom random(5);
        for (int i = 0; i < 5; ++i) {
            meshes.push_back(test::bumpy_ball(0.4f, 14));
            const V3f place = test::random_point(random, 1);
            for (V3f& vertex : meshes.back().vertices) {
                vertex += place;
            }
        }
        meshes.push_back(meshes.front());  // a second object in the same place
        TriangleMesh slivers;
        for (std::uint32_t i = 0; i < 200; ++i) {
            const float y = 0.01f * static_cast<float>(i) - 1;
            slivers.vertices.emplace_back(-1.5f, y, -0.7f);
            slivers.vertices.emplace_back(1.5f, y, -0.7f);
            slivers.vertices.emplace_back(1.5f, y + 0.01f, -0.7f);
            slivers.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
            slivers.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});  // the same once more
            slivers.triangles.push_back({3 * i, 3 * i, 3 * i + 1});      // without area
        }
        meshes.push_back(slivers);
        for (std::uint32_t i = 0; i < meshes.size(); ++i) {
            entries.push_back({&meshes[i], 10 - i});
        }
    }
    std::vector<TriangleMesh> meshes;
    std::vector<MeshEntry> entries;
};

/// Random rays, of which some are short or have no length, run along axes, begin on a vertex or
/// aim at one, or contain numbers that are not finite.
std::vector<Ray> mixed_rays(const Meshes& meshes, int count, std::uint64_t seed) {
    TestRandom random(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        // Some rays in a row have nearly the same origin, as in a picture.
        Ray ray = test::random_ray_toward(random, i % 3 == 0 ? 3 : 0.5f, 1.2f);
        if (i % 32 < 16 && i > 0) {
            ray.origin = rays.back().origin + V3f(0.001f, 0, 0);
        }
        ray.t_max = i % 4 == 0 ? random.between(0.1f, 3) : kInfinity;
        const TriangleMesh& mesh = meshes.meshes[random.next() % meshes.meshes.size()];
        const V3f& vertex = mesh.vertices[random.next() % mesh.vertices.size()];
        switch (i % 19) {
            case 3:
                ray.direction = V3f(0, 0, i % 2 == 0 ? 1.f : -1.f);
                break;
            case 5:
                ray.direction = V3f(-0.f, -1, 0);
                ray.origin.z = -0.7f;  // in the plane of the sheet
                break;
            case 7:
                ray.origin = vertex;
                break;
            case 9:
                ray.direction = (vertex - ray.origin).normalized();
                break;
            case 11:
                ray.t_max = i % 2 == 0 ? 0.f : -1.f;
                break;
            case 13:
                ray.direction.y = std::numeric_limits<float>::quiet_NaN();
                break;
            case 15:
                ray.origin.x = kInfinity;
                break;
            case 17:
                ray.origin *= 1000;
                ray.direction = (vertex - ray.origin).normalized();
                break;
            default:
                break;
        }
        rays.push_back(ray);
    }
    return rays;
}

bool can_hit(const Ray& ray) {
    return std::isfinite(ray.origin.x) && std::isfinite(ray.direction.y) && ray.t_max > 0;
}

TEST(TriangleBatch, MixedRays_SameBitsAsAlone) {
    const Meshes meshes;
    const TriangleScene scene(meshes.entries);
    const std::vector<Ray> rays = mixed_rays(meshes, 40'000, 1);
    const Answers together = ask(scene, rays);
    int hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Hit alone;
        const bool found = can_hit(rays[i]) && scene.closest_hit(rays[i], alone);
        ASSERT_EQ(together.object[i] >= 0, found) << i;
        if (!found) {
            ASSERT_EQ(together.t[i], rays[i].t_max) << i;
            ASSERT_EQ(together.t_max[i], rays[i].t_max) << i;
            continue;
        }
        ++hits;
        ASSERT_EQ(together.t[i], alone.t) << i;
        ASSERT_EQ(static_cast<std::uint32_t>(together.object[i]), alone.object) << i;
        ASSERT_EQ(static_cast<std::uint32_t>(together.primitive[i]), alone.primitive) << i;
        ASSERT_EQ(together.u[i], alone.u) << i;
        ASSERT_EQ(together.v[i], alone.v) << i;
        ASSERT_EQ(together.t_max[i], 0) << i;
        ASSERT_TRUE(scene.any_hit(rays[i])) << i;
    }
    EXPECT_GT(hits, 10'000);
}

TEST(TriangleBatch, OtherNeighbours_SameBits) {
    const Meshes meshes;
    const TriangleScene scene(meshes.entries);
    std::vector<Ray> rays = mixed_rays(meshes, 3'000, 2);
    const Answers forward = ask(scene, rays);
    std::reverse(rays.begin(), rays.end());
    Answers backward = ask(scene, rays);
    std::reverse(backward.t.begin(), backward.t.end());
    std::reverse(backward.object.begin(), backward.object.end());
    std::reverse(backward.primitive.begin(), backward.primitive.end());
    std::reverse(backward.u.begin(), backward.u.end());
    std::reverse(backward.v.begin(), backward.v.end());
    std::reverse(backward.t_max.begin(), backward.t_max.end());
    EXPECT_TRUE(forward == backward);
    std::reverse(rays.begin(), rays.end());
    for (const std::size_t count : {1u, 2u, 7u, 15u, 16u, 17u, 33u}) {
        const std::vector<Ray> few(rays.begin(), rays.begin() + static_cast<std::ptrdiff_t>(count));
        const Answers answers = ask(scene, few);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(answers.t[i], forward.t[i]);
            EXPECT_EQ(answers.object[i], forward.object[i]);
            EXPECT_EQ(answers.t_max[i], forward.t_max[i]);
        }
    }
}

/// Calls `use` with each instruction set that this machine has.
void for_every_target(const std::function<void()>& use) {
    const auto choose = [](std::int64_t targets) {
        hwy::SetSupportedTargetsForTest(targets);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    };
    const std::int64_t supported = hwy::SupportedTargets();
    for (int bit = 0; bit < 63; ++bit) {
        const std::int64_t target = std::int64_t{1} << bit;
        const bool is_lowest = target == HWY_STATIC_TARGET;  // always there
        if ((HWY_TARGETS & target) != 0 && ((supported & target) != 0 || is_lowest)) {
            choose(target);
            use();
        }
    }
    choose(0);
}

TEST(TriangleBatch, EveryInstructionSet_SameBits) {
    const Meshes meshes;
    const std::vector<Ray> rays = mixed_rays(meshes, 20'000, 3);
    const Answers expected = ask(TriangleScene(meshes.entries), rays);
    std::set<const TriangleBatchKernels*> kernels;
    for_every_target([&] {
        kernels.insert(&best_triangle_batch_kernels());
        EXPECT_TRUE(ask(TriangleScene(meshes.entries), rays) == expected);
    });
    EXPECT_GE(kernels.size(), 2u);
}

TEST(InstanceBatch, EveryInstructionSet_SameBits) {
    TestRandom random(12);
    test::RandomScene scene;
    scene.add_instances(random, 40);
    std::vector<Ray> rays;
    for (int i = 0; i < 5'000; ++i) {
        rays.push_back(test::random_ray_toward(random, 3, 2));
    }
    OwnedBatch batch(rays);
    const auto bits = [&] {
        std::vector<Hit> hits(rays.size());
        HybridStructure(scene.shapes).closest_hits(batch.rays(), hits.data());
        std::vector<std::array<float, 5>> numbers;
        for (const Hit& hit : hits) {
            numbers.push_back({hit.t, std::bit_cast<float>(hit.object),
                               std::bit_cast<float>(hit.primitive), hit.u, hit.v});
        }
        return numbers;
    };
    const auto expected = bits();
    EXPECT_GT(std::count_if(expected.begin(), expected.end(),
                            [](const auto& hit) { return hit[0] < kInfinity; }),
              500);
    for_every_target([&] {
        const auto now = bits();
        EXPECT_EQ(std::memcmp(now.data(), expected.data(), now.size() * sizeof(now[0])), 0);
    });
}

TEST(TriangleBatch, ManyRays_AgreeWithALoopOverTriangles) {
    const Meshes meshes;
    const TriangleScene scene(meshes.entries);
    const std::vector<Ray> rays = mixed_rays(meshes, 3'000, 4);
    const Answers answers = ask(scene, rays);
    int differing = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Hit nearest;
        nearest.t = rays[i].t_max;
        // From kilometres away, the test of a triangle that is seen edge-on may be wrong by metres;
        // the tree keeps distances within boxes.
        const bool is_far = rays[i].origin.length() > 50;
        if (!can_hit(rays[i]) || is_far) {
            continue;
        }
        for (const MeshEntry& entry : meshes.entries) {
            for (std::uint32_t k = 0; k < entry.mesh->triangles.size(); ++k) {
                const auto [a, b, c] = entry.mesh->triangles[k];
                const std::vector<V3f>& at = entry.mesh->vertices;
                const auto hit = triangle_hit({rays[i].origin, rays[i].direction, 0, nearest.t + 1},
                                              at[a], at[b], at[c]);
                const bool is_lower = hit && hit->t == nearest.t && nearest.object != kNoObject &&
                                      (entry.object < nearest.object ||
                                       (entry.object == nearest.object && k < nearest.primitive));
                if (hit && (hit->t < nearest.t || is_lower)) {
                    nearest.t = hit->t;
                    nearest.object = entry.object;
                    nearest.primitive = k;
                }
            }
        }
        const bool is_same = static_cast<std::uint32_t>(answers.object[i]) == nearest.object &&
                             static_cast<std::uint32_t>(answers.primitive[i]) ==
                                 (nearest.object == kNoObject ? 0 : nearest.primitive) &&
                             answers.t[i] == nearest.t;
        differing += is_same ? 0 : 1;
    }
    EXPECT_EQ(differing, 0);
}

/// A shade around a lamp: a square trough that opens downwards, of walls with two sides.
TriangleMesh make_shade() {
    TriangleMesh mesh;
    for (const float apart : {0.f, 0.01f}) {
        for (const V3f& ring : {V3f(0.5f, 0.2f, 0), V3f(0.4f, 0.1f, 0.3f)}) {
            for (const auto& [x, y] :
                 {std::pair(-1.f, -1.f), {1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}}) {
                mesh.vertices.emplace_back(x * (ring.x + apart), y * (ring.y + apart),
                                           ring.z + apart);
            }
        }
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size() - 8);
        for (std::uint32_t k = 0; k < 4; ++k) {
            const std::uint32_t a = first + k;
            const std::uint32_t b = first + (k + 1) % 4;
            mesh.triangles.push_back({a, b, b + 4});
            mesh.triangles.push_back({a, b + 4, a + 4});
        }
        mesh.triangles.push_back({first + 4, first + 5, first + 6});
        mesh.triangles.push_back({first + 4, first + 6, first + 7});
    }
    return mesh;
}

/// Segments from below to points in and around a shade, many of which end close to a wall.
TEST(TriangleBatch, RaysTowardsALampInItsShade_AgreeWithALoopOverTriangles) {
    const TriangleMesh mesh = make_shade();
    const MeshEntry entry{&mesh, 3};
    const TriangleScene scene(std::span(&entry, 1));
    TestRandom random(8);
    std::vector<Ray> rays;
    for (int i = 0; i < 20'000; ++i) {
        const V3f end(random.between(-0.55f, 0.55f), random.between(-0.25f, 0.25f),
                      random.between(0, 0.32f));
        Ray ray;
        ray.origin = V3f(random.between(-1, 1), random.between(-1, 1), random.between(-1, 0.1f));
        ray.direction = (end - ray.origin).normalized();
        ray.t_max = (end - ray.origin).length();
        rays.push_back(ray);
    }
    const Answers answers = ask(scene, rays);
    int hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        float nearest = rays[i].t_max;
        for (const auto& [a, b, c] : mesh.triangles) {
            const auto hit = triangle_hit({rays[i].origin, rays[i].direction, 0, nearest},
                                          mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
            nearest = hit ? hit->t : nearest;
        }
        const bool is_hit = nearest < rays[i].t_max;
        hits += is_hit ? 1 : 0;
        ASSERT_EQ(answers.t[i], nearest) << i;
        ASSERT_EQ(answers.t_max[i], is_hit ? 0 : rays[i].t_max) << i;
    }
    EXPECT_GT(hits, 5'000);
    EXPECT_LT(hits, 15'000);
}

TEST(TriangleBatch, SameDistance_LowerObjectThenLowerTriangle) {
    const Meshes meshes;
    const TriangleScene scene(meshes.entries);
    TestRandom random(6);
    std::vector<Ray> rays;
    for (int i = 0; i < 2'000; ++i) {
        Ray ray;
        ray.origin = V3f(random.between(-1.4f, 1.4f), random.between(-1, 1), -0.71f);
        ray.direction = V3f(0, 0, 1);
        ray.t_max = 0.02f;
        rays.push_back(ray);
    }
    Answers answers = ask(scene, rays);
    int hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (answers.object[i] == 4) {
            EXPECT_EQ(answers.primitive[i] % 3, 0) << i;
            ++hits;
        }
        EXPECT_NE(answers.object[i], 10) << i;  // the first ball, covered by the second, object 5
    }
    EXPECT_GT(hits, 500);
}

/// Rays from inside a closed mesh towards its edges and corners, and towards any of its points.
std::vector<Ray> rays_from_inside(const TriangleMesh& mesh, const V3f& middle, int count) {
    TestRandom random(7);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const auto& triangle = mesh.triangles[random.next() % mesh.triangles.size()];
        const auto corner = [&](int k) {
            return mesh.vertices[triangle[static_cast<std::size_t>((i + k) % 3)]];
        };
        const float along = i % 7 == 0 ? 0 : random.unit();
        const float beside = i % 5 == 0 ? random.unit() : 0;
        const V3f target =
            corner(0) + along * (corner(1) - corner(0)) + beside * (corner(2) - corner(0));
        Ray ray;
        ray.origin = middle + test::random_point(random, 0.2f);
        ray.direction = (target - ray.origin).normalized();
        rays.push_back(ray);
    }
    return rays;
}

TEST(TriangleBatch, RaysTowardsSharedEdges_NoneSlipsThrough) {
    for (const int rings : {5, 40, 300}) {
        const TriangleMesh mesh = test::bumpy_ball(1, rings);
        const MeshEntry entry{&mesh, 0};
        const TriangleScene scene(std::span(&entry, 1));
        const std::vector<Ray> rays = rays_from_inside(mesh, V3f(0), 300'000);
        const Answers answers = ask(scene, rays);
        EXPECT_EQ(std::count(answers.object.begin(), answers.object.end(), -1), 0) << rings;
        EXPECT_EQ(std::count_if(answers.t_max.begin(), answers.t_max.end(),
                                [](float t) { return t > 0; }),
                  0)
            << rings;
        // Alone, too.
        for (std::size_t i = 0; i < rays.size(); i += 20) {
            Hit hit;
            ASSERT_TRUE(scene.closest_hit(rays[i], hit));
            ASSERT_EQ(hit.t, answers.t[i]);
            ASSERT_TRUE(scene.any_hit(rays[i]));
        }
    }
}

// The map to an instance's axes rounds a ray once for all triangles.
TEST(InstanceBatch, RaysTowardsSharedEdges_NoneSlipsThrough) {
    const TriangleMesh mesh = test::bumpy_ball(300, 40);
    const MeshEntry entry{&mesh, 0};
    Mat44 map;
    map.setScale(Vec3(0.003, 0.004, 0.0035));
    map[3][0] = 5;
    MeshInstance instance{
        std::make_shared<const TriangleTree>(make_triangle_tree(std::span(&entry, 1))),
        Affine::narrowed(map.inverse()), nullptr, Imath::Box3f(V3f(3, -2, -2), V3f(7, 2, 2)), 0};
    const InstanceTree tree = make_instance_tree({instance});
    TriangleMesh placed = mesh;
    for (V3f& vertex : placed.vertices) {
        vertex = Affine::narrowed(map).point(vertex);
    }
    const std::vector<Ray> rays = rays_from_inside(placed, V3f(5, 0, 0), 100'000);
    int misses = 0;
    for (const Ray& ray : rays) {
        Hit hit;
        misses += best_instance_batch_kernels().closest_of_ray(tree, ray, hit) ? 0 : 1;
    }
    EXPECT_EQ(misses, 0);
}

}  // namespace
}  // namespace carom::render
