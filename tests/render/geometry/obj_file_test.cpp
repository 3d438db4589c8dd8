#include "render/geometry/obj_file.h"

#include <cstdio>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace carom::render {
namespace {

using testing::HasSubstr;

class ObjFile : public testing::Test {
  protected:
    MeshShape read(const std::string& text) {
        path_ = testing::TempDir() + "carom_obj_" +
                testing::UnitTest::GetInstance()->current_test_info()->name() + ".obj";
        std::ofstream(path_, std::ios::binary) << text;
        return read_obj(path_);
    }

    std::string message(const std::string& text) {
        try {
            static_cast<void>(read(text));
        } catch (const Error& error) {
            const std::string what = error.what();
            EXPECT_THAT(what, HasSubstr(path_));
            return what;
        }
        return "no error";
    }

    void TearDown() override { std::remove(path_.c_str()); }

  private:
    std::string path_;
};

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ObjFile, QuadWithUvAndNormals_TwoTrianglesFourVertices) {
    const MeshShape mesh = read(std::string(kSquare) +
                                "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                                "f 1/1/1 2/2/1 3/3/1 4/4/1\n");
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.vertices.size(), 4u);
    ASSERT_EQ(mesh.uv.size(), 4u);
    ASSERT_EQ(mesh.normals.size(), 4u);
    EXPECT_EQ(mesh.normals[2], Vec3(0, 0, 1));
}

TEST_F(ObjFile, NegativeIndicesCommentsAndCrLf_AreRead) {
    const MeshShape mesh = read(
        "# a comment\r\no thing\r\nv 0 0 0\r\nv 1.5e-1 0 0 # inline\r\nv 0 +2 0\r\ng part\r\n"
        "usemtl none\r\ns off\r\nf -3 -2 -1\r\n");
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_DOUBLE_EQ(mesh.vertices[1].x, 0.15);
    EXPECT_DOUBLE_EQ(mesh.vertices[2].y, 2);
    EXPECT_TRUE(mesh.uv.empty());
    EXPECT_TRUE(mesh.normals.empty());
}

TEST_F(ObjFile, CornersThatDiffer_AreVerticesOfTheirOwn) {
    const MeshShape mesh =
        read(std::string(kSquare) + "vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n");
    EXPECT_EQ(mesh.vertices.size(), 6u);
    EXPECT_EQ(mesh.normals.size(), 6u);
}

TEST_F(ObjFile, SomeCornersWithoutUv_UvAreLeftOut) {
    const MeshShape mesh = read(std::string(kSquare) + "vt 0 0\nf 1/1 2/1 3/1\nf 1 3 4\n");
    EXPECT_TRUE(mesh.uv.empty());
}

TEST_F(ObjFile, MaterialLibrary_IsNotOpened) {
    const MeshShape mesh =
        read("mtllib /dev/full\nmtllib ../../etc/passwd\n" + std::string(kSquare) + "f 1 2 3\n");
    EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST_F(ObjFile, MissingFile_Refused) {
    try {
        static_cast<void>(read_obj("/no/such/mesh.obj"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "'/no/such/mesh.obj': the mesh cannot be opened");
    }
}

TEST_F(ObjFile, Empty_Refused) {
    EXPECT_THAT(message(""), HasSubstr("the file has no faces"));
}

TEST_F(ObjFile, PointsOnly_Refused) {
    EXPECT_THAT(message(kSquare), HasSubstr("the file has no faces; is it an OBJ file?"));
}

TEST_F(ObjFile, IndexBeyondVertices_Refused) {
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2 5\n"),
                HasSubstr("a face refers to vertex 5, but only 4 came before it"));
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2 -5\n"), HasSubstr("refers to vertex -5"));
    EXPECT_THAT(message(std::string(kSquare) + "f 1//1 2//1 3//1\n"),
                HasSubstr("refers to normal 1, but only 0"));
    EXPECT_THAT(message(std::string(kSquare) + "f 1/9 2/9 3/9\n"),
                HasSubstr("refers to texture coordinate 9"));
}

TEST_F(ObjFile, IndexZero_Refused) {
    EXPECT_THAT(message(std::string(kSquare) + "f 0 1 2\n"), HasSubstr("OBJ counts from 1"));
}

TEST_F(ObjFile, IndexThatOverflows_Refused) {
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2 99999999999999999999\n"),
                HasSubstr("line 5: a face refers to a vertex beyond"));
}

TEST_F(ObjFile, FaceOfTwoCorners_Refused) {
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2\n"), HasSubstr("a face of 2 corners"));
}

TEST_F(ObjFile, FaceOfFarTooManyCorners_Refused) {
    std::string text = std::string(kSquare) + "f";
    for (int i = 0; i < 2'000; ++i) {
        text += " 1";
    }
    EXPECT_THAT(message(text + "\n"), HasSubstr("a face of 2000 corners"));
}

TEST_F(ObjFile, WordInsteadOfNumber_RefusedWithItsLine) {
    EXPECT_THAT(message("v 0 0 0\nv 1 nan 0\n"), HasSubstr("line 2: 'v 1 nan 0' has something"));
    EXPECT_THAT(message("v 0 0 zero\n"), HasSubstr("line 1"));
    EXPECT_THAT(message(std::string(kSquare) + "f a b c\n"), HasSubstr("line 5"));
}

TEST_F(ObjFile, BinaryFile_Refused) {
    EXPECT_THAT(message(std::string("\x7f"
                                    "ELF\0\0\0\1",
                                    8)),
                HasSubstr("not an OBJ file"));
}

TEST_F(ObjFile, LineWithoutEnd_Refused) {
    EXPECT_THAT(message("# " + std::string(100'000, 'x')), HasSubstr("line 1: longer than"));
}

}  // namespace
}  // namespace carom::render
