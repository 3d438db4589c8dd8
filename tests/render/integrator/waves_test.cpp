// The results of waves depend neither on the width of the vectors nor on the samples in a wave.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "render/integrator/path_integrator.h"
#include "tests/render/integrator/every_shape.h"
#include "tests/render/integrator/integrator_scene.h"

namespace carom::test {
namespace {

using render::CameraBatch;
using render::CameraRun;
using render::RadianceSample;
using render::StandardMaterial;

constexpr int kSide = 24;  // pixels
constexpr int kSamples = 4;
constexpr double kShutter = 0.02;   // s
constexpr float kRounding = 1e-6f;  // a few units in the last place
constexpr std::int64_t kAllButOneLane = ~std::int64_t{HWY_SCALAR | HWY_EMU128};

struct WaveCase {
    std::string name;
    std::function<void(SceneBuilder&)> furnish;
    render::PathSettings path{};
};

StandardMaterial coated(double roughness) {
    StandardMaterial material;
    material.base = Vec3(0.6, 0.1, 0.1);
    material.coat = {1, 1.5, roughness};
    return material;
}

/// A table with balls at rest and moving, one of them deflected by an impact.
void add_table(SceneBuilder& builder) {
    builder.diffuse("cloth", 0.3).material("ball", coated(0));
    builder.object("table", render::BoxShape{Vec3(2, 2, 0.2)}, Vec3(0, 0, -0.1), "cloth");
    builder.object("rail", render::BoxShape{Vec3(0.2, 2, 0.3)}, Vec3(1, 0, 0), "cloth");
    builder.sphere("still", 0.1, Vec3(0.2, 0.3, 0.1), "ball");
    builder.sphere("resting", 0.1, Vec3(0, 0, 0), "ball", "resting");
    builder.sphere("moving", 0.1, Vec3(0, 0, 0), "ball", "moving");
}

std::vector<sim::Track> table_tracks() {
    std::vector<sim::Track> tracks = tracks_of_every_shape(kShutter);
    tracks.push_back(resting_track("resting", Vec3(-0.3, 0.2, 0.1)));
    tracks.push_back(
        straight_track("moving", Vec3(-0.1, -0.2, 0.1), Vec3(0.2, -0.1, 0.1), 0, kShutter));
    return tracks;
}

void add_lights(SceneBuilder& builder) {
    builder.lamp(Vec3(0, 0, 1.5), 0.4, 0.2, 6).bulb(Vec3(-0.6, 0.5, 0.8), 0.04, 40);
    builder.environment(0.2);
}

/// A satin highlight, a mirror, half of a rough metal, and a highlight under a smooth coat.
void add_metals(SceneBuilder& builder) {
    StandardMaterial leather;
    leather.base = Vec3(0.3, 0.2, 0.1);
    leather.specular = 0.7;
    leather.roughness = 0.55;
    StandardMaterial mirror;
    mirror.metal = 1;
    mirror.roughness = 0;
    StandardMaterial alloy;
    alloy.metal = 0.5;
    alloy.roughness = 0.4;
    alloy.specular = 0.5;
    StandardMaterial polished = coated(0);
    polished.specular = 1;
    polished.roughness = 0.3;
    builder.material("leather", leather).material("mirror", mirror);
    builder.material("alloy", alloy).material("polished", polished);
    builder.sphere("e", 0.12, Vec3(0.5, 0.1, 0.12), "leather");
    builder.sphere("f", 0.12, Vec3(-0.5, -0.3, 0.12), "mirror");
    builder.sphere("g", 0.12, Vec3(0.4, -0.4, 0.12), "alloy");
    builder.sphere("h", 0.12, Vec3(-0.5, 0.5, 0.12), "polished");
}

/// Rough coats, over a base and over nothing.
void add_lacquer(SceneBuilder& builder) {
    StandardMaterial black = coated(0.4);
    black.base = Vec3(0, 0, 0);
    StandardMaterial satin = coated(0.25);
    satin.specular = 0.5;
    satin.roughness = 0.6;
    satin.sheen = 0.2;
    builder.material("lacquer", coated(0.2)).material("black", black).material("satin", satin);
    builder.sphere("i", 0.12, Vec3(0.5, 0.1, 0.12), "lacquer");
    builder.sphere("j", 0.12, Vec3(-0.5, -0.3, 0.12), "black");
    builder.object("k", render::BoxShape{Vec3(0.3, 0.3, 0.2)}, Vec3(0.4, -0.4, 0.1), "satin");
}

/// A ball with a stripe and a number that moves, and a bent sheet with a pattern.
void add_paint(SceneBuilder& builder) {
    StandardMaterial paint = coated(0);
    paint.base = render::BallTexture{.colour = Vec3(0.1, 0.3, 0.7), .striped = true, .number = 9};
    StandardMaterial wood = coated(0.3);
    wood.base = render::WoodTexture{};
    builder.material("paint", paint).material("wood", wood);
    builder.sphere("nine", 0.13, Vec3(0, 0, 0), "paint", "moving");
    render::MeshShape sheet;
    sheet.vertices = {Vec3(-0.7, -0.6, 0.02), Vec3(-0.3, -0.6, 0.1), Vec3(-0.3, 0, 0.1),
                      Vec3(-0.7, 0, 0.02)};
    sheet.normals = {Vec3(0, 0, 1), Vec3(0.3, 0, 1).normalized(), Vec3(0, 0.2, 1).normalized(),
                     Vec3(0, 0, 1)};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    builder.object("sheet", sheet, Vec3(0, 0, 0), "wood");
}

std::string picture_path() {
    static const PictureFile file;
    return file.path();
}

/// Walls from which most paths scatter eight times, a mirror and glass.
void add_white_room(SceneBuilder& builder) {
    StandardMaterial glass;
    glass.transmission = 1;
    StandardMaterial mirror;
    mirror.metal = 1;
    mirror.roughness = 0;
    StandardMaterial grey_green = coated(0.3);
    grey_green.base = Vec3(0.5, 0.8, 0.6);
    builder.diffuse("white", 0.9).material("glass", glass).material("mirror", mirror);
    builder.material("lacquer", grey_green);
    builder.object("back", render::BoxShape{Vec3(2, 0.1, 1)}, Vec3(0, 0.8, 0.4), "white");
    builder.object("left", render::BoxShape{Vec3(0.1, 2, 1)}, Vec3(-0.8, 0, 0.4), "lacquer");
    builder.object("right", render::BoxShape{Vec3(0.1, 2, 1)}, Vec3(0.8, 0, 0.4), "white");
    builder.object("floor", render::BoxShape{Vec3(2, 2, 0.02)}, Vec3(0, 0, 0), "white");
    builder.sphere("clear", 0.12, Vec3(0.4, -0.4, 0.12), "glass");
    builder.sphere("shiny", 0.12, Vec3(-0.5, -0.3, 0.12), "mirror");
}

/// All shapes, with the same texture.
void add_shapes(SceneBuilder& builder, Placement placement, const render::ColourSource& texture) {
    StandardMaterial material = coated(0);
    material.base = texture;
    builder.material("pattern", material);
    add_every_shape(builder, placement, "pattern");
}

void add_shape_cases(std::vector<WaveCase>& cases) {
    render::ImageTexture image;
    image.file = picture_path();
    render::WoodTexture wood;
    render::CheckerTexture checker;
    const std::pair<const char*, render::ColourSource> textures[] = {
        {"Image", image}, {"Checker", checker}, {"Wood", wood}};
    const std::pair<const char*, Placement> placements[] = {{"UprightShapes", Placement::upright},
                                                            {"TurnedShapes", Placement::turned},
                                                            {"MovingShapes", Placement::moving}};
    for (const auto& [texture_name, texture] : textures) {
        for (const auto& [placement_name, placement] : placements) {
            cases.push_back({std::string(placement_name) + "With" + texture_name,
                             [texture = texture, placement = placement](SceneBuilder& builder) {
                                 add_lights(builder);
                                 add_shapes(builder, placement, texture);
                             }});
        }
    }
}

/// Every shape emits light.
void add_glowing_cases(std::vector<WaveCase>& cases) {
    const std::pair<const char*, Placement> placements[] = {{"Upright", Placement::upright},
                                                            {"Turned", Placement::turned},
                                                            {"Moving", Placement::moving}};
    for (const auto& [name, placement] : placements) {
        cases.push_back({std::string("Glowing") + name + "Shapes",
                         [placement = placement](SceneBuilder& builder) {
                             StandardMaterial glowing;
                             glowing.emission = Vec3(0.5, 0.4, 0.1);
                             builder.material("glowing", glowing);
                             builder.lamp(Vec3(0, 0, 1.5), 0.4, 0.2, 6);
                             add_every_shape(builder, placement, "glowing");
                         }});
    }
}

std::vector<WaveCase> wave_cases() {
    const auto with_lights = [](const std::function<void(SceneBuilder&)>& more) {
        return [more](SceneBuilder& builder) {
            add_lights(builder);
            more(builder);
        };
    };
    std::vector<WaveCase> cases;
    cases.push_back({"LampBulbAndSky", with_lights([](SceneBuilder&) {})});
    cases.push_back({"NoLightAtAll", [](SceneBuilder&) {}});
    cases.push_back({"ManyLamps", [](SceneBuilder& builder) {
                         for (int i = 0; i < 6; ++i) {
                             builder.lamp(Vec3(0.3 * i - 0.8, 0, 1 + 0.1 * i), 0.1, 0.3, 4);
                         }
                     }});
    cases.push_back({"LightsWithoutSurface", with_lights([](SceneBuilder& builder) {
                         render::PointLight point;
                         point.position = Vec3(0.4, -0.4, 0.7);
                         point.intensity = Vec3(0.4, 0.5, 0.6);
                         builder.scene.lights.push_back({"point", point});
                     })});
    cases.push_back(
        {"LightsWithoutFalloff", [](SceneBuilder& builder) {
             add_lights(builder);
             for (render::LightDescription& light : builder.scene.lights) {
                 if (auto* lamp = std::get_if<render::RectangleLight>(&light.light)) {
                     lamp->falloff = render::Falloff::none;
                 } else if (auto* bulb = std::get_if<render::SphereLight>(&light.light)) {
                     bulb->falloff = render::Falloff::none;
                 }
             }
             builder.scene.lights.push_back(
                 {"point",
                  render::PointLight{Vec3(0.4, -0.4, 0.7), Vec3(1, 2, 3), render::Falloff::none}});
         }});
    cases.push_back({"SkyWithSun", [](SceneBuilder& builder) {
                         render::EnvironmentLight sky;
                         sky.sky = render::Sky{};
                         sky.radiance = Vec3(1e-5, 1e-5, 1e-5);
                         builder.scene.lights.push_back({"sky", sky});
                         builder.lamp(Vec3(0, 0, 1.5), 0.4, 0.2, 6);
                     }});
    cases.push_back({"OtherMaterials", with_lights([](SceneBuilder& builder) {
                         StandardMaterial glass;
                         glass.transmission = 1;
                         StandardMaterial chrome;
                         chrome.metal = 1;
                         chrome.roughness = 0.2;
                         StandardMaterial glowing;
                         glowing.emission = Vec3(0.5, 0.4, 0.1);
                         builder.material("glass", glass).material("chrome", chrome);
                         builder.material("lacquer", coated(0.2)).material("glowing", glowing);
                         builder.sphere("a", 0.12, Vec3(0.5, 0.1, 0.12), "glass");
                         builder.sphere("b", 0.12, Vec3(-0.5, -0.3, 0.12), "chrome");
                         builder.sphere("c", 0.12, Vec3(0.4, -0.4, 0.12), "lacquer");
                         builder.sphere("d", 0.06, Vec3(-0.5, 0.5, 0.06), "glowing");
                     })});
    cases.push_back({"TurnedAndTextured", with_lights([](SceneBuilder& builder) {
                         StandardMaterial painted = coated(0);
                         painted.base = render::CheckerTexture{};
                         builder.material("painted", painted);
                         builder.object("tile", render::RectangleShape{Vec2(0.4, 0.4)},
                                        Vec3(-0.4, -0.4, 0.02), "painted");
                         builder.sphere("globe", 0.15, Vec3(0.3, -0.4, 0.15), "painted");
                     })});
    cases.push_back({"ClothAndVelvet", with_lights([](SceneBuilder& builder) {
                         StandardMaterial cloth;
                         cloth.base = render::ClothTexture{};
                         cloth.sheen = 0.3;
                         cloth.sheen_colour = Vec3(0.4, 0.8, 0.7);
                         cloth.bump = 0.5;
                         StandardMaterial velvet = coated(0);
                         velvet.sheen = 0.8;
                         StandardMaterial dust = cloth;
                         dust.base = Vec3(0, 0, 0);
                         builder.material("nap", cloth).material("velvet", velvet);
                         builder.material("dust", dust);
                         builder.object("bed", render::BoxShape{Vec3(1, 1, 0.02)},
                                        Vec3(-0.5, 0.2, 0), "nap");
                         builder.sphere("pillow", 0.15, Vec3(0.3, -0.4, 0.15), "velvet");
                         builder.sphere("soot", 0.1, Vec3(-0.3, -0.5, 0.1), "dust");
                     })});
    cases.push_back(
        {"HighlightsAndMetals", with_lights([](SceneBuilder& builder) { add_metals(builder); })});
    cases.push_back({"LacquerUnderASky", [](SceneBuilder& builder) {
                         render::EnvironmentLight sky;
                         sky.sky = render::Sky{};
                         sky.radiance = Vec3(1e-5, 1e-5, 1e-5);
                         builder.scene.lights.push_back({"sky", sky});
                         builder.lamp(Vec3(0, 0, 1.5), 0.4, 0.2, 6);
                         add_lacquer(builder);
                     }});
    cases.push_back(
        {"PaintAndMeshes", with_lights([](SceneBuilder& builder) { add_paint(builder); })});
    cases.push_back({"ClearGlass",
                     with_lights([](SceneBuilder& builder) {
                         StandardMaterial glass;
                         glass.transmission = 1;
                         glass.roughness = 0;
                         builder.material("clear", glass);
                         builder.scene.lights.push_back(
                             {"point", render::PointLight{Vec3(0.4, 0.5, 0.9), Vec3(1, 1, 1)}});
                         builder.bulb(Vec3(-0.2, 0.6, 1.2), 0.01, 300);
                         builder.sphere("lens", 0.12, Vec3(0.3, -0.4, 0.16), "clear");
                         builder.sphere("rolling lens", 0.1, Vec3(0, 0, 0), "clear", "moving");
                     }),
                     {.max_bounces = 4}});
    cases.push_back({"EightBounces", with_lights([](SceneBuilder&) {}), {.max_bounces = 8}});
    cases.push_back({"WhiteRoomWithRoulette", with_lights(add_white_room), {.max_bounces = 8}});
    cases.push_back({"DirectLightOnly", with_lights([](SceneBuilder&) {}), {.max_bounces = 0}});
    cases.push_back({"NoSplit", with_lights([](SceneBuilder&) {}), {.split_vertices = 0}});
    cases.push_back({"NoCaustics", with_lights([](SceneBuilder&) {}), {.caustics = false}});
    cases.push_back({"Clamped", with_lights([](SceneBuilder&) {}), {.clamp = 0.2f}});
    add_shape_cases(cases);
    add_glowing_cases(cases);
    return cases;
}

bool is_near(const render::V3f& a, const render::V3f& b) {
    return (a - b).length() <= kRounding * (a.length() + b.length());
}

/// What rays that end at what they see find.
std::vector<RadianceSample> sights_of(const render::Integrator& integrator,
                                      const std::vector<CameraBatch>& batches, float spread) {
    std::vector<RadianceSample> seen(batches.size() * CameraBatch::kMost);
    const auto workspace = integrator.make_workspace();
    std::size_t first = 0;
    for (const CameraBatch& batch : batches) {
        integrator.trace_first_hits(CameraRun::all(batch), spread, &seen[first], workspace.get());
        first += static_cast<std::size_t>(batch.count);
    }
    seen.resize(first);
    return seen;
}

/// They find the same as the samples. A rough coat shows a sample another part of its surroundings,
/// in the mean the same.
void expect_same_sights(const std::vector<RadianceSample>& seen,
                        const std::vector<RadianceSample>& samples) {
    render::V3f sum(0, 0, 0);
    float squares = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_EQ(seen[i].object, samples[i].object) << i;
        EXPECT_EQ(seen[i].coverage, samples[i].coverage) << i;
        EXPECT_EQ(seen[i].normal, samples[i].normal) << i;
        EXPECT_EQ(seen[i].albedo, samples[i].albedo) << i;
        EXPECT_TRUE(is_near(seen[i].light, samples[i].light)) << i;
        const render::V3f difference = seen[i].mirrored - samples[i].mirrored;
        sum += difference;
        squares += difference.length2();
    }
    EXPECT_LE(sum.length(), 4 * std::sqrt(squares) + 1e-4f);
}

void expect_same_bits(const std::vector<RadianceSample>& a, const std::vector<RadianceSample>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].radiance, b[i].radiance) << i;
        EXPECT_EQ(a[i].coverage, b[i].coverage) << i;
        EXPECT_EQ(a[i].normal, b[i].normal) << i;
        EXPECT_EQ(a[i].albedo, b[i].albedo) << i;
        EXPECT_EQ(a[i].mirrored, b[i].mirrored) << i;
        EXPECT_EQ(a[i].light, b[i].light) << i;
        EXPECT_EQ(a[i].object, b[i].object) << i;
    }
}

