#include <functional>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/store/frame_key.h"
#include "tests/pipeline/video/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ScratchFolder;
using carom::testing::write_text;

render::SceneDescription make_scene(const render::Shape& shape, const render::ColourSource& base) {
    render::SceneDescription scene;
    scene.materials.push_back({"paint", {}});
    scene.materials[0].surface.base = base;
    scene.objects.push_back({"thing", shape, {}, "", "paint"});
    return scene;
}

Hash128 hash_of(const render::Shape& shape, const render::ColourSource& base = Vec3(1, 1, 1)) {
    return hash_scene(make_scene(shape, base));
}

template <class Light>
void add_without_falloff(render::SceneDescription& scene, Light light) {
    light.falloff = render::Falloff::none;
    scene.lights.push_back({"a", light});
}

void expect_all_different(const std::vector<Hash128>& hashes) {
    for (std::size_t i = 0; i < hashes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_NE(hashes[i], hashes[j]) << i << " and " << j;
        }
    }
}

TEST(SceneHash, Shapes_AllCount) {
    render::MeshShape mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    render::MeshShape moved = mesh, flipped = mesh, smooth = mesh, mapped = mesh;
    moved.vertices[0].z = 1e-9;
    flipped.triangles = {{0, 2, 1}};
    smooth.normals.assign(3, {0, 0, 1});
    render::MeshShape smoothed = mesh;
    smoothed.smooth_angle = 0.5;
    mapped.uv.assign(3, {0, 1});
    expect_all_different({hash_of(render::SphereShape{1}),
                          hash_of(render::SphereShape{2}),
                          hash_of(render::BoxShape{}),
                          hash_of(render::BoxShape{{1, 1, 2}}),
                          hash_of(render::PlaneShape{}),
                          hash_of(render::RectangleShape{}),
                          hash_of(render::RectangleShape{{2, 1}}),
                          hash_of(mesh),
                          hash_of(moved),
                          hash_of(flipped),
                          hash_of(smooth),
                          hash_of(mapped),
                          hash_of(smoothed),
                          hash_of(render::TriangleShape{}),
                          hash_of(render::TriangleShape{{Vec3(0), {1, 0, 0}, {0, 2, 0}}}),
                          hash_of(render::ParallelogramShape{}),
                          hash_of(render::ParallelogramShape{Vec3(0), {1, 0, 0}, {0, 2, 0}}),
                          hash_of(render::DiskShape{}),
                          hash_of(render::DiskShape{2}),
                          hash_of(render::CylinderShape{}),
                          hash_of(render::CylinderShape{1, 2}),
                          hash_of(render::ConeShape{}),
                          hash_of(render::ConeShape{1, 0.5, 1}),
                          hash_of(render::CapsuleShape{}),
                          hash_of(render::CapsuleShape{1, 2}),
                          hash_of(render::RoundedBoxShape{}),
                          hash_of(render::RoundedBoxShape{{1, 1, 2}, 0.1}),
                          hash_of(render::RoundedBoxShape{{1, 1, 1}, 0.2})});
}

TEST(SceneHash, Colours_AllCount) {
    const render::SphereShape ball;
    render::BallTexture striped, numbered, spotted;
    striped.striped = true;
    numbered.number = 9;
    spotted.spots = 6;
    expect_all_different(
        {hash_of(ball, Vec3(1, 1, 1)), hash_of(ball, Vec3(1, 1, 0.9)),
         hash_of(ball, render::BallTexture{}), hash_of(ball, striped), hash_of(ball, numbered),
         hash_of(ball, spotted), hash_of(ball, render::ClothTexture{}),
         hash_of(ball, render::ClothTexture{{0.1, 0.1, 0.1}, 0.001, 0.2}),
         hash_of(ball, render::WoodTexture{}), hash_of(ball, render::CheckerTexture{}),
         hash_of(ball, render::CheckerTexture{{1, 1, 1}, {0, 0, 0}, 0.2})});
}

