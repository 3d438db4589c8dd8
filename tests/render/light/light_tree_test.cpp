#include "render/light/light_tree.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "render/geometry/scalar_kernels.h"
#include "render/light/emissive_object.h"
#include "render/light/scalar_kernels.h"
#include "tests/render/scene_builder.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;
using test::TestRandom;

V3f point_in(TestRandom& random, float half) {
    return {random.between(-half, half), random.between(-half, half), random.between(-half, half)};
}
V3f direction_of(TestRandom& random) {
    return point_in(random, 1).normalized();
}

enum class Mix { round, flat, both };

/// Lights of all sizes and strengths, in clusters; some shine around, others to one side.
std::vector<LightBounds> lights_of(Mix mix, int count, TestRandom& random) {
    std::vector<LightBounds> lights;
    V3f middle(0, 0, 0);
    for (int i = 0; i < count; ++i) {
        if (i % 9 == 0) {
            middle = point_in(random, 2);
        }
        LightBounds light;
        const V3f centre = middle + point_in(random, 0.2f);
        const V3f half = V3f(1, 1, 1) * random.between(0.001f, 0.05f);
        light.box = {centre - half, centre + half};
        light.strength = std::pow(10.0f, random.between(-2, 1));
        if (mix == Mix::flat || (mix == Mix::both && i % 3 == 0)) {
            light.axis = direction_of(random);
            light.spread = random.between(0, 0.4f);
        }
        lights.push_back(light);
    }
    return lights;
}

double chance(const LightTreeData& tree, int light, const V3f& point, const V3f& normal) {
    return static_cast<double>(
        scalar::chance_in_tree<One>(tree, scalar::see_tree<One>(tree, point, normal), light));
}

// The light comes up as often as it should, and what is left of the number that chose it is
// uniform.
TEST(LightTree, Choices_HaveTheirProbabilities) {
    constexpr int kTests = 36;
    constexpr int kSamples = 40'000;
    const double level = test::sidak(0.01, 2 * kTests);
    TestRandom random(3);
    for (int k = 0; k < kTests; ++k) {
        const int count = std::array{1, 2, 7, 33, 300, 2000}[k % 6];
        const auto lights = lights_of(static_cast<Mix>(k % 3), count, random);
        const LightTree made(lights);
        const LightTreeData tree = made.data();
        const V3f point = point_in(random, 2.5f);
        const V3f normal = direction_of(random);
        const auto seen = scalar::see_tree<One>(tree, point, normal);
        std::vector<double> observed(lights.size() + 1), expected(lights.size() + 1);
        std::vector<double> rests(20), even(20);
        for (int i = 0; i < kSamples; ++i) {
            const auto choice = scalar::choose_in_tree<One>(tree, seen, random.unit());
            if (!(choice.probability > 0)) {
                observed.back() += 1;
                continue;
            }
            ASSERT_GE(choice.light, 0);
            ASSERT_LT(choice.light, count);
            ASSERT_NEAR(static_cast<double>(choice.probability),
                        chance(tree, choice.light, point, normal), 2e-4 * choice.probability);
            observed[static_cast<std::size_t>(choice.light)] += 1;
            if (choice.probability > 1e-4f) {  // else few bits are left
                rests[static_cast<std::size_t>(choice.u * 20)] += 1;
            }
        }
        double sum = 0;
        for (int light = 0; light < count; ++light) {
            const double probability = chance(tree, light, point, normal);
            expected[static_cast<std::size_t>(light)] = kSamples * probability;
            sum += probability;
        }
        EXPECT_LE(sum, 1.0001);
        expected.back() = kSamples * std::max(0.0, 1 - sum);
        EXPECT_GT(test::chi_square_p_value(observed, expected), level) << k;
        double rest = 0;
        for (const double one : rests) {
            rest += one;
        }
        even.assign(20, rest / 20);
        EXPECT_GT(test::chi_square_p_value(rests, even), level) << k;
    }
}

// A light is chosen with some probability wherever one of its points can light the surface.
TEST(LightTree, NoLightIsLost) {
    TestRandom random(7);
    for (int k = 0; k < 60; ++k) {
        const auto lights = lights_of(static_cast<Mix>(k % 3), 200, random);
        const LightTree made(lights);
        const LightTreeData tree = made.data();
        const V3f point = point_in(random, 2.5f);
        const V3f normal = direction_of(random);
        for (int light = 0; light < 200; ++light) {
            const LightBounds& bounds = lights[static_cast<std::size_t>(light)];
            bool arrives = false;
            for (int corner = 0; corner < 8; ++corner) {
                const V3f from((corner & 1) != 0 ? bounds.box.min.x : bounds.box.max.x,
                               (corner & 2) != 0 ? bounds.box.min.y : bounds.box.max.y,
                               (corner & 4) != 0 ? bounds.box.min.z : bounds.box.max.z);
                const V3f to_light = (from - point).normalized();
                const float angle = std::acos(-to_light.dot(bounds.axis));
                arrives = arrives || (to_light.dot(normal) > 1e-3f &&
                                      angle < bounds.spread + bounds.reach - 1e-3f);
            }
            if (arrives) {
                ASSERT_GT(chance(tree, light, point, normal), 0) << k << ", " << light;
            }
        }
    }
}