std::vector<RadianceSample> samples_of(const render::Integrator& integrator,
                                       const std::vector<CameraBatch>& batches, float spread,
                                       render::RenderStatistics& count) {
    std::vector<RadianceSample> results(batches.size() * CameraBatch::kMost);
    const auto workspace = integrator.make_workspace();
    std::size_t first = 0;
    for (const CameraBatch& batch : batches) {
        integrator.samples(CameraRun::all(batch), spread, &results[first], workspace.get(), count);
        first += static_cast<std::size_t>(batch.count);
    }
    results.resize(first);
    return results;
}

/// Samples of all pixels with their rays.
std::vector<CameraBatch> batches_of(const render::ThinLensCamera& lens, int samples) {
    std::vector<CameraBatch> batches(1);
    for (int i = 0; i < kSide * kSide * samples; ++i) {
        if (batches.back().count == CameraBatch::kMost) {
            batches.emplace_back();
        }
        const int x = i / samples % kSide;
        const int y = i / samples / kSide;
        const render::SampleStream stream(3, static_cast<std::uint32_t>(x),
                                          static_cast<std::uint32_t>(y),
                                          static_cast<std::uint32_t>(i % samples));
        batches.back().add(stream, {x, y, i % samples});
    }
    for (CameraBatch& batch : batches) {
        render::make_rays(lens, {}, batch);
    }
    return batches;
}

