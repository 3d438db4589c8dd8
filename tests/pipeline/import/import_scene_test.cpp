// Tests of the conversion of scene texts.
#include "pipeline/import/import_scene.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/load_shot.h"
#include "render/integrator/distributed_ray_counts.h"
#include "sim/bake.h"
#include "tests/folders.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

const std::string kSample = CAROM_SOURCE_DIR "/tests/examples/sample_scene.txt";
const std::string kCamera =
    "camera C { video_end 1 add_position { 0 0 -90 } add_target { 0 0 10 } DOF_end 40 }\n";

/// The shot made from the text. If there is none, the test fails with the reason.
Shot shot_of(const ImportResult& imported) {
    std::string problems;
    for (const Problem& problem : imported.problems) {
        problems += format(problem);
    }
    const LoadResult loaded = load_shot_text(imported.yaml, "/nowhere/shot.yaml");
    for (const Problem& problem : loaded.problems) {
        problems += format(problem);
    }
    EXPECT_TRUE(loaded.shot) << problems << imported.yaml;
    EXPECT_EQ(problems, "");
    return loaded.shot.value_or(Shot{});
}

Shot shot_of(const std::string& text, const ImportOptions& options = {}) {
    return shot_of(import_scene(text, "scene.txt", "/nowhere", "/nowhere", options));
}

Shot sample(const ImportOptions& options = {}) {
    return shot_of(import_scene_file(kSample, "/nowhere", options));
}

bool has_note(const ImportResult& result, const std::string& part) {
    return std::any_of(result.notes.begin(), result.notes.end(), [&](const std::string& note) {
        return note.find(part) != std::string::npos;
    });
}

#define EXPECT_NEAR_VEC(a, b, bound)                                                               \
    EXPECT_LT(((a) - (b)).length(), bound) << (a).x << " " << (a).y << " " << (a).z << " against " \
                                           << (b).x << " " << (b).y << " " << (b).z

Vec3 bezier_point(const CameraPath& path, std::size_t index) {
    return std::get<BezierPath>(path).points.at(index).offset;
}

const render::ObjectDescription& object(const Shot& shot, const std::string& name) {
    for (const render::ObjectDescription& object : shot.scene.objects) {
        if (object.name == name) {
            return object;
        }
    }
    throw std::runtime_error("no object " + name);
}

Vec3 placed(const render::ObjectDescription& object, const Vec3& point) {
    Vec3 result;
    object.world_from_object.multVecMatrix(point, result);
    return result;
}

TEST(ImportSample, Cameras_BecomeRigs) {
    const Shot shot = sample();
    ASSERT_EQ(shot.cameras.size(), 2U);
    const CameraRig& forward = shot.cameras[0];
    EXPECT_EQ(forward.name, "Forward");
    // The text has y up and centimetres, the shot z up and metres.
    ASSERT_EQ(std::get<BezierPath>(forward.position).points.size(), 3U);
    EXPECT_NEAR_VEC(bezier_point(forward.position, 0), Vec3(1.1, -0.9, 0.3), 1e-12);
    EXPECT_NEAR_VEC(bezier_point(forward.target, 1), Vec3(0.4, -0.4, 0.02), 1e-12);
    EXPECT_EQ(forward.focus.start.distance, 0.6);
    EXPECT_EQ(forward.focus.end.distance, 0.5);
    EXPECT_EQ(forward.aperture.start.value, 0.0015);
    // 320 x 240 pixels on a plane at distance 2 that is four units wide and three high.
    EXPECT_NEAR(std::tan(forward.fov.start / 2), 1.5 / 2, 1e-9);
    EXPECT_NEAR(std::tan(forward.fov.end / 2), 1.5 / 3, 1e-9);
    const CameraRig& backward = shot.cameras[1];
    EXPECT_EQ(backward.video_start, Rational(2));
    EXPECT_EQ(backward.time_map.scene_start, Rational(2));
    EXPECT_EQ(backward.time_map.scene_end, Rational(0));
    EXPECT_FALSE(backward.focus.start.distance);
    EXPECT_EQ(backward.focus.start.object, "");  // on the target
}

