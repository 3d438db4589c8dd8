// Points on shapes have the same bits in vector lanes, on every instruction set, as one at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/render/geometry/shape_points_test.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/geometry/kernels-inl.h"

#ifndef CAROM_HITS_OF_LANES
#define CAROM_HITS_OF_LANES
namespace carom::test {

/// Hits of moving shapes, as [number][lane].
struct LaneHits {
    static constexpr int kMost = 16;
    static constexpr int kNumbers = 56;       // of one hit
    static constexpr int kPointNumbers = 22;  // of one point

    render::ShapeKind kind = render::ShapeKind::sphere;
    alignas(64) float hit[kNumbers][kMost];
    alignas(64) float point[kPointNumbers][kMost];
    int lanes = 0;
    const char* target = "";
};

}  // namespace carom::test
#endif

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#define CAROM_KERNEL_ATTRIBUTE HWY_ATTR
#include "tests/render/geometry/points_of_hits.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

HWY_ATTR void find_points(test::LaneHits& hits) {
    const hn::CappedTag<float, 16> d;
    points_of_hits<Lanes>(
        hits.kind, [&](int i) HWY_ATTR { return hn::Load(d, hits.hit[i]); },
        [&](int i, Lanes::Value x) HWY_ATTR { hn::Store(x, d, hits.point[i]); });
    hits.lanes = static_cast<int>(hn::Lanes(d));
    hits.target = hwy::TargetName(HWY_TARGET);
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "render/geometry/scalar_kernels.h"
#include "tests/render/every_target.h"
#include "tests/render/statistics.h"

namespace carom::render {

HWY_EXPORT(find_points);

namespace scalar {

#define CAROM_KERNEL inline
#define CAROM_KERNEL_ATTRIBUTE
#include "tests/render/geometry/points_of_hits.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace scalar

namespace {

/// A random hit: anywhere near the shape, because the kernels move points onto it.
void set_random_hit(test::LaneHits& hits, int lane, test::TestRandom& random) {
    for (auto& number : hits.hit) {
        number[lane] = random.between(-1.5f, 1.5f);
    }
    float length2 = 0;
    for (int i = 3; i < 7; ++i) {
        length2 += hits.hit[i][lane] * hits.hit[i][lane];
    }
    for (int i = 3; i < 7; ++i) {
        hits.hit[i][lane] /= std::sqrt(length2);  // the quaternion
    }
    for (int i = 50; i < 53; ++i) {
        hits.hit[i][lane] = random.between(0.1f, 2);  // half sizes
    }
    const bool is_cone = hits.kind == ShapeKind::frustum;
    hits.hit[53][lane] = is_cone ? 0.75f : random.between(0, 1);
    hits.hit[54][lane] = is_cone ? 0.25f : random.between(0, 1);
    hits.hit[55][lane] = random.between(0, 1);
    // Some rays along the axes, where faces and angles are on the edge.
    for (int i = 10; i < 13; ++i) {
        if (random.next() % 8 == 0) {
            hits.hit[i][lane] = 0;
        }
    }
}

TEST(ShapePoints, EveryInstructionSet_SameBitsAsOneAtATime) {
    test::TestRandom random(17);
    for (int kind = 0; kind < static_cast<int>(ShapeKind::mesh); ++kind) {
        for (int run = 0; run < 300; ++run) {
            test::LaneHits hits;
            hits.kind = static_cast<ShapeKind>(kind);
            for (int lane = 0; lane < test::LaneHits::kMost; ++lane) {
                set_random_hit(hits, lane, random);
            }
            test::for_each_instruction_set([&](const char*) {
                HWY_DYNAMIC_DISPATCH(find_points)(hits);
                for (int lane = 0; lane < hits.lanes; ++lane) {
                    scalar::points_of_hits<scalar::One>(
                        hits.kind, [&](int i) { return hits.hit[i][lane]; },
                        [&](int i, float x) {
                            ASSERT_EQ(std::bit_cast<std::uint32_t>(x),
                                      std::bit_cast<std::uint32_t>(hits.point[i][lane]))
                                << hits.target << ", shape " << kind << ", number " << i << ": "
                                << x << " and " << hits.point[i][lane];
                        });
                }
            });
        }
    }
}

}  // namespace
}  // namespace carom::render

#endif