class Waves : public testing::TestWithParam<WaveCase> {};

TEST_P(Waves, OneLaneOrMany_GiveTheSameBits) {
    SceneBuilder builder;
    add_table(builder);
    GetParam().furnish(builder);
    const render::RenderSettings settings = small_settings(kSide, kSide, kSamples);
    const render::PreparedScene prepared(builder.scene, settings);
    const auto& data = prepared.data();
    const std::vector<sim::Track> tracks = table_tracks();
    const render::FrameScene frame(data.geometry, tracks, 0, kShutter);
    const render::LightSet lights = data.lights.in_frame(frame.motions());
    const render::TransportScene scene{frame, data.materials, lights, data.object_count};
    const render::CameraState state = camera(Vec3(0.3, -1.6, 1.1), Vec3(0, 0, 0.05), 0.8);
    const render::ThinLensCamera lens(state, state, kSide, kSide, 0, render::PixelFilter::box, 1);
    const render::LightTracer light_tracer(scene, lens);
    const std::vector<CameraBatch> batches = batches_of(lens, kSamples);
    const float spread = lens.frame_at(0).pixel_size;

    const render::PathIntegrator many(scene, GetParam().path, &light_tracer);
    render::RenderStatistics count;
    const std::vector<RadianceSample> samples = samples_of(many, batches, spread, count);
    const std::vector<RadianceSample> seen = sights_of(many, batches, spread);
    expect_same_sights(seen, samples);

    hwy::DisableTargets(kAllButOneLane);
    const render::PathIntegrator one(scene, GetParam().path, &light_tracer);
    hwy::DisableTargets(0);
    render::RenderStatistics count_of_one;
    expect_same_bits(samples_of(one, batches, spread, count_of_one), samples);
    expect_same_bits(sights_of(one, batches, spread), seen);
    EXPECT_EQ(count.camera_rays, count_of_one.camera_rays);
    EXPECT_EQ(count.scattered_rays, count_of_one.scattered_rays);
    EXPECT_EQ(count.shadow_rays, count_of_one.shadow_rays);
}