TEST(ImportSample, FovByTheFormula_GrowsWithTheNumber) {
    ImportOptions options;
    options.field_of_view = FieldOfView::formula;
    const CameraRig forward = sample(options).cameras[0];
    EXPECT_NEAR(std::tan(forward.fov.start / 2), 0.75 * 2 / 2, 1e-9);
    EXPECT_NEAR(std::tan(forward.fov.end / 2), 0.75 * 3 / 2, 1e-9);
}

TEST(ImportSample, SkyVectors_BecomeUpAndRoll) {
    const CameraRig rig = sample().cameras[1];
    const Vec3 forward = (bezier_point(rig.target, 0) - bezier_point(rig.position, 0)).normalized();
    const Vec3 level = forward.cross(rig.up.start).normalized();
    const Vec3 upright = level.cross(forward);
    // The camera's up vector, computed as in thin_lens_camera.cpp.
    const Vec3 up = upright * std::cos(rig.roll.end) - level * std::sin(rig.roll.end);
    const Vec3 sky = Vec3(0.2, 0, 1);
    const Vec3 wanted = (sky - forward * forward.dot(sky)).normalized();
    EXPECT_NEAR_VEC(up, wanted, 1e-8);
    EXPECT_GT(std::abs(rig.roll.end), 0.05);
    EXPECT_EQ(rig.roll.start, 0);
}

TEST(ImportSample, Settings_BecomeDistributedIntegratorSettings) {
    const Shot shot = sample();
    EXPECT_EQ(shot.render.width, 320);
    EXPECT_EQ(shot.render.height, 240);
    EXPECT_EQ(shot.timing.fps, Rational(12));
    EXPECT_EQ(shot.timing.shutter.exposure, Rational(1, 12));  // -1: one frame
    EXPECT_EQ(shot.timing.shutter.switch_ratio, 0.3);
    EXPECT_EQ(shot.render.integrator, render::IntegratorKind::distributed);
    const render::DistributedSettings& rays = shot.render.distributed;
    EXPECT_EQ(rays.pixel_samples, 1);
    EXPECT_EQ(rays.blur_samples, 16);
    EXPECT_EQ(rays.lens_samples, 8);
    EXPECT_EQ(rays.shadow_samples, 4);
    EXPECT_EQ(rays.reflection_samples, 2);
    EXPECT_EQ(rays.refraction_samples, 1);  // 0 in the text, but Amber refracts
    EXPECT_EQ(rays.recursion_limit, 2);
    EXPECT_EQ(rays.ambient_coefficient, 0.12);
    EXPECT_EQ(shot.output.view, ViewTransform::raw);
}

TEST(ImportSample, Materials_BecomePhongMaterials) {
    const Shot shot = sample();
    const auto amber = std::find_if(shot.scene.materials.begin(), shot.scene.materials.end(),
                                    [](const auto& material) { return material.name == "Amber"; });
    ASSERT_NE(amber, shot.scene.materials.end());
    ASSERT_TRUE(amber->phong);
    EXPECT_EQ(amber->phong->ambient, Vec3(0.6, 0.3, 0));
    EXPECT_EQ(std::get<Vec3>(amber->phong->diffuse), Vec3(0.6, 0.3, 0.02));
    EXPECT_EQ(amber->phong->specular, Vec3(0.6, 0.6, 0.6));
    EXPECT_EQ(amber->phong->shininess, 25);
    EXPECT_EQ(amber->phong->reflectance, Vec3(0.2, 0.2, 0.2));
    EXPECT_EQ(amber->phong->reflectance_spread, 0.2);
    EXPECT_EQ(amber->phong->transmittance, Vec3(0.4, 0.4, 0.4));
    EXPECT_EQ(amber->phong->transmittance_spread, 0.05);
    EXPECT_EQ(amber->phong->index, 1.4);
}

TEST(ImportSample, Forces_BecomeImpulsesThatGiveTheAuthorsVelocity) {
    ImportOptions options;
    options.unit = 0.02;
    options.force_time = 0.1;
    const Shot shot = sample(options);
    ASSERT_EQ(shot.world.events.size(), 2U);
    const auto body = std::find_if(shot.world.bodies.begin(), shot.world.bodies.end(),
                                   [](const sim::Body& b) { return b.name == "Striker"; });
    ASSERT_NE(body, shot.world.bodies.end());
    const auto& impulse = std::get<sim::Impulse>(shot.world.events[0].action);
    // A sphere of radius 4 with density 1, pushed for 0.1 s; the unit is 2 cm.
    const double mass = 4.0 / 3 * M_PI * 64;
    const Vec3 velocity = Vec3(90000, -2000, 0) * (0.1 / mass) * 0.02;
    EXPECT_NEAR_VEC(impulse.newton_seconds / body->mass, velocity, 1e-6 * velocity.length());
}

