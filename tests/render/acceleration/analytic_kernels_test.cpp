#include "render/acceleration/analytic_kernels.h"

#include <string_view>

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include "render/acceleration/hybrid_structure.h"
#include "render/acceleration/vector_tier.h"
#include "tests/render/acceleration/random_shapes.h"

namespace carom::render {
namespace {

/// best_kernels() selects the kernels at every call; here it selects a lower target than the
/// processor has.
class OtherTier {
  public:
    explicit OtherTier(std::int64_t target) { choose(target); }
    ~OtherTier() { choose(0); }
    OtherTier(const OtherTier&) = delete;
    OtherTier& operator=(const OtherTier&) = delete;

  private:
    static void choose(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

TEST(AnalyticKernels, EveryTier_FindsTheSameShapes) {
    test::TestRandom random(1);
    test::RandomScene scene;
    scene.add_static(random, 9);
    scene.add_moving(random, 6);
    scene.shapes.moving.clear();
    const HybridStructure best(scene.shapes);
    // The lowest target is called SCALAR by g++ and EMU128 by clang.
    for (const std::int64_t target : {HWY_SSE4, HWY_SCALAR, HWY_EMU128}) {
        if ((HWY_TARGETS & target) == 0) {
            continue;
        }
        const OtherTier tier(target);
        EXPECT_EQ(simd_tier(), std::string_view(hwy::TargetName(target)));
        const HybridStructure other(scene.shapes);
        int differing = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Ray ray = test::random_ray_toward(random, 3, 2);
            Hit a;
            Hit b;
            const bool found = best.closest_hit(ray, a);
            ASSERT_EQ(best.any_hit(ray), found);
            ASSERT_EQ(other.any_hit(ray), other.closest_hit(ray, b));
            if (a.object != b.object) {
                ++differing;  // next to an edge or silhouette, where fused rounding decides
                continue;
            }
            if (found && a.t < 100) {  // beyond are rays that are almost in the plane
                ASSERT_NEAR(a.t, b.t, 1e-4f * (1 + a.t));
            }
        }
        EXPECT_LE(differing, 2);
    }
    EXPECT_EQ(simd_tier(), best_kernels().tier);
}

TEST(AnalyticKernels, NoTierAboveAvx2) {
    EXPECT_EQ(simd_tier().find("AVX3"), std::string::npos);
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
