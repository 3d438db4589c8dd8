#include "render/light/emissive_surface.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/light/light_set.h"
#include "tests/render/direction_density.h"
#include "tests/render/light/light_samples.h"

namespace carom::render {
namespace {

/// Two triangles of a rectangle that faces down, and a third of another size next to it.
std::vector<EmissiveSurface::Triangle> triangles() {
    const V3f a(-0.4f, -0.3f, 1);
    const V3f b(-0.4f, 0.3f, 1);
    const V3f c(0.4f, 0.3f, 1);
    const V3f d(0.4f, -0.3f, 1);
    return {{a, b, c}, {a, c, d}, {c, V3f(0.9f, 0.3f, 0.6f), V3f(0.9f, -0.3f, 0.6f)}};
}

double area(const EmissiveSurface::Triangle& t) {
    return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).length();
}

TEST(EmissiveSurface, ARectangleOfTriangles_IsSampledLikeTheLamp) {
    auto flat = triangles();
    flat.pop_back();
    const EmissiveSurface surface(flat, V3f(3, 4, 5));
    RectangleLight lamp;
    lamp.centre = Vec3(0, 0, 1);
    lamp.edge_u = Vec3(0.4, 0, 0);
    lamp.edge_v = Vec3(0, 0.3, 0);
    const AreaLightConstants emitter = constants_of(lamp);
    const V3f point(0.2f, -0.6f, 0.1f);
    test::TestRandom random(11);
    double left = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto sample = light_sample(surface, point, V2f{random.unit(), random.unit()});
        ASSERT_TRUE(sample);
        const V3f place = point + sample->direction * sample->distance;
        ASSERT_NEAR(place.z, 1, 1e-5);
        ASSERT_LE(std::abs(place.x), 0.4001);
        ASSERT_LE(std::abs(place.y), 0.3001);
        left += place.x < -0.2f ? 1 : 0;
        const float expected = scalar::pdf_of_area_light<scalar::One>(
            emitter, point, sample->direction, sample->distance);
        ASSERT_NEAR(sample->pdf, expected, 1e-4f * expected);
    }
    EXPECT_NEAR(left / 20'000, 0.25, 0.015);
}

// Samples are distributed over the triangles by area, and uniformly within each.
TEST(EmissiveSurface, Places_AreEvenByArea) {
    const auto all = triangles();
    const EmissiveSurface surface(all, V3f(1, 1, 1));
    double total = 0;
    for (const auto& t : all) {
        total += area(t);
    }
    const V3f point(0.3f, 0, -2);
    test::TestRandom random(13);
    std::vector<double> observed(8, 0.0);
    std::vector<double> expected(8, 0.0);
    constexpr int kSamples = 100'000;
    for (int i = 0; i < kSamples; ++i) {
        const auto sample = light_sample(surface, point, V2f{random.unit(), random.unit()});
        ASSERT_TRUE(sample);
        const V3f place = point + sample->direction * sample->distance;
        if (place.x <= 0.4f) {
            const int column = std::min(3, static_cast<int>((place.x + 0.4f) / 0.2f));
            observed[static_cast<std::size_t>(column)] += 1;
        } else {
            const int column = std::min(3, static_cast<int>((place.x - 0.4f) / 0.125f));
            observed[static_cast<std::size_t>(4 + column)] += 1;
        }
    }
    const double flat = area(all[0]) + area(all[1]);
    for (std::size_t i = 0; i < 4; ++i) {
        expected[i] = kSamples * flat / total / 4;
        // A triangle with its tip at c: the fraction grows with the square of the distance from the
        // tip.
        const double low = static_cast<double>(i) / 4;
        expected[4 + i] =
            kSamples * (total - flat) / total * (std::pow(low + 0.25, 2) - std::pow(low, 2));
    }
    EXPECT_GT(test::chi_square_p_value(observed, expected), 0.001);
}

// Of many triangles a tree chooses; the density of each sample is that of its face.
TEST(EmissiveSurface, ManyTriangles_HaveTheDensityOfTheirSamples) {
    test::TestRandom random(19);
    std::vector<EmissiveSurface::Triangle> faces;
    for (int i = 0; i < 200; ++i) {
        const V3f at(random.between(-1, 1), random.between(-1, 1), random.between(0.5f, 1));
        const float size = random.between(0.01f, 0.1f);
        faces.push_back({at, at + V3f(0, size, 0), at + V3f(size, 0, random.between(0, 0.05f))});
    }
    faces[7] = {V3f(0, 0, 1), V3f(0, 0, 1), V3f(0, 0, 1)};  // without area
    const EmissiveSurface surface(faces, V3f(1, 1, 1));
    const EmissiveSurfaceConstants constants = surface.constants();
    ASSERT_TRUE(constants.tree.exists());
    const V3f point(0.2f, -0.3f, 0.1f);
    const V3f normal = V3f(0.1f, 0.2f, 1).normalized();
    const auto seen = scalar::see_tree<scalar::One>(constants.tree, point, normal);
    std::vector<double> observed(faces.size()), expected(faces.size());
    constexpr int kSamples = 100'000;
    int valid = 0;
    for (int i = 0; i < kSamples; ++i) {
        const V2f u{random.unit(), random.unit()};
        const auto sample = scalar::sample_surface<scalar::One>(constants, seen, point, u);
        if (!sample.valid) {
            continue;
        }
        valid += 1;
        const V3f place = point + sample.direction * sample.distance;
        for (std::size_t k = 0; k < faces.size(); ++k) {
            const auto& [a, b, c] = faces[k];
            const V3f n = (b - a).cross(c - a);
            // Barycentric coordinates of the place.
            const float v = (b - place).cross(c - place).dot(n) / n.dot(n);
            const float w = (c - place).cross(a - place).dot(n) / n.dot(n);
            if (!(std::abs((place - a).dot(n)) < 1e-5f * n.length()) || !(v > 1e-4f) ||
                !(w > 1e-4f) || !(v + w < 0.9999f)) {
                continue;
            }
            observed[k] += 1;
            const float cosine = -sample.direction.dot(n.normalized());
            const float density = scalar::pdf_of_surface<scalar::One>(
                constants, point, normal, static_cast<std::int32_t>(k), sample.distance, cosine);
            ASSERT_NEAR(sample.pdf, density, 1e-3f * density) << k;
        }
    }
    EXPECT_GT(valid, kSamples / 2);
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const auto& [a, b, c] = faces[k];
        const bool is_seen = (b - a).cross(c - a).dot(point - a) > 0;
        expected[k] = is_seen ? kSamples * static_cast<double>(scalar::chance_in_tree<scalar::One>(
                                               constants.tree, seen, static_cast<std::int32_t>(k)))
                              : 0;
    }
    EXPECT_EQ(expected[7], 0);
    EXPECT_GT(test::chi_square_p_value(observed, expected), 0.001);
}