// Lights of the format do not fall off with distance. A surface of diffuse colour k that faces a
// light has the radiance k times its colour.
TEST(ImportSample, Lights_GiveTheirColourAtEveryDistance) {
    const Shot shot = sample();
    const auto& bulb = std::get<render::SphereLight>(shot.scene.lights[1].light);
    EXPECT_EQ(bulb.falloff, render::Falloff::none);
    EXPECT_EQ(bulb.radiance, Vec3(0.4, 0.35, 0.3));
    EXPECT_NEAR(bulb.radius, 0.04, 1e-12);
    const auto& lamp = std::get<render::RectangleLight>(shot.scene.lights[0].light);
    EXPECT_EQ(lamp.falloff, render::Falloff::none);
    EXPECT_EQ(lamp.radiance, Vec3(0.9, 0.9, 0.8));
    EXPECT_NEAR_VEC(lamp.centre, Vec3(0.7, -0.5, 0.8), 1e-9);
    EXPECT_NEAR(lamp.edge_u.length(), 0.2, 1e-9);
    EXPECT_NEAR(std::abs(lamp.edge_u.normalized().x), 1, 1e-9);
    EXPECT_NEAR_VEC(lamp.normal, Vec3(0, 0, -1), 1e-9);
}

TEST(Import, PointLight_GivesItsColourAtEveryDistance) {
    const Shot shot = shot_of(kCamera + "light_point P { position { 0 90 0 } color { 1 0.5 0 } }");
    const auto& point = std::get<render::PointLight>(shot.scene.lights.at(0).light);
    EXPECT_EQ(point.falloff, render::Falloff::none);
    EXPECT_NEAR_VEC(point.intensity, Vec3(M_PI, M_PI / 2, 0), 1e-8);
    EXPECT_NEAR_VEC(point.position, Vec3(0, 0, 0.9), 1e-12);
}

TEST(Import, BoxesAndRectangles_FollowTheirVertices) {
    const Shot shot =
        shot_of(kCamera +
                "box B { vertex0 { 10 0 0 } vertex1 { 13 4 0 } vertex2 { 0 0 20 } heigth 2 }"
                "rectangle R { vertex0 { 1 1 1 } position1 { 1 5 1 } vertex2 { 3 2 1 } }"
                "plane P { normal { 1 0 0 } position { -3 0 0 } }");
    const auto& box = object(shot, "B");
    const Vec3 half = std::get<render::BoxShape>(box.shape).size / 2;
    EXPECT_NEAR_VEC(half * 2, Vec3(0.05, std::sqrt(464) * 0.01, 0.02), 1e-8);
    // The edge from vertex0 to vertex1, in carom's axes, is an edge of the box.
    const Vec3 edge = placed(box, Vec3(half.x, 0, 0)) - placed(box, Vec3(-half.x, 0, 0));
    EXPECT_NEAR_VEC(edge, Vec3(0.03, 0, 0.04), 1e-8);
    // vertex0 and vertex1 are two of its corners.
    for (const Vec3& corner : {Vec3(0.1, 0, 0), Vec3(0.13, 0, 0.04)}) {
        double nearest = 1;
        for (int i = 0; i < 8; ++i) {
            const Vec3 local(half.x * ((i & 1) != 0 ? 1 : -1), half.y * ((i & 2) != 0 ? 1 : -1),
                             half.z * ((i & 4) != 0 ? 1 : -1));
            nearest = std::min(nearest, (placed(box, local) - corner).length());
        }
        EXPECT_LT(nearest, 1e-8);
    }
    const auto& rectangle = object(shot, "R");
    const Vec2 size = std::get<render::RectangleShape>(rectangle.shape).size;
    EXPECT_NEAR(size.x, 0.04, 1e-9);
    EXPECT_NEAR(size.y, 0.02, 1e-9);  // vertex2 is a point of the opposite side, not a corner
    EXPECT_NEAR_VEC(placed(rectangle, Vec3(-size.x / 2, -size.y / 2, 0)), Vec3(0.01, -0.01, 0.01),
                    1e-8);
    const auto& plane = object(shot, "P");
    EXPECT_NEAR_VEC(placed(plane, Vec3(0, 0, 1)) - placed(plane, Vec3(0, 0, 0)), Vec3(1, 0, 0),
                    1e-8);
}

