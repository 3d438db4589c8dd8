#include "render/frame_scene/static_geometry.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/render/frame_scene/scene_helpers.h"

namespace carom::test {
namespace {

using testing::HasSubstr;

std::string message(const SceneBuilder& builder) {
    try {
        const BuiltScene scene(builder);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(StaticGeometry, UnknownMaterial_NamesObjectAndMaterial) {
    SceneBuilder builder;
    builder.add(SphereShape{}, Mat44(), "", "velvet");
    EXPECT_EQ(message(builder), "object 'object0': the scene has no material 'velvet'");
}

TEST(StaticGeometry, UnknownTrack_NamesObjectAndTrack) {
    SceneBuilder builder;
    builder.add(SphereShape{}, Mat44(), "nine");
    EXPECT_EQ(message(builder),
              "object 'object0' follows the track 'nine', which the timeline does not have");
}

TEST(StaticGeometry, BadSizes_AreRefused) {
    SceneBuilder builder;
    builder.add(SphereShape{-1}, Mat44());
    EXPECT_EQ(message(builder), "object 'object0': the radius must be greater than 0");
    builder.scene.objects[0].shape = BoxShape{Vec3(1, 0, 1)};
    EXPECT_EQ(message(builder), "object 'object0': a box's edge must be greater than 0");
    builder.scene.objects[0].shape =
        RectangleShape{Vec2(1, std::numeric_limits<double>::quiet_NaN())};
    EXPECT_EQ(message(builder), "object 'object0': a rectangle's edge must be greater than 0");
}

TEST(StaticGeometry, BadTransforms_AreRefused) {
    SceneBuilder builder;
    builder.add(SphereShape{}, placed(Vec3(0), Quat(), Vec3(1, 0, 1)));
    EXPECT_THAT(message(builder), HasSubstr("not affine or cannot be inverted"));
    builder.scene.objects[0].world_from_object = Mat44();
    builder.scene.objects[0].world_from_object[0][3] = 0.5;
    EXPECT_THAT(message(builder), HasSubstr("not affine or cannot be inverted"));
    builder.scene.objects[0].world_from_object[3][1] = std::numeric_limits<double>::infinity();
    EXPECT_THAT(message(builder), HasSubstr("a value that is not finite"));
}

TEST(StaticGeometry, BadMeshes_AreRefused) {
    SceneBuilder builder;
    MeshShape mesh = cube_mesh();
    mesh.triangles[3][1] = 99;
    builder.add(mesh, Mat44());
    EXPECT_EQ(message(builder), "mesh of 'object0': triangle 3 refers to vertex 99 of 8");
    mesh.file = "/no/such/mesh.obj";
    builder.scene.objects[0].shape = mesh;
    EXPECT_EQ(message(builder), "'/no/such/mesh.obj': the mesh cannot be opened");
}

TEST(StaticGeometry, Lights_FollowTheObjects) {
    SceneBuilder builder;
    builder.add(SphereShape{}, Mat44());
    builder.scene.lights.push_back({"sky", EnvironmentLight{}});
    builder.scene.lights.push_back({"lamp", RectangleLight{}});
    builder.scene.lights.push_back({"bulb", SphereLight{}});
    const BuiltScene scene(builder);
    EXPECT_EQ(scene.geometry.object_count(), 3u);
    EXPECT_EQ(scene.geometry.light_of_object(0), std::nullopt);
    EXPECT_EQ(scene.geometry.light_of_object(1), 1u);
    EXPECT_EQ(scene.geometry.light_of_object(2), 2u);
    EXPECT_EQ(scene.geometry.object_of_light(0), std::nullopt);
    EXPECT_EQ(scene.geometry.object_of_light(1), 1u);
    EXPECT_EQ(scene.geometry.object_of_light(2), 2u);
    EXPECT_EQ(scene.geometry.name_of_object(1), "lamp");
    EXPECT_EQ(scene.geometry.material_of_object(0), 1u);
    EXPECT_EQ(scene.geometry.material_of_object(1), kNoMaterial);
}

TEST(StaticGeometry, RectangleLight_IsMetFromItsFrontOnly) {
    SceneBuilder builder;
    RectangleLight light;  // at z = 1, radiating down
    builder.scene.lights.push_back({"lamp", light});
    const BuiltScene scene(builder);
    const AccelerationStructure& structure = scene.frame.structure();
    Hit hit;
    const Ray from_below = ray_from(Vec3(0.3, 0.2, 0), Vec3(0.3, 0.2, 2));
    ASSERT_TRUE(structure.closest_hit(from_below, hit));
    EXPECT_FLOAT_EQ(hit.t, 1);
    EXPECT_EQ(scene.geometry.light_of_object(hit.object), 0u);
    EXPECT_EQ(scene.frame.surface_at(from_below, hit).geometric_normal, V3f(0, 0, -1));
    EXPECT_EQ(scene.frame.surface_at(from_below, hit).material, kNoMaterial);
    const Ray from_above = ray_from(Vec3(0.3, 0.2, 2), Vec3(0.3, 0.2, 0));
    EXPECT_FALSE(structure.closest_hit(from_above, hit));
    EXPECT_FALSE(structure.any_hit(from_above));
    EXPECT_TRUE(structure.any_hit(from_below));
    EXPECT_FALSE(structure.any_hit(ray_from(Vec3(0.6, 0.2, 0), Vec3(0.6, 0.2, 2))));
}

TEST(StaticGeometry, SphereLight_IsMetFromAllSides) {
    SceneBuilder builder;
    builder.scene.lights.push_back({"bulb", SphereLight{}});
    const BuiltScene scene(builder);
    TestRandom random(1);
    for (int i = 0; i < 100; ++i) {
        const Vec3 from = Vec3(0, 0, 1) + random_vector(random).normalized();
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray_from(from, Vec3(0, 0, 1)), hit));
        ASSERT_NEAR(hit.t, 0.95f, 1e-5f);
    }
}

TEST(StaticGeometry, EmptyScene_IsFine) {
    const SceneBuilder builder;
    const BuiltScene scene(builder);
    Hit hit;
    EXPECT_FALSE(scene.frame.structure().closest_hit(Ray{}, hit));
}

TEST(StaticGeometry, ComparisonStructure_NamesTheProgramThatMakesIt) {
    RenderSettings settings;
    settings.acceleration = "kay_kajiya";
    std::string text;
    try {
        const StaticGeometry geometry({}, settings);
    } catch (const Error& error) {
        text = error.what();
    }
    EXPECT_THAT(text, HasSubstr("'kay_kajiya'"));
    EXPECT_THAT(text, HasSubstr("carom-lab"));
}

/// A structure that every ray hits.
class Fog final : public AccelerationStructure {
  public:
    [[nodiscard]] bool closest_hit(const Ray& /*ray*/, Hit& /*hit*/) const override { return true; }
    [[nodiscard]] bool any_hit(const Ray& /*ray*/) const override { return true; }
};

TEST(StaticGeometry, Maker_MakesTheStructuresOfFrames) {
    RenderSettings settings;
    settings.acceleration = "fog";
    const StaticGeometry geometry({}, settings, [](const ShapeSet&, std::span<const MeshEntry>) {
        return std::make_unique<Fog>();
    });
    EXPECT_TRUE(FrameScene(geometry, {}, 0, 0).structure().any_hit(Ray{}));
}

}  // namespace
}  // namespace carom::test
