#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/geometry/mesh_file.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

class PlyFile : public testing::Test {
  protected:
    MeshShape read(const std::string& text) {
        path_ = testing::TempDir() + "carom_ply_" +
                testing::UnitTest::GetInstance()->current_test_info()->name() + ".ply";
        std::ofstream(path_, std::ios::binary) << text;
        return read_mesh(path_);
    }

    /// The message without the path.
    std::string message(const std::string& text) {
        try {
            static_cast<void>(read(text));
        } catch (const Error& error) {
            const std::string what = error.what();
            return what.substr(what.find("': ") + 3);
        }
        return "no error";
    }

    /// "5: SENTENCE" of the first warning.
    std::string warning(const std::string& text) {
        static_cast<void>(read(text));
        const std::vector<MeshRemark> warnings = read_mesh_file(path_).warnings;
        return warnings.empty() ? "none"
                                : std::to_string(warnings[0].line) + ": " + warnings[0].sentence;
    }

    void TearDown() override { std::remove(path_.c_str()); }

  private:
    std::string path_;
};

constexpr const char* kSquareHeader =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float "
    "y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string square(const std::string& faces) {
    return std::string(kSquareHeader) + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + faces;
}

// Found by the fuzzer: a plan of such a mesh would have drawn a NaN.
TEST_F(PlyFile, VertexThatIsNotANumber_IsRejected) {
    std::string text =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float "
        "y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const auto add = [&text](auto value) {
        text.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    for (const float coordinate : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, std::nanf(""), 0.f}) {
        add(coordinate);
    }
    add(std::uint8_t{3});
    for (const std::int32_t index : {0, 1, 2}) {
        add(index);
    }
    EXPECT_EQ(message(text), "vertex 2 is not a finite point");
}

TEST_F(PlyFile, NormalThatIsNoNumber_IsZero) {
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nproperty double nx\nproperty double ny\nproperty double nz\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n";
    const MeshShape mesh = read(header + "0 0 0 0 0 1\n1 0 0 0 0 1e300\n0 1 0 0 0 1\n3 0 1 2\n");
    ASSERT_EQ(mesh.normals.size(), 3u);
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[1], Vec3(0, 0, 0));
}

TEST_F(PlyFile, Text_PolygonsAreCut) {
    const MeshShape mesh = read(square("4 0 1 2 3\n"));
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.vertices[2], Vec3(1, 1, 0));
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_TRUE(mesh.uv.empty());
}

/// A triangle with normals, uv, a colour to skip and an element after its faces.
std::string binary_triangle(bool big_endian) {
    std::string text =
        std::string("ply\r\nformat ") +
        (big_endian ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\r\nelement vertex 3\r\nproperty double x\r\nproperty float y\r\nproperty float z\r\n"
        "property uchar red\r\nproperty float nx\r\nproperty float ny\r\nproperty float nz\r\n"
        "property float s\r\nproperty float t\r\nelement face 1\r\nproperty uchar flags\r\n"
        "property list uint8 uint16 vertex_index\r\nelement edge 1\r\nproperty int a\r\n"
        "end_header\r\n";
    const auto put = [&](auto value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        for (std::size_t i = 0; i < sizeof value; ++i) {
            text.push_back(bytes[big_endian ? sizeof value - 1 - i : i]);
        }
    };
    for (int i = 0; i < 3; ++i) {
        put(0.25 * i);
        put(i == 1 ? 2.f : 0.f);
        put(-1.5f);
        put(std::uint8_t{200});
        put(0.f);
        put(0.f);
        put(1.f);
        put(0.5f * static_cast<float>(i));
        put(0.75f);
    }
    put(std::uint8_t{1});
    put(std::uint8_t{3});
    for (const int corner : {2, 1, 0}) {
        put(static_cast<std::uint16_t>(corner));
    }
    put(std::int32_t{7});
    return text;
}

TEST_F(PlyFile, BinaryOfEitherOrder_HasNormalsAndUv) {
    for (const bool big_endian : {false, true}) {
        const MeshShape mesh = read(binary_triangle(big_endian));
        ASSERT_EQ(mesh.vertices.size(), 3u);
        EXPECT_EQ(mesh.vertices[2], Vec3(0.5, 0, -1.5));
        EXPECT_EQ(mesh.vertices[1], Vec3(0.25, 2, -1.5));
        ASSERT_EQ(mesh.normals.size(), 3u);
        EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
        ASSERT_EQ(mesh.uv.size(), 3u);
        EXPECT_EQ(mesh.uv[2], Vec2(1, 0.75));
        ASSERT_EQ(mesh.triangles.size(), 1u);
        EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{2, 1, 0}));
    }
}