TEST(Import, BallThatPenetratesTheTable_IsMovedOut) {
    const ImportResult result = import_scene(
        kCamera +
            "box ground { vertex0 { 0 -5 0 } vertex1 { 200 -5 0 } vertex2 { 200 -5 100 } heigth 5 "
            "use_physics 1 } sphere Ball { position { 60 3.8 54.5 } radius 4 use_physics 1 }",
        "scene.txt", "/nowhere", "/nowhere");
    EXPECT_TRUE(has_note(result, "overlapped box 'ground' by 0.2"));
    const Shot shot = shot_of(result);
    const auto ball = std::find_if(shot.world.bodies.begin(), shot.world.bodies.end(),
                                   [](const sim::Body& b) { return b.name == "Ball"; });
    EXPECT_NEAR(ball->pose.position.z, 0.04, 1e-6);
}

TEST(Import, SphereAxes_BecomeItsRotation) {
    const Shot shot =
        shot_of(kCamera + "sphere S { position { 0 0 0 } radius 4 v_e { 0 1 0 } v_n { 1 0 1 } }");
    const auto& sphere = object(shot, "S");
    EXPECT_NEAR_VEC(placed(sphere, Vec3(0, 0, 1)), Vec3(1, -1, 0).normalized(), 1e-8);  // the pole
    EXPECT_NEAR_VEC(placed(sphere, Vec3(1, 0, 0)), Vec3(0, 0, 1), 1e-8);  // where u is 0
}

TEST(Import, WithoutLights_OneIsAddedAboveTheCamera) {
    const ImportResult result = import_scene(kCamera, "scene.txt", "/nowhere", "/nowhere");
    EXPECT_TRUE(has_note(result, "a light above the camera was added"));
    const Shot shot = shot_of(result);
    ASSERT_EQ(shot.scene.lights.size(), 1U);
    const auto& light = std::get<render::PointLight>(shot.scene.lights[0].light);
    EXPECT_EQ(light.falloff, render::Falloff::none);
    EXPECT_NEAR_VEC(light.intensity, Vec3(M_PI), 1e-8);
}

TEST(Import, MissingImages_AreReplacedByTheColourAndNoted) {
    const ImportResult result =
        import_scene(kCamera +
                         "texture T { filename gone.tga } phong_info P { diffuse { 1 0 0 } } "
                         "material_texture M { phong_info P texture T scale_U 0.5 scale_V 1 } "
                         "sphere S { position { 0 0 0 } radius 1 material M }",
                     "scene.txt", "/nowhere", "/nowhere");
    EXPECT_TRUE(has_note(result, "no file 'gone.tga'"));
    const Shot shot = shot_of(result);
    EXPECT_EQ(std::get<Vec3>(shot.scene.materials[0].phong->diffuse), Vec3(1, 0, 0));
}

/// A shot with a picture of the given scale on objects, and the note of its import.
class PictureImport {
  public:
    explicit PictureImport(const std::string& scale, const std::string& objects,
                           double unit = 0.01) {
        const std::string folder = folder_.path();
        std::ofstream(folder_.path("ball.tga")) << "any";
        ImportOptions options;
        options.unit = unit;
        result = import_scene(kCamera +
                                  "texture T { filename ball.tga } phong_info P { diffuse { 1 0 0 "
                                  "} } material_texture M { phong_info P texture T " +
                                  scale + " }" + objects,
                              "scene.txt", folder, folder, options);
        const LoadResult loaded = load_shot_text(result.yaml, folder_.path("shot.yaml"));
        EXPECT_TRUE(loaded.shot) << result.yaml;
        shot = loaded.shot.value_or(Shot{});
    }