TEST(SceneHash, MaterialAndLights_AllCount) {
    const render::SceneDescription plain = make_scene(render::SphereShape{}, Vec3(1, 1, 1));
    const std::vector<std::function<void(render::SceneDescription&)>> changes{
        [](auto&) {},
        [](auto& s) { s.materials[0].surface.metal = 1; },
        [](auto& s) { s.materials[0].surface.roughness = 0.1; },
        [](auto& s) { s.materials[0].surface.specular = 0.1; },
        [](auto& s) { s.materials[0].surface.sheen = 0.1; },
        [](auto& s) { s.materials[0].surface.transmission = 0.1; },
        [](auto& s) { s.materials[0].surface.ior = 1.1; },
        [](auto& s) {
            s.materials[0].surface.transmission_colour = {1, 0, 0};
        },
        [](auto& s) { s.materials[0].surface.transmission_depth = 0.1; },
        [](auto& s) {
            s.materials[0].surface.sheen_colour = {1, 0, 0};
        },
        [](auto& s) { s.materials[0].surface.bump = 0.1; },
        [](auto& s) { s.materials[0].surface.coat.weight = 0.1; },
        [](auto& s) { s.materials[0].surface.coat.ior = 1.1; },
        [](auto& s) { s.materials[0].surface.coat.roughness = 0.1; },
        [](auto& s) { s.materials[0].phong.emplace(); },
        [](auto& s) { s.materials[0].phong.emplace().diffuse = Vec3(1, 0, 0); },
        [](auto& s) { s.materials[0].phong.emplace().ambient = Vec3(0, 0, 0); },
        [](auto& s) { s.materials[0].phong.emplace().ambient = Vec3(1, 0, 0); },
        [](auto& s) { s.materials[0].phong.emplace().specular = Vec3(1, 0, 0); },
        [](auto& s) { s.materials[0].phong.emplace().shininess = 30; },
        [](auto& s) { s.materials[0].phong.emplace().reflectance = Vec3(1, 0, 0); },
        [](auto& s) { s.materials[0].phong.emplace().reflectance_spread = 0.1; },
        [](auto& s) { s.materials[0].phong.emplace().transmittance = Vec3(1, 0, 0); },
        [](auto& s) { s.materials[0].phong.emplace().transmittance_spread = 0.1; },
        [](auto& s) { s.materials[0].phong.emplace().index = 1.4; },
        [](auto& s) { s.objects[0].world_from_object[3][0] = 1; },
        [](auto& s) { s.objects[0].track = "cue"; },
        [](auto& s) {
            s.lights.push_back({"a", render::SphereLight{}});
        },
        [](auto& s) {
            s.lights.push_back({"a", render::SphereLight{{0, 0, 2}, 0.05, {1, 1, 1}}});
        },
        [](auto& s) {
            s.lights.push_back({"a", render::RectangleLight{}});
        },
        [](auto& s) {
            s.lights.push_back({"a", render::EnvironmentLight{}});
        },
        [](auto& s) {
            s.lights.push_back({"a", render::EnvironmentLight{{1, 1, 1}, "", 1, {}}});
        },
        [](auto& s) {
            s.lights.push_back({"a", render::EnvironmentLight{{1, 1, 1}, "", 0, render::Sky{}}});
        },
        [](auto& s) {
            render::Sky hazy;
            hazy.turbidity = 5;
            s.lights.push_back({"a", render::EnvironmentLight{{1, 1, 1}, "", 0, hazy}});
        },
        [](auto& s) {
            render::Sky low;
            low.sun = {1, 0, 0.2};
            s.lights.push_back({"a", render::EnvironmentLight{{1, 1, 1}, "", 0, low}});
        },
        [](auto& s) {
            render::Sky snow;
            snow.ground = {0.8, 0.8, 0.8};
            s.lights.push_back({"a", render::EnvironmentLight{{1, 1, 1}, "", 0, snow}});
        },
        [](auto& s) {
            s.lights.push_back({"a", render::PointLight{}});
        },
        [](auto& s) {
            s.lights.push_back({"a", render::PointLight{{0, 0, 1}, {1, 2, 1}}});
        },
        [](auto& s) {
            s.lights.push_back({"a", render::SpotLight{}});
        },
        [](auto& s) {
            s.lights.push_back(
                {"a", render::SpotLight{{0, 0, 1}, {0, 0, -1}, {1, 1, 1}, 0.2, 0.4}});
        },
        [](auto& s) {
            s.lights.push_back(
                {"a", render::SpotLight{{0, 0, 1}, {0, 1, -1}, {1, 1, 1}, 0.3, 0.4}});
        },
        [](auto& s) {
            s.lights.push_back({"a", render::DirectionalLight{}});
        },
        [](auto& s) { add_without_falloff(s, render::PointLight{}); },
        [](auto& s) { add_without_falloff(s, render::SpotLight{}); },
        [](auto& s) { add_without_falloff(s, render::RectangleLight{}); },
        [](auto& s) { add_without_falloff(s, render::SphereLight{}); },
        [](auto& s) {
            s.lights.push_back({"a", render::DirectionalLight{{0, 1, -1}, {1, 1, 1}}});
        },
    };
    std::vector<Hash128> hashes;
    for (const auto& change : changes) {
        render::SceneDescription scene = plain;
        change(scene);
        hashes.push_back(hash_scene(scene));
    }
    expect_all_different(hashes);
}

TEST(SceneHash, Files_CountByContents) {
    const ScratchFolder folder;
    write_text(folder.path("a.png"), "one picture");
    write_text(folder.path("b.png"), "one picture");
    write_text(folder.path("c.png"), "another");
    const auto textured = [&](const std::string& name) {
        return hash_of(render::SphereShape{},
                       render::ImageTexture{folder.path(name), {1, 1}, false});
    };
    EXPECT_EQ(textured("a.png"), textured("b.png"));
    EXPECT_NE(textured("a.png"), textured("c.png"));
    EXPECT_THROW((void)textured("missing.png"), Error);
    const Hash128 before = textured("a.png");
    write_text(folder.path("a.png"), "changed");
    EXPECT_NE(textured("a.png"), before);
}

TEST(SceneHash, UnknownMaterial_IsAnErrorNamingIt) {
    render::SceneDescription scene = make_scene(render::SphereShape{}, Vec3(1, 1, 1));
    scene.objects[0].material = "velvet";
    try {
        (void)hash_scene(scene);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "object 'thing' has the material 'velvet', which the scene does not describe");
    }
}

}  // namespace
}  // namespace carom::pipeline
