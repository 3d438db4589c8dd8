#include <cstdio>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/geometry/mesh_file.h"

namespace carom::render {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class ObjFile : public testing::Test {
  protected:
    MeshReading read_file(const std::string& text) {
        path_ = testing::TempDir() + "carom_obj_" +
                testing::UnitTest::GetInstance()->current_test_info()->name() + ".obj";
        std::ofstream(path_, std::ios::binary) << text;
        return read_mesh_file(path_);
    }

    MeshShape read(const std::string& text) {
        MeshReading reading = read_file(text);
        EXPECT_TRUE(reading.problems.empty()) << reading.problems.front().sentence;
        return std::move(reading.mesh);
    }

    /// "6: SENTENCE" for each warning.
    std::vector<std::string> warnings(const std::string& text) {
        std::vector<std::string> sentences;
        for (const MeshRemark& warning : read_file(text).warnings) {
            sentences.push_back(std::to_string(warning.line) + ": " + warning.sentence);
        }
        return sentences;
    }

    std::string message(const std::string& text) {
        try {
            static_cast<void>(read_file(text));
            static_cast<void>(read_mesh(path_));
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
        static_cast<void>(read_mesh("/no/such/mesh.obj"));
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
                HasSubstr("line 5: a face refers to vertex 5, but the file has only 4"));
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2 -5\n"), HasSubstr("refers to vertex -5"));
    EXPECT_THAT(message(std::string(kSquare) + "f 1//1 2//1 3//1\n"),
                HasSubstr("refers to normal 1, but the file has only 0"));
    EXPECT_THAT(message(std::string(kSquare) + "f 1/9 2/9 3/9\n"),
                HasSubstr("refers to texture coordinate 9"));
}

TEST_F(ObjFile, IndexZero_Refused) {
    EXPECT_THAT(message(std::string(kSquare) + "f 0 1 2\n"), HasSubstr("OBJ counts from 1"));
}

TEST_F(ObjFile, IndexThatOverflows_Refused) {
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2 99999999999999999999\n"),
                HasSubstr("line 5: a face refers to vertex 99999999999999999999, but"));
}

TEST_F(ObjFile, FaceOfTwoCorners_Refused) {
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2\n"), HasSubstr("a face of 2 corners"));
}

TEST_F(ObjFile, FaceOfFarTooManyCorners_Refused) {
    std::string text = std::string(kSquare) + "f";
    for (int i = 0; i < 20'000; ++i) {
        text += " 1";
    }
    EXPECT_THAT(message(text + "\n"), HasSubstr("a statement of more than 16392 words"));
}

TEST_F(ObjFile, WordInsteadOfNumber_RefusedWithItsLine) {
    const std::string none = ", which is not a finite number";
    EXPECT_THAT(message("v 0 0 0\nv 1 nan 0\n"),
                EndsWith("line 2: a vertex has the coordinate 'nan'" + none));
    EXPECT_THAT(message("v 0 0 0\nv -1.#IND 1 0\n"),
                EndsWith("line 2: a vertex has the coordinate '-1.#IND'" + none));
    EXPECT_THAT(message("v 0 inf 0\n"),
                EndsWith("line 1: a vertex has the coordinate 'inf'" + none));
    EXPECT_THAT(message("v 0 1e39 0\n"),
                EndsWith("line 1: a vertex has the coordinate '1e39'" + none));
    for (const char* word :
         {"zero", "1.5.2", "--1", "+-1", "0x10", "1e", "1.0f", "-", "1d3", "1_0"}) {
        EXPECT_THAT(message(std::string("v 0 0 ") + word + "\n"),
                    EndsWith("line 1: '" + std::string(word) + "' is not a number"));
        EXPECT_THAT(message(std::string("vn 0 0 ") + word + "\n"), HasSubstr("is not a number"));
        EXPECT_THAT(message(std::string("vt 0 ") + word + "\n"), HasSubstr("is not a number"));
    }
    EXPECT_THAT(message("v 0 0 1,5\n"),
                EndsWith("'1,5' is not a number; decimals need a point instead of a comma"));
    EXPECT_THAT(message("v 0 0\n"),
                EndsWith("line 1: a vertex of 2 coordinates; it needs x, y and z"));
    EXPECT_THAT(message("vt\n"), EndsWith("line 1: a texture coordinate without a number"));
    EXPECT_THAT(message(std::string(kSquare) + "f a b c\n"),
                EndsWith("line 5: the corner 'a' is not made of whole numbers"));
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2.5 3\n"), HasSubstr("'2.5' is not made of"));
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2 /3\n"), HasSubstr("'/3' has no vertex"));
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2 3/1/1/1\n"), HasSubstr("'3/1/1/1' has more"));
}

TEST_F(ObjFile, NumbersOfAllWritings_AreRead) {
    const MeshShape mesh =
        read("v +1. .5 -.25e+1\nv 1E-400 1e-3 0.1\nv 0 2 0 1 0.5 0.5 0.5\nf 1 2 3\n");
    EXPECT_EQ(mesh.vertices[0], Vec3(1, 0.5, -2.5));
    EXPECT_EQ(mesh.vertices[1], Vec3(0, 1e-3, 0.1));
    EXPECT_EQ(mesh.vertices[2], Vec3(0, 2, 0));
}

TEST_F(ObjFile, OddWhiteSpace_IsRead) {
    const std::string text = "\t v  0\t0 0 \f\n\n \t\nv 1 0 0\v\nv 1 1 0\nv 0 1 0 \nf 1  2\t3 4 \n";
    const auto with_ends = [&](const std::string& ends) {
        std::string result;
        for (const char c : text) {
            result += c == '\n' ? ends : std::string(1, c);
        }
        return result;
    };
    for (const char* ends : {"\n", "\r\n", "\r"}) {
        EXPECT_EQ(read(with_ends(ends)).triangles.size(), 2u);
        EXPECT_THAT(message(with_ends(ends) + "v x"), HasSubstr("line 8: "));
    }
}

TEST_F(ObjFile, ByteOrderMark_IsSkipped) {
    const MeshShape mesh = read(
        "\xEF\xBB\xBF"
        "v 9 9 9\n" +
        std::string(kSquare) + "f 2 3 4\n");
    EXPECT_EQ(mesh.vertices.front(), Vec3(0, 0, 0));
    for (const std::string& wide : {std::string("\xFF\xFEv\0 \0", 6),
                                    std::string("\xFE\xFF\0v\0 ", 6), std::string("v\0 \0", 4)}) {
        EXPECT_THAT(message(wide), HasSubstr("a text in UTF-16"));
    }
}

TEST_F(ObjFile, BackslashAtTheEnd_JoinsLines) {
    const MeshShape mesh = read(
        "v 0 0 \\\n 0\nv 1 0 0\nv 1 \\\r\n1 0\nv 0 1 0\n# a folder C:\\\nf 1 2 \\\n 3 \\ \n4\n");
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_THAT(message(std::string(kSquare) + "f 1 2 \\\n3 9\n"), HasSubstr("line 5: "));
}

TEST_F(ObjFile, EmptyFields_MeanNone) {
    const std::string uv = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    const MeshShape mesh = read(kSquare + uv + "f 1/1/ 2/2/ 3/3/ 4/4/\n");
    EXPECT_EQ(mesh.uv.size(), 4u);
    EXPECT_TRUE(mesh.normals.empty());
    for (const char* face : {"f 1// 2// 3//\n", "f 1/ 2/ 3/\n", "f 1 2// 3/\n"}) {
        const MeshShape plain = read(std::string(kSquare) + face);
        EXPECT_TRUE(plain.uv.empty() && plain.normals.empty());
    }
}

TEST_F(ObjFile, ForwardReferences_AreRead) {
    EXPECT_EQ(read("f 1 2 3\n" + std::string(kSquare)).vertices.size(), 3u);
    EXPECT_THAT(message("f -1 -2 -3\n" + std::string(kSquare)),
                HasSubstr("line 1: a face refers to vertex -1, but before it are only 0"));
}

TEST_F(ObjFile, Blemishes_AreCountedOncePerKind) {
    EXPECT_THAT(
        warnings(std::string(kSquare) + "vn 0 0 1\nvn nan nan nan\nvn 0 0 0\nvn 1 2\n"
                                        "vn -1.#IND 0 0\nf 1//1 2//2 3//1 4//1\n"),
        ElementsAre("6: 4 normals have no length or are not three numbers; they are ignored"));
    EXPECT_THAT(
        warnings(std::string(kSquare) + "vt nan 0\nf 1/1 2/1 3/1\nf 1 3 4\nhello world\n"
                                        "surf 0 1 0 1 1\nf 1/0 2/1 3/1\n"),
        ElementsAre(
            "5: a texture coordinate is not a number; it counts as 0",
            "7: 2 faces have no texture coordinates, so that those of all others are ignored",
            "10: a face refers to normal or texture coordinate 0, which does not exist; "
            "it counts as none",
            "8: a line is no statement of an OBJ file; it is ignored",
            "9: a curve or curved surface is ignored; only faces are read"));
    EXPECT_THAT(
        warnings("# all is well\n\nmtllib a.mtl\no a\ng b c\ns 1\nusemtl red\nl 1 2\np 1\n" +
                 std::string(kSquare) + "vn 0 0 1\nvt 0 0\nf 1 2 3\n"),
        ElementsAre());
}

TEST_F(ObjFile, MaterialsOfFaces_AreTold) {
    const MeshReading reading = read_file(std::string(kSquare) +
                                          "f 1 2 3\nusemtl dark red\nf 1 2 3 4\n"
                                          "usemtl blue#1\nf 2 3 4\nusemtl dark red\nf 1 2 3\n");
    EXPECT_THAT(reading.materials, ElementsAre("dark red", "blue#1"));
    EXPECT_THAT(reading.triangle_materials, ElementsAre(MeshReading::kNoMaterial, 0, 0, 1, 0));
}

TEST_F(ObjFile, BinaryFile_Refused) {
    EXPECT_THAT(message(std::string("\x7f"
                                    "ELF\0\0\0\1",
                                    8)),
                HasSubstr("not an OBJ file"));
}

}  // namespace
}  // namespace carom::render