    [[nodiscard]] render::ImageTexture on(const std::string& name) const {
        for (const render::MaterialDescription& material : shot.scene.materials) {
            if (material.name == object(shot, name).material) {
                return std::get<render::ImageTexture>(material.phong->diffuse);
            }
        }
        throw std::runtime_error("no material on " + name);
    }

    ImportResult result;
    Shot shot;

  private:
    carom::testing::ScratchFolder folder_;
};

TEST(Import, ImagesOnSpheres_RepeatAccordingToTheirScale) {
    const PictureImport imported("scale_U 0.5 scale_V -1",
                                 "sphere S { position { 0 0 0 } radius 1 material M }");
    const render::ImageTexture image = imported.on("S");
    EXPECT_EQ(image.scale, Vec2(2, 1));
    EXPECT_TRUE(image.is_linear);
    EXPECT_NE(imported.result.yaml.find("file: \"ball.tga\""), std::string::npos);
}

TEST(Import, ImagesOnFlatShapes_SpanTheirScaleInUnits) {
    const PictureImport imported(
        "scale_U 20 scale_V 10",
        "sphere S { position { 0 0 0 } radius 1 material M }"
        "plane P { normal { 0 1 0 } position { 0 0 0 } material M }"
        "rectangle R { vertex0 { 0 0 0 } vertex1 { 20 0 0 } vertex2 { 20 10 0 } material M }"
        "box B { vertex0 { 0 0 0 } vertex1 { 20 0 0 } vertex2 { 20 0 10 } height 2 material M }",
        0.02);
    EXPECT_FALSE(imported.on("S").size);
    EXPECT_EQ(imported.on("S").scale, Vec2(0.05, 0.1));
    for (const char* name : {"P", "R", "B"}) {
        ASSERT_TRUE(imported.on(name).size) << name;
        EXPECT_NEAR(imported.on(name).size->x, 0.4, 1e-9) << name;
        EXPECT_NEAR(imported.on(name).size->y, 0.2, 1e-9) << name;
        EXPECT_EQ(object(imported.shot, name).material, "M_on_plane") << name;
    }
    EXPECT_TRUE(has_note(imported.result, "in units of the scene"));
}

TEST(Import, ImagesWithoutScale_CoverTheirRectangle) {
    const PictureImport imported(
        "scale_V 5",
        "rectangle R { vertex0 { 0 0 0 } vertex1 { 20 0 0 } vertex2 { 3 10 0 } material M }"
        "rectangle Q { vertex0 { 0 0 0 } vertex1 { 40 0 0 } vertex2 { 3 10 0 } material M }");
    EXPECT_NEAR(imported.on("R").size->x, 0.2, 1e-9);
    EXPECT_NEAR(imported.on("R").size->y, 0.05, 1e-9);
    EXPECT_NEAR(imported.on("Q").size->x, 0.4, 1e-9);
}

TEST(Import, InvalidNames_AreChanged) {
    const ImportResult result = import_scene(kCamera +
                                                 "sphere 8ball! { position { 0 0 0 } radius 1 }"
                                                 "sphere 8ball? { position { 0 5 0 } radius 1 }"
                                                 "sphere all { position { 0 9 0 } radius 1 }",
                                             "scene.txt", "/nowhere", "/nowhere");
    EXPECT_TRUE(has_note(result, "object '8ball?' is called n_8ball__2 in the shot"));
    const Shot shot = shot_of(result);
    EXPECT_EQ(object(shot, "n_8ball_").name, "n_8ball_");
    EXPECT_EQ(object(shot, "n_8ball__2").name, "n_8ball__2");
    EXPECT_EQ(object(shot, "n_all").name, "n_all");
}

std::string sphere_text(const std::string& name) {
    return "sphere " + name + " { position { 0 0 0 } radius 1 }\n";
}

std::vector<std::string> object_names(const ImportResult& result) {
    std::vector<std::string> names;
    for (const render::ObjectDescription& object : shot_of(result).scene.objects) {
        names.push_back(object.name);
    }
    return names;
}