TEST_F(PlyFile, FacesBeforeVertices_AreRead) {
    const MeshShape mesh = read(
        "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
        "element vertex 3\nproperty float z\nproperty float y\nproperty float x\nend_header\n"
        "3 0 1 2\n1 2 3\n+4 5 6\n7 8 9e0");
    EXPECT_EQ(mesh.vertices[0], Vec3(3, 2, 1));
    EXPECT_EQ(mesh.vertices[2], Vec3(9, 8, 7));
}

TEST_F(PlyFile, Wrong_IsRefusedInWords) {
    EXPECT_EQ(message("ply\nformat ascii 1.0\n"), "the header of the PLY file does not end");
    EXPECT_EQ(message("ply\nformat ebcdic 1.0\n"), "line 2: an unknown format");
    EXPECT_EQ(message("ply\nformat ascii 1.0\nelement vertex many\n"),
              "line 3: an element needs a count");
    EXPECT_EQ(message("ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\n"),
              "line 4: a property of an unknown type");
    EXPECT_EQ(message("ply\nformat ascii 1.0\nelement vertex 3\nproperty float\n"),
              "line 4: a property needs a type and a name");
    EXPECT_EQ(message("ply\nhello\n"), "line 2: not a line of a PLY header");
    EXPECT_EQ(message("ply\nend_header\n"), "line 2: the header names no format");
    EXPECT_EQ(message(square("")), "the file ends before its last number");
    EXPECT_EQ(message(square("4 0 1 2 4\n")), "line 15: a face refers to vertex 4 of 4");
    EXPECT_EQ(message(square("4 0 1 2 -1\n")),
              "line 15: a face has a vertex index that is negative, fractional or too large");
    EXPECT_EQ(message(square("4 0 1 2 0.5\n")),
              "line 15: a face has a vertex index that is negative, fractional or too large");
    EXPECT_EQ(message(square("2 0 1\n")), "line 15: a face of 2 corners (3 to 16384 are possible)");
    EXPECT_EQ(message(square("-4 0 1\n")), "line 15: a list has an impossible length");
    EXPECT_EQ(message(square("4 0 one 2 3\n")), "line 15: 'one' is not a number");
}

TEST_F(PlyFile, CountsBeyondTheFile_AreRefusedBeforeMemoryIsTaken) {
    std::string huge(kSquareHeader);
    huge.replace(huge.find("vertex 4"), 8, "vertex 60000000");
    EXPECT_EQ(message(huge + "0 0 0\n"),
              "the header announces 60000000 elements 'vertex', more than fit into the file");
    EXPECT_EQ(message("ply\nformat ascii 1.0\nelement nothing 18446744073709551615\nend_header\n"),
              "the header announces 18446744073709551615 elements 'nothing', more than fit into "
              "the file");
}

TEST_F(PlyFile, NumbersThatAreNone_AreRefusedWithTheirLine) {
    for (const char* word : {"1.5.2", "--1", "0x10", "1e", "zero"}) {
        std::string text = square("4 0 1 2 3\n");
        text.replace(text.find("1 1 0"), 5, std::string("1 ") + word + " 0");
        EXPECT_EQ(message(text), "line 13: '" + std::string(word) + "' is not a number");
    }
    for (const char* word : {"nan", "-1.#IND", "inf", "1e39"}) {
        std::string text = square("4 0 1 2 3\n");
        text.replace(text.find("1 1 0"), 5, std::string("1 ") + word + " 0");
        EXPECT_EQ(message(text), "line 13: vertex 2 is not a finite point");
    }
    std::string text = square("4 0 1 2 3\n");
    text.replace(text.find("1 1 0"), 5, "1 1");
    EXPECT_EQ(message(text),
              "line 14: this line or the one before it has too many or too few numbers");
}