TEST(EmissiveSurface, FromBehind_NothingArrives) {
    const EmissiveSurface surface(triangles(), V3f(1, 1, 1));
    test::TestRandom random(17);
    for (int i = 0; i < 100; ++i) {
        EXPECT_FALSE(light_sample(surface, V3f(0, 0, 5), V2f{random.unit(), random.unit()}));
    }
    EXPECT_EQ(scalar::pdf_of_surface<scalar::One>(surface.constants(), V3f(0, 0, 5), V3f(0, 0, -1),
                                                  0, 1, -0.5f),
              0);
}

TEST(EmissiveSurface, WithoutArea_IsDark) {
    EXPECT_TRUE(EmissiveSurface({}, V3f(1, 1, 1)).is_black());
    const V3f p(1, 2, 3);
    EXPECT_TRUE(EmissiveSurface({{p, p, p}}, V3f(1, 1, 1)).is_black());
    LightSet lights;
    lights.add(3, EmissiveObject(EmissiveSurface({}, V3f(1, 1, 1))));
    EXPECT_EQ(lights.lights().size(), 0U);
    lights.add(5, EmissiveObject(EmissiveSurface(triangles(), V3f(1, 1, 1))));
    EXPECT_EQ(lights.emissive_light(5), std::optional<std::size_t>(0));
    EXPECT_FALSE(lights.emissive_light(3));
    EXPECT_FALSE(lights.emissive_light(99));
    EXPECT_FALSE(lights.is_delta(0));
}

}  // namespace
}  // namespace carom::render