TEST(Import, Accents_AreLeftOut_AndNamesStayDifferent) {
    const ImportResult result =
        import_scene(kCamera + sphere_text("skleněný_materiál") + sphere_text("kč") +
                         sphere_text("kř") + sphere_text("Größe") + sphere_text("kc") +
                         sphere_text("шар") + sphere_text("мяч") + sphere_text("A\u0301bc"),
                     "scene.txt", "/nowhere", "/nowhere");
    EXPECT_THAT(object_names(result),
                ::testing::ElementsAre("skleneny_material", "kc_2", "kr", "Grosse", "kc", "___",
                                       "____2", "Abc"));
    EXPECT_TRUE(has_note(result, "object 'kč' is called kc_2 in the shot"));
    EXPECT_FALSE(has_note(result, "object 'kc' "));
}

TEST(Import, TextsThatAreNotUtf8_AreReadAsWindows1250) {
    // "kč" and "kř" in Windows-1250, whose second letters are not UTF-8.
    const ImportResult result = import_scene(kCamera + sphere_text("k\xe8") + sphere_text("k\xf8"),
                                             "scene.txt", "/nowhere", "/nowhere");
    EXPECT_THAT(object_names(result), ::testing::ElementsAre("kc", "kr"));
    EXPECT_TRUE(has_note(result, "it was read as Windows-1250"));
}

const sim::Body* find_body(const Shot& shot, const std::string& name) {
    const auto found = std::ranges::find(shot.world.bodies, name, &sim::Body::name);
    return found == shot.world.bodies.end() ? nullptr : &*found;
}

bool is_moving(const Shot& shot, const std::string& name) {
    const sim::Body* body = find_body(shot, name);
    EXPECT_NE(body, nullptr) << name;
    return body != nullptr && body->kind == sim::BodyKind::dynamic;
}

const std::string kTable =
    "box Table { vertex0 { 0 -5 0 } vertex1 { 200 -5 0 } vertex2 { 200 -5 100 } heigth 5 "
    "use_physics 1 }\n"
    "box Cushion { vertex0 { 0 0 0 } vertex1 { 90 0 0 } vertex2 { 90 0 4 } height 4 use_physics 1 "
    "}\n"
    "box Crate { vertex0 { 20 30 50 } vertex1 { 30 30 50 } vertex2 { 30 30 60 } height 8 "
    "use_physics 1 }\n"
    "box Shelf { vertex0 { 20 60 50 } vertex1 { 30 60 50 } vertex2 { 30 60 60 } height 8 }\n";

TEST(Import, BoxesThatUsePhysics_MoveUnlessTheyAreTheGroundOrLarge) {
    const Shot shot = shot_of(kCamera + kTable);
    EXPECT_FALSE(is_moving(shot, "Table"));
    EXPECT_FALSE(is_moving(shot, "Cushion"));
    EXPECT_TRUE(is_moving(shot, "Crate"));
    EXPECT_EQ(find_body(shot, "Shelf"), nullptr);
    const sim::Timeline timeline = sim::bake(shot.world);
    EXPECT_LT(timeline.find("Crate")->sample(1).position.z, 0.05);  // it fell onto the table
    const ImportResult result = import_scene(kCamera + kTable, "scene.txt", "/nowhere", "/nowhere");
    EXPECT_TRUE(has_note(result, "box 'Table' uses physics and is fixed"));
    EXPECT_TRUE(has_note(result, "box 'Crate' uses physics and moves"));
}

TEST(Import, BoxesByOption_AllMoveOrNone) {
    ImportOptions options;
    options.boxes = BoxMotion::fixed;
    EXPECT_FALSE(is_moving(shot_of(kCamera + kTable, options), "Crate"));
    options.boxes = BoxMotion::dynamic;
    EXPECT_TRUE(is_moving(shot_of(kCamera + kTable, options), "Table"));
}

TEST(Import, ABoxWithNothingAbove_Falls) {
    const Shot shot = shot_of(
        kCamera +
        "box B { vertex0 { 0 10 0 } vertex1 { 4 10 0 } vertex2 { 4 10 4 } height 4 use_physics 1 }"
        "plane P { normal { 0 1 0 } position { 0 0 0 } }");
    EXPECT_TRUE(is_moving(shot, "B"));
}

TEST(Import, InterpolateSamples_AreTheSideOfASquare) {
    EXPECT_EQ(
        shot_of(kCamera + "settings S { interpolate_samples 3 }").render.distributed.pixel_samples,
        9);
    EXPECT_EQ(
        shot_of(kCamera + "settings S { interpolate_samples 0 }").render.distributed.pixel_samples,
        1);
}

