#include "pipeline/import/import_mesh.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/import/mtl_file.h"

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ImportMesh : public testing::Test {
  protected:
    ImportMesh() : folder_(testing::TempDir() + "carom_import_mesh") {
        std::filesystem::create_directories(folder_);
    }
    ~ImportMesh() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ + "/" + name, std::ios::binary) << text;
    }

    [[nodiscard]] ImportMeshResult import(const std::string& name,
                                          const ImportMeshOptions& options = {}) const {
        return import_mesh(folder_ + "/" + name, folder_ + "/chair.yaml", options);
    }

    std::string folder_;
};

constexpr const char* kChair =
    "mtllib chair parts.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1\nvt 0 0\nvt 1 0\nvt 1 1\n"
    "usemtl seat\nf 1/1 2/2 3/3\nusemtl Leg #1\nf 1 2 4\nf 2 3 4\nusemtl seat\nf 1/1 3/3 4/2\n";

constexpr const char* kMaterials =
    "newmtl seat\r\nKd 0.8 0.2 0.1\r\nKs 0.5 0.5 0.5\r\nNs 98\r\nillum 2\r\nmap_Kd -s 2 3 1 -o 0.5 "
    "C:\\pictures\\red cloth.png\r\nmap_Ks cloth.png\r\n\r\nnewmtl Leg #1\r\nKd .5\r\nillum "
    "7\r\nd 0.25\r\nNi "
    "1.33\r\nPr 0.1\r\nPm 1\r\nPc 1\r\nPcr 0.2\r\nKe 2 1 0\r\n";