INSTANTIATE_TEST_SUITE_P(All, Waves, testing::ValuesIn(wave_cases()),
                         [](const auto& tested) { return tested.param.name; });

// A sample must not depend on those traced with it: frames do not depend on tiles and chunks.
TEST(WaveIntegrator, Samples_DoNotDependOnOthersInTheWave) {
    SceneBuilder builder;
    add_table(builder);
    add_lights(builder);
    const render::RenderSettings settings = small_settings(kSide, kSide, 1);
    const render::PreparedScene prepared(builder.scene, settings);
    const auto& data = prepared.data();
    const std::vector<sim::Track> tracks = table_tracks();
    const render::FrameScene frame(data.geometry, tracks, 0, kShutter);
    const render::LightSet lights = data.lights.in_frame(frame.motions());
    const render::TransportScene scene{frame, data.materials, lights, data.object_count};
    const render::CameraState state = camera(Vec3(0.3, -1.6, 1.1), Vec3(0, 0, 0.05), 0.8);
    const render::ThinLensCamera lens(state, state, kSide, kSide, 0, render::PixelFilter::box, 1);
    const render::PathIntegrator many(scene, {});
    const std::vector<CameraBatch> batches = batches_of(lens, 1);
    const auto traced = [&](int at_once) {
        std::vector<RadianceSample> results(std::size_t{kSide} * kSide);
        RadianceSample* result = results.data();
        render::RenderStatistics count;
        const auto workspace = many.make_workspace();
        for (const CameraBatch& batch : batches) {
            for (int from = 0; from < batch.count; from += at_once) {
                const CameraRun run = CameraRun::all(batch).part(from, at_once);
                many.samples(run, 0.001f, result, workspace.get(), count);
                result += run.count;
            }
        }
        return results;
    };
    const std::vector<RadianceSample> whole = traced(CameraBatch::kMost);
    for (const int at_once : {1, 7, 100}) {
        const std::vector<RadianceSample> parts = traced(at_once);
        for (std::size_t i = 0; i < whole.size(); ++i) {
            ASSERT_EQ(whole[i].radiance, parts[i].radiance) << at_once << " " << i;
        }
    }
}