TEST(Import, CountsOfZero_SendNoRaysIfNothingReflectsOrRefracts) {
    const std::string settings =
        "settings S { diffuse_reflection_samples 0 diffuse_refraction_samples 0 }";
    const auto rays = [&](const std::string& phong) {
        return shot_of(kCamera + settings + "phong_info P { " + phong + " }").render.distributed;
    };
    EXPECT_EQ(rays("").reflection_samples, 0);
    EXPECT_EQ(rays("").refraction_samples, 0);
    EXPECT_EQ(rays("reflectance 0.1").reflection_samples, 1);
    EXPECT_EQ(rays("refraction 0.1").refraction_samples, 1);
}

/// In how many pictures of the film the whole sphere is within the frame.
int frames_with_whole_sphere(const Shot& shot, const std::string& name, double radius) {
    const sim::Timeline timeline = sim::bake(shot.world);
    const double aspect = static_cast<double>(shot.render.width) / shot.render.height;
    int count = 0;
    for (std::int64_t n = 0; n < frame_count(shot.cameras, shot.timing); ++n) {
        const PlannedFrame frame = plan_frame(n, shot.cameras, shot.timing, timeline);
        const render::CameraState& camera = frame.camera_open;
        const Vec3 forward = (camera.target - camera.position).normalized();
        const Vec3 right = forward.cross(camera.up).normalized();
        const Vec3 way = timeline.find(name)->sample(frame.scene_time).position - camera.position;
        const double depth = way.dot(forward);
        const double tangent = std::tan(camera.vertical_fov / 2);
        // The distances of the centre from the side and the top of the field of view.
        const auto inside = [&](const Vec3& axis, double half) {
            return (half * depth - std::abs(way.dot(axis))) / std::hypot(1, half) >= radius;
        };
        count += inside(right, tangent * aspect) && inside(right.cross(forward), tangent) ? 1 : 0;
    }
    return count;
}

TEST(ImportOfTheManualsExample, ShowsItsBallByBothMeaningsOfFov) {
    const std::string scene = CAROM_SOURCE_DIR "/examples/texts/manual.txt";
    const Shot shot = shot_of(import_scene_file(scene, "/nowhere"));
    EXPECT_EQ(frame_count(shot.cameras, shot.timing), 16);
    EXPECT_EQ(frames_with_whole_sphere(shot, "BallRed", 0.04), 6);
    EXPECT_FALSE(is_moving(shot, "ground"));
    ImportOptions options;
    options.field_of_view = FieldOfView::formula;
    const Shot wide = shot_of(import_scene_file(scene, "/nowhere", options));
    EXPECT_EQ(frames_with_whole_sphere(wide, "BallRed", 0.04), 7);
}

TEST(ImportOfTheManualsExample, IsTheExampleShot) {
    const std::string folder = CAROM_SOURCE_DIR "/examples/texts";
    std::ifstream stream(folder + "/manual.yaml");
    const std::string shot{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_EQ(import_scene_file(folder + "/manual.txt", folder).yaml, shot);
}

TEST(ImportOfTheManualsExample, HasTheNumberOfRaysOfItsFormula) {
    const Shot shot =
        shot_of(import_scene_file(CAROM_SOURCE_DIR "/examples/texts/manual.txt", "/nowhere"));
    // Formula 6.2: 32 x 18 (2 + 2 x 2 x (2 + 0)) for each pixel.
    EXPECT_EQ(render::rays_by_classic_formula(shot.render.distributed, shot.scene.lights.size()),
              32 * 18 * 10);
}

TEST(Import, GapsInTheFilm_AreClosed) {
    const ImportResult result =
        import_scene(kCamera +
                         "camera D { video_start 3 video_end 4 time_start 5 time_end 6 "
                         "add_position { 0 0 -9 } add_target { 0 0 1 } }",
                     "scene.txt", "/nowhere", "/nowhere");
    EXPECT_TRUE(has_note(result, "the gap of 2 s before camera"));
    const Shot shot = shot_of(result);
    EXPECT_EQ(shot.cameras[1].video_start, Rational(1));
    EXPECT_EQ(shot.cameras[1].time_map.scene_start, Rational(5));
}

}  // namespace
}  // namespace carom::pipeline