TEST_F(ImportMesh, SeveralMaterials_BecomeObjectsWithTheirFiles) {
    write("chair.obj", kChair);
    write("chair parts.mtl", kMaterials);
    write("red cloth.png", "");
    ImportMeshOptions options;
    options.unit = 0.001;
    const ImportMeshResult result = import("chair.obj", options);
    EXPECT_THAT(result.problems, IsEmpty());
    EXPECT_THAT(result.notes, ElementsAre("material 'seat': map_Ks is not read",
                                          "material 'Leg #1': its transparency became glass"));
    EXPECT_THAT(
        result.yaml,
        HasSubstr("objects:\n"
                  "  chair_seat: {mesh: \"chair_seat.obj\", rotate: [90 deg, 0 deg, 0 deg], "
                  "scale: 0.001, material: seat}\n"
                  "  chair_Leg__1: {mesh: \"chair_Leg__1.obj\", rotate: [90 deg, 0 deg, 0 deg], "
                  "scale: 0.001, material: Leg__1}\n"
                  "materials:\n"
                  "  seat: {standard: {base: {image: {file: \"red cloth.png\", scale: [2, 3], "
                  "offset: [-0.5, 0]}}, roughness: 0.376060309, specular: 1}}\n"
                  "  Leg__1: {standard: {base: [0.5, 0.5, 0.5], transmission: 0.75, ior: 1.33, "
                  "roughness: 0.1, metal: 1, coat: {weight: 1, roughness: 0.2}, emission: "
                  "[2, 1, 0]}}\n"));
    ASSERT_EQ(result.files.size(), 2u);
    EXPECT_EQ(result.files[0].text,
              "# Made by carom import\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1\nvt 0 0\nvt 1 0\nvt 1 "
              "1\nvt 1 0\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
    EXPECT_EQ(result.files[1].name, "chair_Leg__1.obj");
    for (const MeshFileText& file : result.files) {
        write(file.name, file.text);
    }
    const LoadResult shot = load_shot_text(
        result.yaml +
            "carom: 1\ntable: {kind: cloth}\ncameras: [{name: c, video: [0 s, 1 s], scene: 0 "
            "s, position: [0, -1, 1], target: [0, 0, 0]}]\n",
        folder_ + "/shot.yaml");
    for (const Problem& problem : shot.problems) {
        ADD_FAILURE() << format(problem);
    }
}

TEST_F(ImportMesh, OneMaterial_NeedsNoOtherFile) {
    write("one.obj",
          "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvn nan 0 0\nusemtl a\nf 1//1 2//1 3//1\n");
    ImportMeshOptions options;
    options.is_z_up = true;
    const ImportMeshResult result = import("one.obj", options);
    EXPECT_THAT(result.files, IsEmpty());
    EXPECT_THAT(result.yaml, HasSubstr("  chair: {mesh: \"one.obj\", material: a}\n"));
    EXPECT_THAT(result.yaml, HasSubstr("  a: {standard: {base: [0.8, 0.8, 0.8]}}\n"));
    EXPECT_THAT(result.notes, ElementsAre("no file 'none.mtl' with materials was found",
                                          HasSubstr("line 5: a normal has no length"),
                                          "material 'a' is not defined; it is a plain grey"));
    write("scan.ply",
          "ply\nformat ascii 1.0\ncomment TextureFile scan 1.jpg\nelement vertex 3\nproperty float "
          "x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
          "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    write("scan 1.jpg", "");
    EXPECT_THAT(import("scan.ply").yaml, HasSubstr("base: {image: {file: \"scan 1.jpg\"}}"));
}

TEST_F(ImportMesh, BadFile_IsAProblemWithItsLine) {
    write("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
    const ImportMeshResult result = import("bad.obj");
    EXPECT_EQ(result.yaml, "");
    ASSERT_EQ(result.problems.size(), 1u);
    EXPECT_EQ(result.problems[0].place.line, 3);
    EXPECT_EQ(result.problems[0].message, "a face refers to vertex 3, but the file has only 2");
}

class ImportTextures : public ImportMesh {
  protected:
    /// The YAML's material of a triangle whose MTL file has these lines.
    [[nodiscard]] std::string material(const std::string& lines) {
        write("one.obj",
              "mtllib one.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl a\n"
              "f 1/1 2/2 3/3\n");
        write("one.mtl", "newmtl a\n" + lines);
        const ImportMeshResult result = import("one.obj");
        EXPECT_THAT(result.problems, IsEmpty());
        notes_ = result.notes;
        write("chair.yaml", result.yaml);
        const LoadResult shot = load_shot_text(
            "carom: 1\ninclude: chair.yaml\ntable: {kind: cloth}\ncameras: [{video: [0 s, 1 s], "
            "scene: 0 s, position: [0, -1, 1], target: [0, 0, 0]}]\n",
            folder_ + "/shot.yaml");
        for (const Problem& problem : shot.problems) {
            ADD_FAILURE() << format(problem);
        }
        const std::string start = "  a: {standard: {";
        const std::size_t begin = result.yaml.find(start) + start.size();
        return result.yaml.substr(begin, result.yaml.find("}}\n", begin) - begin);
    }

    /// A picture of one pixel.
    void write_pixel(const std::string& name, int red, int green, int blue) const {
        write(name, "P6 1 1 255\n" + std::string{static_cast<char>(red), static_cast<char>(green),
                                                 static_cast<char>(blue)});
    }

    std::vector<std::string> notes_;
};

TEST_F(ImportTextures, Maps_BecomeTexturesOfTheirParameters) {
    write_pixel("a.ppm", 100, 100, 100);
    EXPECT_EQ(material("map_Kd a.ppm\nmap_Pr -imfchan g a.ppm\nPr 0.3\nmap_Pm -mm 0.2 0.5 a.ppm\n"
                       "map_Ps -s 2 2 a.ppm\nKe 4 2 0\nmap_Ke a.ppm\nd 0.5\nmap_d a.ppm\n"),
              "base: {image: {file: \"a.ppm\"}}, "
              "opacity: {image: {file: \"a.ppm\"}, range: [0, 0.5]}, "
              "roughness: {image: {file: \"a.ppm\", channel: green}}, "
              "metal: {image: {file: \"a.ppm\"}, range: [0.2, 0.7]}, "
              "sheen: {image: {file: \"a.ppm\", scale: [2, 2]}}, "
              "emission: {image: {file: \"a.ppm\", tint: [1, 0.5, 0]}}, emission_strength: 4");
    EXPECT_THAT(notes_, IsEmpty());
    EXPECT_EQ(material("Ke 0 0 0\nmap_Ke a.ppm\n"),
              "base: [0.8, 0.8, 0.8], emission: {image: {file: \"a.ppm\"}}");
}

TEST_F(ImportTextures, Dissolve_IsOpacityUnlessTheModelIsGlass) {
    EXPECT_EQ(material("d 0.25\n"), "base: [0.8, 0.8, 0.8], opacity: 0.25");
    EXPECT_EQ(material("Tr 0.25\nillum 2\n"), "base: [0.8, 0.8, 0.8], opacity: 0.75");
    EXPECT_EQ(material("d 1\nillum 9\n"), "base: [0.8, 0.8, 0.8]");
    EXPECT_THAT(notes_, IsEmpty());
    write_pixel("a.ppm", 100, 100, 100);
    EXPECT_EQ(material("d 0.25\nillum 9\nmap_Pr a.ppm\nPr 0.1\n"),
              "base: [0.8, 0.8, 0.8], transmission: 0.75, ior: 1.5, roughness: 0.1");
    EXPECT_THAT(notes_, ElementsAre("material 'a': its transparency became glass",
                                    "material 'a': map_Pr is not read, because glass has the same "
                                    "roughness everywhere"));
    // Leaves of a tree, from programs that write 9 for everything that is not opaque.
    EXPECT_EQ(material("d 1\nillum 9\nmap_d a.ppm\n"),
              "base: [0.8, 0.8, 0.8], opacity: {image: {file: \"a.ppm\"}}");
}

TEST_F(ImportTextures, Bumps_AreAReliefByHeightOrByNormals) {
    write_pixel("grey.ppm", 90, 90, 90);
    write_pixel("blue.ppm", 128, 130, 250);
    EXPECT_EQ(material("map_Bump -bm 0.5 grey.ppm\n"),
              "base: [0.8, 0.8, 0.8], height: {image: {file: \"grey.ppm\"}, depth: 0.0005}");
    EXPECT_THAT(notes_,
                ElementsAre("material 'a': the depth of its relief has no unit in the file; "
                            "it is 0.5 mm"));
    EXPECT_EQ(material("bump -imfchan r grey.ppm\n"),
              "base: [0.8, 0.8, 0.8], height: {image: {file: \"grey.ppm\", channel: red}, depth: "
              "0.001}");
    EXPECT_EQ(material("map_Bump -bm 0.5 blue.ppm\n"),
              "base: [0.8, 0.8, 0.8], normal: {image: {file: \"blue.ppm\"}, strength: 0.5}");
    EXPECT_EQ(material("norm grey.ppm\nmap_bump blue.ppm\n"),
              "base: [0.8, 0.8, 0.8], normal: {image: {file: \"grey.ppm\"}}");
    EXPECT_THAT(notes_, ElementsAre("material 'a': map_Bump is not read, because norm is"));
}

TEST_F(ImportTextures, MissingPictures_AreReplacedByConstants) {
    EXPECT_EQ(material("Kd 0.5\nmap_Kd none.png\nmap_Pr none.png\nPr 0.3\nmap_Bump none.png\n"),
              "base: [0.5, 0.5, 0.5], roughness: 0.3");
    EXPECT_THAT(
        notes_,
        ElementsAre("material 'a': no picture 'none.png' was found; a constant replaces it"));
}

TEST(MtlFile, OddLines_AreReadOrTold) {
    const MtlFile file = read_mtl(
        "\xEF\xBB\xBF# a comment\nnewmtl a\nd -halo 0.5\nnewmtl b\nTr 0.25\nKd 1 x 1\n"
        "map_Kd -blendu on -mm 0 1 -s 2 picture one.png\nmap_Kd\nillum 2 ");
    EXPECT_EQ(file.problem, "line 6 cannot be read and is ignored");
    EXPECT_EQ(file.materials.at("a").opacity, 0.5);
    EXPECT_EQ(file.materials.at("b").opacity, 0.75);
    EXPECT_FALSE(file.materials.at("b").diffuse);
    EXPECT_EQ(file.materials.at("b").illumination, 2);
}

}  // namespace
}  // namespace carom::pipeline
