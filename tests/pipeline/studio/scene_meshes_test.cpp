// The meshes of the view and the name that they have.
#include "pipeline/studio/scene_meshes.h"

#include <chrono>
#include <filesystem>

#include "pipeline/export/export_scene.h"
#include "pipeline/studio/lighter_meshes.h"
#include "tests/pipeline/export/glb_reader.h"
#include "tests/pipeline/export/picture_files.h"

namespace carom::studio {
namespace {

using carom::testing::Glb;
using carom::testing::PictureFiles;
using carom::testing::Pixel;

class SceneMeshes : public PictureFiles {
  protected:
    /// A sphere with a picture.
    static pipeline::Shot painted(const std::string& file) {
        pipeline::Shot shot;
        render::ImageTexture picture;
        picture.file = file;
        render::MaterialDescription material;
        material.name = "paint";
        material.surface.base = picture;
        shot.scene.materials.push_back(material);
        render::ObjectDescription object;
        object.name = "globe";
        object.shape = render::SphereShape{1};
        object.material = "paint";
        shot.scene.objects.push_back(object);
        return shot;
    }
};

TEST_F(SceneMeshes, HashOfMeshes_FollowsTexturesAndTheirFiles) {
    const std::string file = png("paint.png", 1, {{200, 0, 0}});
    pipeline::Shot shot = painted(file);
    const Hash128 before = hash_meshes(shot);
    EXPECT_EQ(hash_meshes(shot), before);
    std::filesystem::last_write_time(
        file, std::filesystem::last_write_time(file) + std::chrono::seconds(5));
    const Hash128 of_new_file = hash_meshes(shot);
    EXPECT_NE(of_new_file, before);
    auto& picture = std::get<render::ImageTexture>(shot.scene.materials[0].surface.base);
    picture.placement.mapping = render::Mapping::spherical;
    EXPECT_NE(hash_meshes(shot), of_new_file);
}

TEST_F(SceneMeshes, LargePicture_HasAtMost1024PixelsASide) {
    const std::string file =
        png("paint.png", 2048, std::vector<Pixel>(std::size_t{2048} * 2, {200, 100, 50}));
    MeshFiles files;
    const Glb glb(*files.find(files.add(painted(file))));
    const auto& pbr = glb.material("paint")["pbrMetallicRoughness"];
    EXPECT_EQ(pixels_of(glb.picture(pbr["baseColorTexture"])),
              std::vector<Pixel>(1024, {200, 100, 50, 255}));
}

TEST_F(SceneMeshes, MissingPicture_IsNoReasonToShowNothing) {
    MeshFiles files;
    const Glb glb(*files.find(files.add(painted("/nowhere.png"))));
    EXPECT_FALSE(glb.json.contains("images"));
    EXPECT_EQ(glb.json["meshes"].size(), 1U);
}

TEST_F(SceneMeshes, LighterMeshes_KeepTheCoordinatesOfTheirVertices) {
    pipeline::ExportScene scene =
        pipeline::export_meshes(painted(png("paint.png", 1, {{200, 0, 0}})));
    const std::size_t before = scene.parts[0].mesh.vertices.size();
    lighten(scene, scene.parts[0].mesh.triangles.size() / 4);
    const pipeline::ExportPart& part = scene.parts[0];
    EXPECT_LT(part.mesh.vertices.size(), before);
    ASSERT_EQ(part.coordinates[0].size(), part.mesh.vertices.size());
    for (std::size_t i = 0; i < part.mesh.vertices.size(); ++i) {
        const float height = part.mesh.vertices[i].z;
        EXPECT_NEAR(std::sin(3.14159265F * (part.coordinates[0][i].y - 0.5F)), height, 1e-5F);
    }
}

}  // namespace
}  // namespace carom::studio