TEST_F(PlyFile, OddWhiteSpace_IsRead) {
    std::string text = "\xEF\xBB\xBF \nply \n\n" + square("4 0 1 2 3 \n\n").substr(4);
    text.replace(text.find("format"), 0, " \tobj_info made by hand\n");
    text.replace(text.find("1 1 0"), 5, " 1\t1\f 0 ");
    for (const char* ends : {"\n", "\r\n", "\r", " \n"}) {
        std::string changed;
        for (const char c : text) {
            changed += c == '\n' ? ends : std::string(1, c);
        }
        EXPECT_EQ(read(changed).triangles.size(), 2u) << ends;
    }
}

TEST_F(PlyFile, BinaryAfterReturnAlone_KeepsItsFirstByte) {
    std::string text =
        "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty char x\rproperty char y\r"
        "property char z\relement face 1\rproperty list uchar uchar vertex_indices\rend_header\r";
    text += std::string("\n\0\0\1\0\0\0\1\0\3\0\1\2", 13);
    EXPECT_EQ(read(text).vertices[0], Vec3(10, 0, 0));
}

/// Two triangles of a square with a uv for each corner, as MeshLab writes them.
std::string square_with_uv(const std::string& faces) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
           "float z\n"
           "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float "
           "texcoord\n"
           "property int texnumber\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" +
           faces;
}

TEST_F(PlyFile, UvOfFaces_SplitVerticesAtSeams) {
    const MeshShape joined =
        read(square_with_uv("3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 6 0 0 1 1 0 1 0\n"));
    EXPECT_EQ(joined.vertices.size(), 4u);
    ASSERT_EQ(joined.uv.size(), 4u);
    EXPECT_EQ(joined.uv[3], Vec2(0, 1));
    const MeshShape split =
        read(square_with_uv("3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 6 0 0 .5 1 0 1 0\n"));
    ASSERT_EQ(split.vertices.size(), 5u);
    const std::uint32_t corner = split.triangles[1][1];
    EXPECT_EQ(split.vertices[corner], Vec3(1, 1, 0));
    EXPECT_EQ(split.uv[corner], Vec2(0.5, 1));
}

TEST_F(PlyFile, UvOfFacesThatAreMissing_AreToldOnce) {
    EXPECT_EQ(warning(square_with_uv("3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 0 0\n")),
              "17: a face has no texture coordinates, so that those of all others are ignored");
    EXPECT_EQ(warning(square_with_uv("3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 4 0 0 1 1 0\n")),
              "17: a face does not have two texture coordinates for each corner; they are ignored");
    EXPECT_EQ(
        warning(square_with_uv("3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 6 0 0 1 1 0 1 1\n")),
        "17: a face has another picture than the first face; the object's material covers all");
    EXPECT_EQ(warning(square_with_uv("3 0 1 2 6 0 0 nan 0 1 1 0\n3 0 2 3 6 0 0 1 1 0 1 0\n")),
              "16: a texture coordinate is not a number; it counts as 0");
}

TEST_F(PlyFile, Strips_AreTrianglesWithOneFront) {
    const MeshShape mesh = read(
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty "
        "float z\n"
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n11 0 1 2 3 3 3 4 -1 1 3 2\n");
    using Triangle = std::array<std::uint32_t, 3>;
    // The strip 0 1 2 3 3 3 4: its triangles with equal corners are left out, but count.
    ASSERT_EQ(mesh.triangles.size(), 3u);
    EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
    EXPECT_EQ(mesh.triangles[1], (Triangle{2, 1, 3}));
    EXPECT_EQ(mesh.triangles[2], (Triangle{1, 3, 2}));
}

TEST_F(PlyFile, WithoutPlaces_OrFaces_IsRefused) {
    EXPECT_EQ(message("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"),
              "its vertices have no x, y and z");
    EXPECT_EQ(message("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                      "y\nproperty float z\nend_header\n1 2 3\n"),
              "the file has no faces");
}

TEST_F(PlyFile, RandomDamage_IsReadOrRefused) {
    test::TestRandom random(1);
    for (const std::string& whole :
         {square("4 0 1 2 3\n"), binary_triangle(false), binary_triangle(true)}) {
        int refused = 0;
        for (int i = 0; i < 1500; ++i) {
            std::string text = whole;
            for (int k = 0; k < 1 + i % 4; ++k) {
                text[random.next() % text.size()] = static_cast<char>(random.next() & 255);
            }
            if (i % 5 == 0) {
                text.resize(random.next() % text.size());
            }
            refused += message(text) == "no error" ? 0 : 1;
        }
        EXPECT_GT(refused, 500);
    }
}

}  // namespace
}  // namespace carom::render
