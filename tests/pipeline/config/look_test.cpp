// Tests of materials, lights, and the look of balls and objects.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/folders.h"
#include "tests/pipeline/config/load.h"
#include "tests/pipeline/film_of_shots.h"

namespace carom::pipeline {
namespace {

using ::testing::EndsWith;

const render::ObjectDescription& object(const Shot& shot, const std::string& name) {
    for (const render::ObjectDescription& candidate : shot.scene.objects) {
        if (candidate.name == name) {
            return candidate;
        }
    }
    throw std::runtime_error("no object " + name);
}

const render::StandardMaterial& material(const Shot& shot, const std::string& name) {
    for (const render::MaterialDescription& candidate : shot.scene.materials) {
        if (candidate.name == name) {
            return candidate.surface;
        }
    }
    throw std::runtime_error("no material " + name);
}

/// The material "m" of a shot with an object that uses it.
render::StandardMaterial read_material(const std::string& standard) {
    return material(load_sections("objects: {o: {sphere: 1, material: m}}\n"
                                  "materials: {m: {standard: " +
                                  standard + "}}\n"),
                    "m");
}

TEST(Materials, Standard_FillsEveryField) {
    const render::StandardMaterial m = read_material(
        "{base: [0.3, 0.1, 0.04], metal: 1, roughness: 0.35, specular: 0.5, sheen: 0.2,\n"
        "  sheen_colour: [0, 1, 0], bump: 0.3, coat: {ior: 1.6, roughness: 0.02}}");
    EXPECT_EQ(std::get<Vec3>(m.base), Vec3(0.3, 0.1, 0.04));
    EXPECT_EQ(m.metal.constant_or(-1), 1);
    EXPECT_EQ(m.roughness.constant_or(-1), 0.35);
    EXPECT_EQ(m.specular.constant_or(-1), 0.5);
    EXPECT_EQ(m.sheen.constant_or(-1), 0.2);
    EXPECT_EQ(m.sheen_colour, Vec3(0, 1, 0));
    EXPECT_EQ(m.bump, 0.3);
    EXPECT_EQ(m.coat.weight.constant_or(-1), 1);
    EXPECT_EQ(m.coat.ior, 1.6);
    EXPECT_EQ(m.coat.roughness.constant_or(-1), 0.02);
    EXPECT_EQ(read_material("{base: 0.5}").coat.weight.constant_or(-1), 0);
}

TEST(Materials, Glass_FillsEveryField) {
    const render::StandardMaterial m = read_material(
        "{transmission: 0.9, ior: 1.6, transmission_colour: [0.9, 0.8, 0.7],\n"
        "  transmission_depth: 20 mm}");
    EXPECT_EQ(m.transmission, 0.9);
    EXPECT_EQ(m.ior, 1.6);
    EXPECT_EQ(m.transmission_colour, Vec3(0.9, 0.8, 0.7));
    EXPECT_EQ(m.transmission_depth, 0.02);
    EXPECT_EQ(read_material("{base: 0.5}").transmission, 0);
}

TEST(Output, ViewsAndGlow_FillEveryField) {
    const Shot shot = load_sections(
        "output: {view: ocio, ocio: {display: a, view: b, colour_space: c},\n"
        "  glow: {strength: 0.1, radius: 0.2}}\n");
    EXPECT_EQ(shot.output.view, ViewTransform::ocio);
    EXPECT_EQ(shot.output.ocio.display, "a");
    EXPECT_EQ(shot.output.ocio.view, "b");
    EXPECT_EQ(shot.output.ocio.colour_space, "c");
    EXPECT_EQ(shot.output.glow.strength, 0.1);
    EXPECT_EQ(shot.output.glow.radius, 0.2);
    EXPECT_EQ(load_sections("output: {view: agx}\n").output.view, ViewTransform::agx);
}

TEST(Output, Denoise_IsWordOrStrengthAndSetsTheRenderer) {
    const Shot plain = load_sections("output: {denoise: false}\n");
    EXPECT_EQ(plain.output.denoise.strength, 0);
    EXPECT_FALSE(plain.render.for_denoiser);
    const Shot full = load_sections("output: {denoise: true}\nrender: {samples: 8}\n");
    EXPECT_EQ(full.output.denoise.strength, 1);
    EXPECT_TRUE(full.render.for_denoiser);
    const Shot half = load_sections("output: {denoise: {strength: 0.5}}\nrender: {samples: 8}\n");
    EXPECT_EQ(half.output.denoise.strength, 0.5);
    EXPECT_TRUE(half.render.for_denoiser);
}

std::vector<std::string> shipped_shots() {
    std::vector<std::string> files;
    const std::filesystem::path examples = std::string(CAROM_SOURCE_DIR) + "/examples";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(examples)) {
        if (entry.path().extension() == ".yaml" &&
            !carom::testing::is_film_of_shots(entry.path())) {
            files.push_back(entry.path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

TEST(Examples, All_HaveNoProblemAndTheirFilesExist) {
    EXPECT_GE(shipped_shots().size(), 15u);
    for (const std::string& file : shipped_shots()) {
        const LoadResult result = load_shot(file);
        EXPECT_EQ(all_problems(result), "") << file;
        ASSERT_TRUE(result.shot) << file;
        for (const render::ObjectDescription& object : result.shot->scene.objects) {
            const auto* mesh = std::get_if<render::MeshShape>(&object.shape);
            EXPECT_TRUE(mesh == nullptr || mesh->file.empty() ||
                        std::filesystem::exists(mesh->file))
                << file;
        }
    }
}

TEST(Gallery, EveryPictureOnThePage_ExistsWithItsShot) {
    const std::string root = CAROM_SOURCE_DIR;
    std::ifstream stream(root + "/docs/gallery.md");
    const std::string page{std::istreambuf_iterator<char>(stream), {}};
    const std::string link = "(images/gallery/";
    const std::string end = ".jpg)";
    int pictures = 0;
    std::uintmax_t bytes = 0;
    for (std::size_t at = page.find(link); at != std::string::npos; at = page.find(link, at + 1)) {
        const std::size_t first = at + link.size();
        const std::string name = page.substr(first, page.find(end, first) - first);
        const std::string file = root + "/docs/images/gallery/" + name + ".jpg";
        const std::string still = "example_";
        const std::string shot =
            name.starts_with(still) ? name.substr(still.size()) : "gallery/" + name;
        EXPECT_TRUE(std::filesystem::exists(root + "/examples/" + shot + ".yaml")) << name;
        ASSERT_TRUE(std::filesystem::exists(file)) << name;
        bytes += std::filesystem::file_size(file);
        pictures += 1;
    }
    EXPECT_EQ(pictures, 18 + 22);
    EXPECT_LT(bytes, 6'000'000u);
}

TEST(ScenesOfTexts, AllHaveASmallPictureOnTheirPage) {
    namespace fs = std::filesystem;
    const std::string root = CAROM_SOURCE_DIR;
    std::string pages;
    for (const char* page : {"distributed", "laboratory"}) {
        std::ifstream stream(root + "/docs/developers/" + page + ".md");
        pages.append(std::istreambuf_iterator<char>(stream), {});
    }
    int scenes = 0;
    for (const auto& entry : fs::directory_iterator(root + "/examples/texts")) {
        if (entry.path().extension() == ".yaml") {
            const std::string picture = "images/texts/" + entry.path().stem().string() + ".jpg";
            EXPECT_NE(pages.find("(../" + picture + ")"), std::string::npos) << picture;
            ASSERT_TRUE(fs::exists(root + "/docs/" + picture)) << picture;
            EXPECT_LT(fs::file_size(root + "/docs/" + picture), 100'000u) << picture;
            scenes += 1;
        }
    }
    EXPECT_EQ(scenes, 17);
}

TEST(Materials, Phong_FillsEveryField) {
    const Shot shot = load_sections(
        "render: {integrator: distributed}\n"
        "objects: {o: {sphere: 1, material: m}, p: {sphere: 1, at: [9, 0, 5], material: n}}\n"
        "materials:\n"
        "  m: {phong: {ambient: [0.1, 0.2, 0.3], diffuse: {checker: {size: 2}}, specular: 0.5,\n"
        "    shininess: 40, reflectance: [0.2, 0.3, 0.4], reflectance_spread: 9 deg,\n"
        "    transmittance: 0.25, transmittance_spread: 0.1 rad, index: 1.4}}\n"
        "  n: {phong: {}}\n");
    ASSERT_EQ(shot.scene.materials.size(), 2u);
    ASSERT_TRUE(shot.scene.materials[0].phong);
    const render::PhongMaterial& m = *shot.scene.materials[0].phong;
    EXPECT_EQ(m.ambient, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(std::get<render::CheckerTexture>(m.diffuse).size, 2);
    EXPECT_EQ(m.specular, Vec3(0.5));
    EXPECT_EQ(m.shininess, 40);
    EXPECT_EQ(m.reflectance, Vec3(0.2, 0.3, 0.4));
    EXPECT_NEAR(m.reflectance_spread, 0.15707963267948966, 1e-15);
    EXPECT_EQ(m.transmittance, Vec3(0.25));
    EXPECT_EQ(m.transmittance_spread, 0.1);
    EXPECT_EQ(m.index, 1.4);
    EXPECT_FALSE(shot.scene.materials[1].phong->ambient);
}

TEST(Materials, PhongBalls_KeepTheirPaint) {
    const Shot shot = load_sections(
        "render: {integrator: distributed}\n"
        "table: {kind: pool, size: 9 ft}\n"
        "balls: {three: {at: [0, 0]}}\n"
        "materials: {ball: {phong: {reflectance: 0.1}}}\n");
    for (const render::MaterialDescription& material : shot.scene.materials) {
        if (material.name == "ball/three") {
            ASSERT_TRUE(material.phong);
            EXPECT_EQ(material.phong->reflectance, Vec3(0.1));
            EXPECT_EQ(std::get<render::BallTexture>(material.phong->diffuse).number, 3);
            return;
        }
    }
    FAIL() << "no material of the ball";
}

TEST(Materials, Colours_HaveThreeSpellings) {
    EXPECT_EQ(std::get<Vec3>(read_material("{base: 0.25}").base), Vec3(0.25));
    const Vec3 white = std::get<Vec3>(read_material("{base: \"#ffffff\"}").base);
    EXPECT_EQ(white, Vec3(1, 1, 1));
    const Vec3 grey = std::get<Vec3>(read_material("{base: \"#808000\"}").base);
    EXPECT_NEAR(grey.x, 0.2158605, 1e-7);  // IEC 61966-2-1
    EXPECT_EQ(grey.z, 0);
}

TEST(Materials, Textures_FillEveryField) {
    const auto image = std::get<render::ImageTexture>(
        read_material("{base: {image: {file: files/picture.png, scale: [2, 3], is_linear: true}}}")
            .base);
    EXPECT_THAT(image.file, EndsWith("/tests/pipeline/config/files/picture.png"));
    EXPECT_EQ(image.scale, Vec2(2, 3));
    const auto placed = std::get<render::ImageTexture>(
        read_material("{base: {image: {file: files/picture.png, size: [20 cm, 30 cm], offset: "
                      "[0.5, 0], rotate: 180 deg}}}")
            .base);
    EXPECT_EQ(placed.size, Vec2(0.2, 0.3));
    EXPECT_EQ(placed.offset, Vec2(0.5, 0));
    EXPECT_NEAR(placed.placement.rotation, std::numbers::pi, 1e-12);
    EXPECT_TRUE(image.is_linear);
    const auto cloth = std::get<render::ClothTexture>(
        read_material("{base: {cloth: {colour: [0, 0.1, 0.3], thread: 1 mm, variation: 0}}}").base);
    EXPECT_EQ(cloth.colour, Vec3(0, 0.1, 0.3));
    EXPECT_EQ(cloth.thread, 0.001);
    const render::NumberSource smudged =
        read_material("{specular: {smudges: {amount: 0.3, seed: 4}, range: [0.35, 0.8]}}").specular;
    ASSERT_NE(smudged.texture(), nullptr);
    const auto smudges = std::get<render::SmudgesTexture>(smudged.texture()->pattern);
    EXPECT_EQ(smudges.amount, 0.3);
    EXPECT_EQ(smudges.seed, 4);
    const auto wood = std::get<render::WoodTexture>(
        read_material("{base: {wood: {light: 0.4, ring: 9 mm, grain: [0, 1, 0]}}}").base);
    EXPECT_EQ(wood.light, Vec3(0.4));
    EXPECT_EQ(wood.grain, Vec3(0, 1, 0));
    const auto checker =
        std::get<render::CheckerTexture>(read_material("{base: {checker: {size: 30 cm}}}").base);
    EXPECT_EQ(checker.size, 0.3);
    const auto ball =
        std::get<render::BallTexture>(read_material("{base: {ball: {number: 3}}}").base);
    EXPECT_EQ(ball.number, 3);
}

TEST(Materials, WornClothOfATable_KnowsItsField) {
    const Shot shot = load_sections(
        "table: {kind: carom}\n"
        "objects: {o: {box: [1, 1, 1], at: [0, 0, 2], material: rug}}\n"
        "materials:\n"
        "  cloth: {standard: {base: {cloth: {wear: 0.4, seed: 7, nap: -0.5}}}}\n"
        "  cushion: {standard: {base: {cloth: {}}}}\n"
        "  rug: {standard: {base: {cloth: {wear: 1}}}}\n");
    const auto cloth_of = [&](const std::string& name) {
        for (const render::MaterialDescription& material : shot.scene.materials) {
            if (material.name == name) {
                return std::get<render::ClothTexture>(material.surface.base);
            }
        }
        return render::ClothTexture{};
    };
    EXPECT_EQ(cloth_of("cloth").bed, Vec2(1.42, 0.71));  // 10 ft: 2.84 m by 1.42 m
    EXPECT_EQ(cloth_of("cloth").wear, 0.4);
    EXPECT_EQ(cloth_of("cloth").seed, 7);
    EXPECT_EQ(cloth_of("cloth").nap, -0.5);
    EXPECT_EQ(cloth_of("cushion").bed, Vec2(0, 0));  // its picture does not change with the table
    EXPECT_EQ(cloth_of("rug").wear, 1);
    EXPECT_EQ(cloth_of("rug").bed, Vec2(0, 0));
}

TEST(Materials, OnlyUsedMaterials_AreInTheScene) {
    const Shot shot = load_sections("materials: {unused: {standard: {base: 0.2}}}\n");
    EXPECT_TRUE(shot.scene.materials.empty());
}

TEST(Lights, EveryKind_FillsItsFields) {
    const Shot shot = load_sections(
        "lights:\n"
        "  lamp: {rectangle: [1.2, 0.4], at: [0, 0, 1.5], facing: [0, 0, -2], radiance: [24, 23, "
        "21]}\n"
        "  side: {rectangle: [1, 2], at: [0, 3, 1], facing: [0, -1, 0], roll: 90 deg, strength: "
        "3}\n"
        "  bulb: {sphere: 5 cm, at: [1, 0, 2], radiance: 100}\n"
        "  room: {environment: [0.1, 0.2, 0.3], strength: 2, rotation: 90 deg}\n");
    ASSERT_EQ(shot.scene.lights.size(), 4U);
    const auto& lamp = std::get<render::RectangleLight>(shot.scene.lights[0].light);
    EXPECT_EQ(shot.scene.lights[0].name, "lamp");
    EXPECT_EQ(lamp.centre, Vec3(0, 0, 1.5));
    EXPECT_EQ(lamp.normal, Vec3(0, 0, -1));
    EXPECT_EQ(lamp.edge_u, Vec3(0.6, 0, 0));
    EXPECT_NEAR((lamp.edge_v - Vec3(0, -0.2, 0)).length(), 0, 1e-12);
    EXPECT_EQ(lamp.radiance, Vec3(24, 23, 21));
    const auto& side = std::get<render::RectangleLight>(shot.scene.lights[1].light);
    // Without roll u is horizontal; a quarter turn about the normal makes it vertical.
    EXPECT_NEAR(std::abs(side.edge_u.z), 0.5, 1e-12);
    EXPECT_NEAR(std::abs(side.edge_v.x), 1, 1e-12);
    EXPECT_EQ(side.radiance, Vec3(3));
    const auto& bulb = std::get<render::SphereLight>(shot.scene.lights[2].light);
    EXPECT_EQ(bulb.radius, 0.05);
    EXPECT_EQ(bulb.radiance, Vec3(100));
    const auto& room = std::get<render::EnvironmentLight>(shot.scene.lights[3].light);
    EXPECT_EQ(room.radiance, Vec3(0.2, 0.4, 0.6));
    EXPECT_DOUBLE_EQ(room.rotation, 1.5707963267948966);
}

TEST(Lights, WithoutFalloff_HaveFalloffNone) {
    const Shot shot = load_sections(
        "lights:\n"
        "  lamp: {rectangle: [1.2, 0.4], falloff: none}\n"
        "  bulb: {sphere: 5 cm, falloff: none}\n"
        "  spark: {point: 3, falloff: none}\n"
        "  torch: {spot: 3, falloff: none}\n"
        "  usual: {point: 3}\n");
    const auto falloff = [&](std::size_t light) {
        return std::visit(
            [](const auto& l) {
                if constexpr (requires { l.falloff; }) {
                    return l.falloff;
                } else {
                    return render::Falloff::inverse_square;
                }
            },
            shot.scene.lights.at(light).light);
    };
    for (std::size_t light = 0; light < 4; ++light) {
        EXPECT_EQ(falloff(light), render::Falloff::none) << light;
    }
    EXPECT_EQ(falloff(4), render::Falloff::inverse_square);
}

TEST(Lights, Picture_IsAnAsset) {
    const Shot shot =
        load_sections("lights: {sky: {environment: files/picture.png, strength: 0.4}}\n");
    const auto& sky = std::get<render::EnvironmentLight>(shot.scene.lights.at(0).light);
    EXPECT_THAT(sky.image, EndsWith("files/picture.png"));
    EXPECT_EQ(sky.radiance, Vec3(0.4));
    ASSERT_EQ(shot.assets.size(), 1U);
    EXPECT_EQ(shot.assets[0].path, sky.image);
    EXPECT_EQ(shot.assets[0].content_hash, hash_file(sky.image));
}

TEST(Lights, Default_IsALampAndARoom) {
    EXPECT_EQ(load_sections("").scene.lights.size(), 2U);
}

TEST(Balls, Colours_FollowTheName) {
    const Shot shot = load_sections(
        "balls: {one: {at: [0, 0]}, twelve: {at: [1, 0]}, cue: {at: [2, 0]}, guest: {at: [3, "
        "0]}}\n");
    const auto paint = [&](const std::string& name) {
        return std::get<render::BallTexture>(material(shot, "ball/" + name).base);
    };
    EXPECT_EQ(object(shot, "one").material, "ball/one");
    EXPECT_EQ(object(shot, "one").track, "one");
    EXPECT_EQ(std::get<render::SphereShape>(object(shot, "one").shape).radius, 0.028575);
    EXPECT_EQ(paint("one").number, 1);
    EXPECT_FALSE(paint("one").striped);
    EXPECT_EQ(paint("twelve").number, 12);
    EXPECT_TRUE(paint("twelve").striped);
    EXPECT_EQ(paint("cue").number, 0);
    EXPECT_EQ(paint("cue").spots, 6);
    EXPECT_EQ(paint("guest").number, 0);
    EXPECT_EQ(material(shot, "ball/one").coat.weight.constant_or(-1), 1);
}

TEST(Balls, OtherSets_HaveTheirOwnColours) {
    const auto red = [](const std::string& set, const std::string& name) {
        const Shot shot =
            load_sections("ball_set: {kind: " + set + "}\nballs: {" + name + ": {at: [0, 0]}}\n");
        return std::get<render::BallTexture>(material(shot, "ball/" + name).base).colour;
    };
    EXPECT_EQ(red("snooker", "red_3"), red("carom", "red"));
    EXPECT_NE(red("snooker", "blue"), red("snooker", "pink"));
    EXPECT_EQ(red("carom", "white"), red("pool", "cue"));
}

TEST(Balls, Look_ReplacesThatOfTheSet) {
    const Shot shot = load_sections(
        "balls:\n"
        "  one: {at: [0, 0], look: {colour: [0, 0, 1], number: 17, striped: true, disc_radius: "
        "0.4}}\n"
        "  two: {at: [1, 0], look: glass}\n"
        "materials: {glass: {standard: {base: 0.9}}, ball: {standard: {coat: {ior: 1.7}}}}\n");
    const render::StandardMaterial& own = material(shot, "ball/one");
    EXPECT_EQ(std::get<render::BallTexture>(own.base).number, 17);
    EXPECT_EQ(std::get<render::BallTexture>(own.base).colour, Vec3(0, 0, 1));
    EXPECT_EQ(std::get<render::BallTexture>(own.base).spots, 0);
    EXPECT_EQ(own.coat.ior, 1.7);  // the finish of all balls
    EXPECT_EQ(object(shot, "two").material, "glass");
}

TEST(Balls, Look_KeepsThePaintThatItDoesNotChange) {
    const Shot shot = load_sections("balls: {nine: {at: [0, 0], look: {spots: 6}}}\n");
    const auto paint = std::get<render::BallTexture>(material(shot, "ball/nine").base);
    EXPECT_EQ(paint.number, 9);
    EXPECT_TRUE(paint.striped);
    EXPECT_EQ(paint.spots, 6);
}

TEST(Objects, StaticObjects_AreInWorldCoordinates) {
    const Shot shot = load_sections(
        "objects:\n"
        "  poster: {rectangle: [2, 1], at: [1, 2, 3], rotate: [90 deg, 0, 0]}\n"
        "  statue: {mesh: files/triangle.obj, scale: 0.5, at: [0, 0, 1]}\n"
        "  tile: {box: [1, 1, 1], at: [9, 9, 9], physics: {mass: 1}, material: plain}\n");
    Vec3 top;
    object(shot, "poster").world_from_object.multVecMatrix(Vec3(0, 1, 0), top);
    EXPECT_NEAR((top - Vec3(1, 2, 4)).length(), 0, 1e-12);
    object(shot, "statue").world_from_object.multVecMatrix(Vec3(0, 2, 0), top);
    EXPECT_NEAR((top - Vec3(0, 1, 1)).length(), 0, 1e-12);
    EXPECT_EQ(object(shot, "statue").track, "");
    EXPECT_EQ(object(shot, "statue").material, "plain");
    EXPECT_EQ(object(shot, "tile").track, "tile");
    EXPECT_EQ(object(shot, "tile").world_from_object, Mat44());
}

TEST(Objects, EveryShape_HasItsDimensions) {
    const Shot shot = load_sections(
        "objects:\n"
        "  sail: {triangle: [[0, 0, 2], [1, 0, 2], [0, 2, 1]]}\n"
        "  sheet: {parallelogram: [[0, 0, 1], [1, 0, 1], [0.5, 2, 1]]}\n"
        "  plate: {disk: 20 cm, at: [0, 0, 1.1]}\n"
        "  can: {cylinder: {radius: 5 cm, height: 10 cm}, at: [0, 0, 1]}\n"
        "  hat: {cone: {radius: 5 cm, height: 10 cm}, at: [0, 0, 1]}\n"
        "  cup: {cone: {radius: 3 cm, top_radius: 4 cm, height: 10 cm}, at: [0, 0, 1]}\n");
    const auto& sail = std::get<render::TriangleShape>(object(shot, "sail").shape);
    EXPECT_EQ(sail.corners[2], Vec3(0, 2, 1));
    const auto& sheet = std::get<render::ParallelogramShape>(object(shot, "sheet").shape);
    EXPECT_EQ(sheet.corner, Vec3(0, 0, 1));
    EXPECT_EQ(sheet.edge_u, Vec3(1, 0, 0));
    EXPECT_EQ(sheet.edge_v, Vec3(0.5, 2, 0));
    EXPECT_EQ(std::get<render::DiskShape>(object(shot, "plate").shape).radius, 0.2);
    EXPECT_EQ(std::get<render::CylinderShape>(object(shot, "can").shape).height, 0.1);
    EXPECT_EQ(std::get<render::ConeShape>(object(shot, "hat").shape).top_radius, 0);
    EXPECT_EQ(std::get<render::ConeShape>(object(shot, "cup").shape).top_radius, 0.04);
}

TEST(Objects, Smooth_IsAnAngleOfAMesh) {
    const Shot shot = load_sections(
        "objects:\n"
        "  statue: {mesh: files/triangle.obj, smooth: 180 deg, at: [0, 0, 1]}\n");
    EXPECT_NEAR(std::get<render::MeshShape>(object(shot, "statue").shape).smooth_angle,
                std::numbers::pi, 1e-12);
}

TEST(Objects, Transform_IsScaleThenRotateThenAt) {
    const Shot shot = load_sections(
        "objects:\n"
        "  egg: {sphere: 0.5, scale: [1, 2, 3], rotate: [90 deg, 0, 0], at: [0, 0, 1]}\n");
    const Vec3 top = Vec3(0, 0.5, 0) * object(shot, "egg").world_from_object;
    EXPECT_NEAR((top - Vec3(0, 0, 2)).length(), 0, 1e-12);
}

TEST(Objects, Axes_MayShear) {
    const Shot shot = load_sections(
        "objects:\n"
        "  lean: {box: [1, 1, 1], axes: [[1, 0, 0], [0, 1, 0], [0.5, 0, 2]], at: [0, 0, 1]}\n");
    const Vec3 top = Vec3(0, 0, 0.5) * object(shot, "lean").world_from_object;
    EXPECT_NEAR((top - Vec3(0.25, 0, 2)).length(), 0, 1e-12);
}

}  // namespace
}  // namespace carom::pipeline
