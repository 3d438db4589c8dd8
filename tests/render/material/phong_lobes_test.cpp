// Phong surfaces in path tracing: energy, densities, directions.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/render/direction_density.h"
#include "tests/render/material/material_samples.h"

namespace carom::render {
namespace {

using test_materials::Bsdf;
using test_materials::BsdfValue;
using test_materials::Layers;

struct Named {
    std::string name;
    PhongMaterial material;
    bool from_behind = false;
};

std::vector<Named> materials() {
    std::vector<Named> list;
    PhongMaterial matt;
    matt.diffuse = Vec3(0.9, 0.6, 0.3);
    list.push_back({"matt", matt});
    PhongMaterial shiny = matt;
    shiny.diffuse = Vec3(0.3, 0.3, 0.3);
    shiny.specular = Vec3(0.7, 0.5, 0.2);
    shiny.shininess = 12;
    list.push_back({"shiny", shiny});
    PhongMaterial brushed = shiny;
    brushed.specular = Vec3(0, 0, 0);
    brushed.reflectance = Vec3(0.6, 0.6, 0.6);
    brushed.reflectance_spread = 0.3;
    list.push_back({"brushed", brushed});
    PhongMaterial frosted;
    frosted.diffuse = Vec3(0.1, 0.1, 0.1);
    frosted.transmittance = Vec3(0.7, 0.8, 0.9);
    frosted.transmittance_spread = 0.25;
    frosted.index = 1.5;
    list.push_back({"frosted", frosted});
    list.push_back({"frosted, from within", frosted, true});
    PhongMaterial too_much;
    too_much.diffuse = Vec3(1, 1, 1);
    too_much.specular = Vec3(1, 1, 1);
    too_much.shininess = 3;
    too_much.reflectance = Vec3(1, 1, 1);
    too_much.reflectance_spread = 0.5;
    too_much.transmittance = Vec3(1, 1, 1);
    too_much.transmittance_spread = 0.4;
    list.push_back({"too much of everything", too_much});
    PhongMaterial glass;
    glass.diffuse = Vec3(0, 0, 0);
    glass.reflectance = Vec3(0.1, 0.1, 0.1);
    glass.transmittance = Vec3(0.85, 0.85, 0.85);
    list.push_back({"glass", glass});
    list.push_back({"glass, from within", glass, true});
    return list;
}

V3f direction(double angle) {
    return V3f(static_cast<float>(std::sin(angle) * 0.6), static_cast<float>(std::sin(angle) * 0.8),
               static_cast<float>(std::cos(angle)));
}

/// In the surface's own axes, whose z is on the viewer's side.
Bsdf lobes(const PhongMaterial& description, bool from_behind, double angle) {
    ImageCache images;
    const Material material(description, images);
    const float side = from_behind ? -1.0f : 1.0f;
    return {material, V3f(0, 0, side), direction(angle)};
}

Bsdf lobes(const Named& named, double angle) {
    return lobes(named.material, named.from_behind, angle);
}

TEST(PhongLobes, EverySurface_GivesOffAtMostWhatItGets) {
    for (const Named& named : materials()) {
        for (const double angle : {0.05, 0.7, 1.2, 1.5}) {
            const Bsdf scattering = lobes(named, angle);
            test::TestRandom random(7);
            constexpr int kSamples = 200'000;
            V3f sum(0, 0, 0);
            for (int i = 0; i < kSamples; ++i) {
                const auto sample =
                    scattering.sample(Layers::all, V2f{random.unit(), random.unit()});
                if (!sample) {
                    continue;
                }
                if (sample->is_delta) {
                    sum += sample->weight;
                } else {
                    const BsdfValue value = scattering.evaluate(Layers::all, sample->direction);
                    ASSERT_GT(value.pdf, 0) << named.name;
                    sum += value.value / value.pdf;
                }
            }
            const V3f albedo = sum / kSamples;
            EXPECT_LE(std::max({albedo.x, albedo.y, albedo.z}), 1.005f)
                << named.name << " at " << angle;
            EXPECT_GT(albedo.z, 0.05f) << named.name << " at " << angle;
        }
    }
}

TEST(PhongLobes, Samples_FollowTheirDensity) {
    test::DensityTest setup;
    setup.tests = 12;
    for (const Named& named : materials()) {
        if (named.name.starts_with("glass")) {
            continue;  // single directions
        }
        for (const double angle : {0.3, 1.2}) {
            const Bsdf scattering = lobes(named, angle);
            SCOPED_TRACE(named.name);
            test::expect_direction_density(
                [&](const V3f& u) -> std::optional<V3f> {
                    const auto sample = scattering.sample(Layers::all, V2f(u.x, u.y));
                    const bool is_counted = sample && !sample->is_delta;  // total reflection
                    return is_counted ? std::optional(sample->direction) : std::nullopt;
                },
                [&](const V3f& wi) {
                    return static_cast<double>(scattering.evaluate(Layers::all, wi).pdf);
                },
                V3f(0, 0, 1), 2, setup);
        }
    }
}

TEST(PhongLobes, DiffuseTerm_IsLamberts) {
    const Named matt = materials()[0];
    const BsdfValue value = lobes(matt, 0.4).evaluate(Layers::all, direction(0.9));
    EXPECT_NEAR(value.value.x, 0.9 * std::cos(0.9) / M_PI, 1e-6);
    EXPECT_NEAR(value.pdf, std::cos(0.9) / M_PI, 1e-6);
}

/// The light reflected in a room with radiance 1 everywhere, per channel.
V3f albedo(const Bsdf& scattering) {
    test::TestRandom random(7);
    constexpr int kSamples = 200'000;
    V3f sum(0, 0, 0);
    for (int i = 0; i < kSamples; ++i) {
        const auto sample = scattering.sample(Layers::all, V2f{random.unit(), random.unit()});
        if (sample && !sample->is_delta) {
            const BsdfValue value = scattering.evaluate(Layers::all, sample->direction);
            sum += value.value / value.pdf;
        }
    }
    return sum / kSamples;
}

// Highlights, gloss and frosting have the albedo in their description at every viewing angle, also
// where a part of the lobe would be below the surface.
TEST(PhongLobes, EveryLobe_KeepsItsAlbedoAtEveryAngle) {
    std::vector<std::pair<const char*, PhongMaterial>> list;
    for (const double shininess : {1.0, 20.0, 400.0}) {
        PhongMaterial material;
        material.specular = Vec3(0.8, 0.8, 0.8);
        material.shininess = shininess;
        list.emplace_back("highlight", material);
    }
    for (const double spread : {0.05, 0.3, 0.8}) {
        PhongMaterial glossy, frosted;
        glossy.reflectance = Vec3(0.8, 0.8, 0.8);
        glossy.reflectance_spread = spread;
        list.emplace_back("glossy", glossy);
        frosted.transmittance = Vec3(0.8, 0.8, 0.8);
        frosted.transmittance_spread = spread;
        frosted.index = 1.3;
        list.emplace_back("frosted", frosted);
    }
    for (auto& [name, material] : list) {
        material.diffuse = Vec3(0, 0, 0);
        for (const double angle : {0.05, 0.7, 1.2, 1.5}) {
            const Bsdf scattering = lobes(material, false, angle);
            EXPECT_NEAR(albedo(scattering).x, 0.8, 0.006)
                << name << " of " << material.shininess << ", "
                << material.reflectance_spread + material.transmittance_spread << " at " << angle;
        }
    }
}

TEST(PhongLobes, HighlightSeenStraightOn_IsThatOfLafortuneAndWillems) {
    const Named shiny = materials()[1];  // n = 12, k_s 0.7
    for (const double angle : {0.1, 0.4, 0.9}) {
        const double c = std::cos(angle);
        const double diffuse = 0.3 * c / M_PI;
        const double highlight = 0.7 * 14 / (2 * M_PI) * std::pow(c, 12) * c;
        const BsdfValue value = lobes(shiny, 0).evaluate(Layers::all, direction(angle));
        EXPECT_NEAR(value.value.x, diffuse + highlight, 1e-4 * (diffuse + highlight)) << angle;
    }
}

// A spread lobe has the same mean square of the angle as the classic model's rays.
TEST(PhongLobes, Spread_IsKeptAsMeanSquareOfTheAngle) {
    PhongMaterial mirror;
    mirror.diffuse = Vec3(0, 0, 0);
    mirror.reflectance = Vec3(1, 1, 1);
    mirror.reflectance_spread = 0.1;
    const Bsdf scattering = lobes(mirror, false, 0);
    test::TestRandom random(3);
    double squares = 0;
    constexpr int kSamples = 50'000;
    for (int i = 0; i < kSamples; ++i) {
        const auto sample = scattering.sample(Layers::all, V2f{random.unit(), random.unit()});
        ASSERT_TRUE(sample);
        const double angle = std::acos(std::min(1.0f, sample->direction.z));
        squares += angle * angle;
    }
    EXPECT_NEAR(std::sqrt(squares / kSamples), 0.1, 0.002);
}

TEST(PhongLobes, ClearGlass_BendsBySnellAndReflectsTotallyWithin) {
    const Named glass = materials()[6];
    const Named within = materials()[7];
    const auto directions = [](const Bsdf& scattering) {
        std::vector<V3f> found;
        test::TestRandom random(5);
        for (int i = 0; i < 200; ++i) {
            const auto sample = scattering.sample(Layers::all, V2f{random.unit(), random.unit()});
            if (sample && (found.empty() || (found.back() - sample->direction).length() > 1e-5f)) {
                found.push_back(sample->direction);
            }
        }
        return found;
    };
    bool bends = false;
    for (const V3f& wi : directions(lobes(glass, 0.6))) {
        const double sine = std::hypot(wi.x, wi.y);
        if (wi.z < 0) {
            bends = true;
            EXPECT_NEAR(sine, std::sin(0.6) / 1.5, 1e-5);
            EXPECT_LT(wi.x, 0);
        } else {
            EXPECT_NEAR(sine, std::sin(0.6), 1e-5);
        }
    }
    EXPECT_TRUE(bends);
    for (const V3f& wi : directions(lobes(within, 0.9))) {
        EXPECT_GT(wi.z, 0);  // beyond the critical angle of 0.73
    }
    EXPECT_FALSE(lobes(within, 0.9).transmits());
    EXPECT_FALSE(lobes(glass, 0.6).can_evaluate(Layers::all));
}

}  // namespace
}  // namespace carom::render