// Balls on cloth with sheen: vectors contain paths of both.
std::vector<float> small_picture() {
    SceneBuilder builder;
    add_table(builder);
    add_lights(builder);
    StandardMaterial nap;
    nap.base = Vec3(0.1, 0.3, 0.2);
    nap.sheen = 0.3;
    builder.material("nap", nap);
    builder.object("bed", render::BoxShape{Vec3(1, 1, 0.02)}, Vec3(0, 0, 0), "nap");
    add_lacquer(builder);
    add_paint(builder);
    render::ImageTexture image;
    image.file = picture_path();
    add_shapes(builder, Placement::turned, image);
    const render::RenderSettings settings = small_settings(kSide, kSide, 16);
    const render::PreparedScene prepared(builder.scene, settings);
    render::FrameInput frame = static_frame(camera(Vec3(0.3, -1.6, 1.1), Vec3(0, 0, 0.05), 0.8));
    frame.scene_close = kShutter;
    return render::render_frame(prepared, table_tracks(), frame, settings).rgba;
}

// A frame's key in the store does not contain the vector width.
TEST(WaveIntegrator, WiderVectors_GiveTheSameBits) {
    const std::int64_t targets = hwy::SupportedTargets();
    constexpr std::int64_t kWider = HWY_AVX3 | HWY_AVX3_DL;
    if ((targets & kWider) == 0) {
        GTEST_SKIP() << "this processor has none";
    }
    const std::vector<float> wide = small_picture();
    hwy::DisableTargets(kWider);
    const std::vector<float> narrow = small_picture();
    hwy::DisableTargets(0);
    EXPECT_EQ(wide, narrow);
}

}  // namespace
}  // namespace carom::test