// Bounds of the union hold both, as narrow as a cone can be.
TEST(LightBounds, OfBoth_HoldAllDirectionsOfEach) {
    TestRandom random(11);
    for (int k = 0; k < 3000; ++k) {
        LightBounds a, b;
        a.strength = b.strength = 1;
        a.axis = direction_of(random);
        b.axis = k % 5 == 0 ? -a.axis : direction_of(random);
        a.spread = random.between(0, k % 2 == 0 ? 0.3f : kPi);
        b.spread = random.between(0, k % 3 == 0 ? 0.3f : kPi);
        a.box = {V3f(0, 0, 0), V3f(1, 1, 1)};
        b.box = {V3f(-1, 0.5f, 0), V3f(0, 2, 1)};
        const LightBounds both = a.with(b);
        EXPECT_EQ(both.strength, 2);
        EXPECT_EQ(both.box, Imath::Box3f(V3f(-1, 0, 0), V3f(1, 2, 1)));
        const double between =
            std::acos(std::clamp(static_cast<double>(a.axis.dot(b.axis)), -1., 1.));
        for (const LightBounds* one : {&a, &b}) {
            const double apart =
                std::acos(std::clamp(static_cast<double>(both.axis.dot(one->axis)), -1., 1.));
            ASSERT_GE(static_cast<double>(both.spread),
                      std::min(apart + static_cast<double>(one->spread), M_PI) - 2e-3);
        }
        const double least = 0.5 * (between + static_cast<double>(a.spread + b.spread));
        EXPECT_LE(static_cast<double>(both.spread),
                  std::min(M_PI, std::max({least, static_cast<double>(a.spread),
                                           static_cast<double>(b.spread)})) +
                      2e-3);
    }
}

// Wherever a moving object is while the shutter is open, its bounds hold it.
TEST(LightBounds, OfAMovingObject_HoldItAtAllTimes) {
    const std::vector<EmissiveSurface::Triangle> faces{
        {V3f(0.3f, 0, 0.1f), V3f(0.5f, 0, 0.1f), V3f(0.3f, 0.2f, 0.2f)},
        {V3f(0.3f, 0, 0.1f), V3f(0.3f, 0.2f, 0.2f), V3f(0.1f, 0.1f, 0.2f)}};
    TestRandom random(13);
    for (int k = 0; k < 50; ++k) {
        sim::Key open, close;
        open.time = 0;
        close.time = 0.02;
        open.position = Vec3(point_in(random, 1));
        close.position = open.position + Vec3(point_in(random, 0.1f));
        open.velocity_in = open.velocity_out = (close.position - open.position) / 0.02;
        close.velocity_in = close.velocity_out = open.velocity_in;
        const Vec3 spin = Vec3(point_in(random, k % 2 == 0 ? 5 : 60));
        open.angular_velocity_in = open.angular_velocity_out = spin;
        close.angular_velocity_in = close.angular_velocity_out = spin;
        const double angle = spin.length() * 0.02;
        close.orientation.setAxisAngle(spin.normalized(), angle);
        const auto motion =
            std::make_shared<RigidMotion>(sim::Track("flies", {open, close}), 0, 0.02);
        const EmissiveObject object =
            EmissiveObject(EmissiveSurface(faces, V3f(1, 1, 1))).moving(motion);
        const LightBounds bounds = object.bounds();
        for (int i = 0; i <= 20; ++i) {
            const float time = static_cast<float>(i) / 20;
            for (const auto& face : faces) {
                for (const V3f& corner : face) {
                    const V3f at =
                        motion->position(time) + rotate(motion->world_from_body(time), corner);
                    EXPECT_TRUE(bounds.box.intersects(at)) << k;
                }
                const V3f normal =
                    rotate(motion->world_from_body(time),
                           (face[1] - face[0]).cross(face[2] - face[0]).normalized());
                EXPECT_LE(std::acos(std::min(1.0f, normal.dot(bounds.axis))), bounds.spread + 1e-3f)
                    << k;
            }
        }
    }
}

}  // namespace
}  // namespace carom::render
