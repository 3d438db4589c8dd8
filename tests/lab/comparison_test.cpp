#include "lab/comparison/comparison.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/lab/small_scene.h"

namespace carom::pipeline {
namespace {

using render::AccelerationKind;
using render::KindCounts;
using render::RayKind;
using ::testing::ElementsAre;

std::vector<std::string> names_of(const Comparison& comparison) {
    std::vector<std::string> names;
    for (const ComparedStructure& row : comparison.rows) {
        names.push_back(row.name);
    }
    return names;
}

std::string message_of(const std::string& structures) {
    try {
        (void)structures_from_text(structures);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Comparison, BruteForce_TestsEveryShapeForEveryRay) {
    const Comparison result =
        compared(small_scene("sphere_cube"),
                 options_of("brute_force", {ShadowRays::closest, ShadowRays::any}));
    ASSERT_EQ(result.rows.size(), 2u);
    EXPECT_EQ(result.shapes, 3375u);
    const render::TestCounts& all = result.rows[0].tests;
    EXPECT_EQ(all[RayKind::primary].rays, 256u);
    for (const KindCounts& kind : all.of) {
        EXPECT_EQ(kind.objects, 3375 * kind.rays);
        EXPECT_EQ(kind.boxes, 0u);
        EXPECT_EQ(kind.nodes, 0u);
    }
    const render::TestCounts& early = result.rows[1].tests;
    EXPECT_EQ(early[RayKind::primary].objects, all[RayKind::primary].objects);
    EXPECT_EQ(early[RayKind::shadow].rays, all[RayKind::shadow].rays);
    EXPECT_LT(early[RayKind::shadow].objects, all[RayKind::shadow].objects);
}

TEST(Comparison, Mirrors_AreCountedAsSecondaryRays) {
    LaboratoryScene scene = small_scene("cylinder_walls");
    const render::TestCounts rays = compared(scene, options_of("kdtree")).rays;
    EXPECT_EQ(rays[RayKind::primary].rays, 256u);
    EXPECT_GT(rays[RayKind::secondary].rays, 100u);
    scene.settings.distributed.recursion_limit = 0;
    EXPECT_EQ(compared(scene, options_of("kdtree")).rays[RayKind::secondary].rays, 0u);
}

/// Waves of paths, single paths, and the distributed integrator.
TEST(Comparison, PathsOfLight_HaveAllKindsOfRays) {
    LaboratoryScene scene = small_scene("stadium");
    scene.settings.integrator = render::IntegratorKind::path;
    scene.settings.samples = 4;
    scene.settings.max_bounces = 2;
    for (render::MaterialDescription& material : scene.scene.materials) {
        material.phong.reset();
    }
    const Comparison result = compared(scene, options_of("kdtree,bvh"));
    EXPECT_EQ(result.rays[RayKind::primary].rays, 1024u);
    EXPECT_GT(result.rays[RayKind::secondary].rays, 256u);
    EXPECT_GT(result.rays[RayKind::shadow].rays, 1024u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(result.rows[0].tests.of[i].rays, result.rows[1].tests.of[i].rays);
    }
}

TEST(Comparison, All_AreThereFromTheYardstickOn) {
    const Comparison result = compared(small_scene("full_view"), options_of("all"));
    EXPECT_THAT(names_of(result),
                ElementsAre("brute_force", "single_boxes", "grid", "octree", "octree_queue",
                            "octree_loose", "octree_enclosing", "octree_overlapping", "octree_cut",
                            "kdtree", "kdtree_median", "bsp", "rtree", "rtree_hilbert",
                            "rtree_cyclic", "kay_kajiya", "box_volumes", "sphere_volumes",
                            "oriented_box_volumes", "bvh", "wide_bvh", "hybrid", "embree"));
    EXPECT_TRUE(result.is_whole);
    for (const ComparedStructure& row : result.rows) {
        EXPECT_GT(row.cpu_seconds, 0) << row.name;
        EXPECT_GE(row.build_seconds, 0) << row.name;
        EXPECT_EQ(result.brute_force_row(row), &result.rows[0]);
        if (row.is_counted) {  // one shape, hit by every ray
            EXPECT_EQ(row.tests[RayKind::primary].objects, 256u) << row.name;
        }
    }
}

TEST(Comparison, BruteForceThatWouldTakeTooLong_IsComputed) {
    ComparisonOptions options = options_of("brute_force", {ShadowRays::any, ShadowRays::closest});
    const LaboratoryScene scene = small_scene("sphere_cube", 48, 36);
    const Comparison run = compared(scene, options);
    options.most_tests = 4e6;
    const Comparison computed = compared(scene, options);
    for (std::size_t row = 0; row < 2; ++row) {
        EXPECT_FALSE(run.rows[row].is_computed);
        EXPECT_TRUE(computed.rows[row].is_computed);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(computed.rows[row].tests.of[i].rays, run.rows[row].tests.of[i].rays);
        }
        EXPECT_EQ(computed.rows[row].tests[RayKind::primary].objects,
                  run.rows[row].tests[RayKind::primary].objects);
    }
    EXPECT_EQ(computed.rows[1].tests[RayKind::shadow].objects,
              run.rows[1].tests[RayKind::shadow].objects);
    const auto early = static_cast<double>(run.rows[0].tests[RayKind::shadow].objects);
    EXPECT_NEAR(static_cast<double>(computed.rows[0].tests[RayKind::shadow].objects), early,
                0.2 * early);
}

TEST(Comparison, SingleBoxesThatWouldTakeTooLong_AreComputed) {
    ComparisonOptions options = options_of("single_boxes,bvh");
    const LaboratoryScene scene = small_scene("sphere_cube", 48, 36);
    const Comparison run = compared(scene, options);
    options.most_tests = 4e6;
    const Comparison computed = compared(scene, options);
    EXPECT_FALSE(run.rows[0].is_computed);
    EXPECT_TRUE(computed.rows[0].is_computed);
    EXPECT_FALSE(computed.rows[1].is_computed);
    const KindCounts& all = run.rows[0].tests[RayKind::primary];
    const KindCounts& estimate = computed.rows[0].tests[RayKind::primary];
    EXPECT_EQ(all.boxes, 3375 * all.rays);
    EXPECT_EQ(estimate.boxes, all.boxes);
    EXPECT_NEAR(static_cast<double>(estimate.objects), static_cast<double>(all.objects),
                0.2 * static_cast<double>(all.objects));
    EXPECT_EQ(computed.rows[0].bytes, run.rows[0].bytes);
}

TEST(Comparison, Stopped_KeepsTheRowsThatAreThere) {
    std::stop_source stop;
    const auto progress = [&](std::string_view doing, double) {
        if (doing == "octree") {
            stop.request_stop();
        }
    };
    const Comparison result =
        compare_structures(small_scene("sphere_cube", 64, 48),
                           options_of("kdtree,rtree,octree,bvh"), progress, stop.get_token());
    EXPECT_THAT(names_of(result), ElementsAre("kdtree", "rtree"));
    EXPECT_FALSE(result.is_whole);
}

TEST(Comparison, Progress_NeverDecreasesAndEndsAtOne) {
    double last = 0;
    const auto progress = [&](std::string_view, double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
    };
    (void)compare_structures(small_scene("full_view"), options_of("brute_force,kdtree,embree"),
                             progress, {});
    EXPECT_GT(last, 0.6);
    EXPECT_LE(last, 1);
}

TEST(Comparison, WrongStructureNames_AreReported) {
    const std::string all =
        "use one of hybrid, embree, brute_force, single_boxes, grid, octree, octree_queue, "
        "octree_loose, octree_enclosing, octree_overlapping, octree_cut, kdtree, kdtree_median, "
        "bsp, rtree, rtree_hilbert, rtree_cyclic, kay_kajiya, box_volumes, sphere_volumes, "
        "oriented_box_volumes, bvh, wide_bvh, or all";
    EXPECT_EQ(message_of("kdtree,kd_tree"), "unknown structure 'kd_tree'; " + all);
    EXPECT_EQ(message_of("bvh,grid,bvh"), "the structure 'bvh' is named twice");
    EXPECT_EQ(message_of(""), "no structure is given; " + all);
}

TEST(Comparison, Kernels_GiveARowForEachStructureWithEachOfThem) {
    ComparisonOptions options = options_of("bvh,octree");
    options.kernels = {render::triangle::KernelName::wald, render::triangle::KernelName::shevtsov};
    const LaboratoryScene scene = small_scene("stadium");
    std::vector<double> reported;
    const Comparison result = compare_structures(
        scene, options, [&](std::string_view, double fraction) { reported.push_back(fraction); },
        {});
    EXPECT_TRUE(result.is_whole);
    EXPECT_THAT(names_of(result),
                ElementsAre("bvh, wald", "octree, wald", "bvh, shevtsov", "octree, shevtsov"));
    EXPECT_TRUE(std::ranges::is_sorted(reported));
    EXPECT_GT(result.rows[0].tests.total().objects, 0u);
    EXPECT_EQ(result.rows[0].tests[RayKind::primary].rays, 256u);
}

TEST(Comparison, KernelsOfStructures_AreForThoseThatTestTrianglesOneByOne) {
    const auto all = structures_with_kernels("all");
    EXPECT_EQ(all.size(), render::kAccelerationNames.size() - 3);
    EXPECT_THAT(structures_with_kernels("bvh"), ElementsAre(AccelerationKind::bvh));
    std::string message;
    try {
        (void)structures_with_kernels("bvh,hybrid");
    } catch (const Error& error) {
        message = error.what();
    }
    EXPECT_EQ(message, "the structure 'hybrid' has its own triangle test");
}

}  // namespace
}  // namespace carom::pipeline
