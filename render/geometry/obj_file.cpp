#include "render/geometry/obj_file.h"

#define TINYOBJLOADER_USE_DOUBLE  // as libtinyobjloader_double was built
#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string_view>
#include <unordered_map>

#include <fmt/core.h>
#include <tiny_obj_loader.h>

#include "core/error.h"
#include "core/limits.h"
#include "render/geometry/file_text.h"
#include "render/geometry/polygon.h"
#include "render/geometry/triangle_mesh.h"

namespace carom::render {
namespace {

constexpr std::size_t kMaxLineBytes = 65'536;
constexpr int kMaxCorners = 1'024;  // of one face

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error("'" + path + "': " + what);
}

bool has_digits(std::string_view text, int at_least) {
    int run = 0;
    for (const char c : text) {
        run = c >= '0' && c <= '9' ? run + 1 : 0;
        if (run >= at_least) {
            return true;
        }
    }
    return false;
}

/// The problem in a line, or an empty text. The library reads a word that is not a number as zero
/// and wraps indices that are too large, so both are checked before it runs.
std::string problem_of(std::string_view line) {
    if (line.size() > kMaxLineBytes) {
        return fmt::format("longer than {} bytes", kMaxLineBytes);
    }
    if (line.find('\0') != std::string_view::npos) {
        return "a zero byte; this is not an OBJ file";
    }
    const std::size_t key_end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view key = line.substr(0, key_end);
    const bool is_vertex = key == "v" || key == "vn" || key == "vt";
    if (!is_vertex && key != "f") {
        return {};
    }
    const std::string_view with_comment = line.substr(key_end);
    const std::string_view values = with_comment.substr(0, with_comment.find('#'));
    const std::string_view allowed = is_vertex ? "0123456789+-.eE \t\r" : "0123456789-/ \t\r";
    if (values.find_first_not_of(allowed) != std::string_view::npos) {
        std::string problem("'");
        problem.append(line.substr(0, 60)).append("' has something that is no number");
        return problem;
    }
    if (!is_vertex && has_digits(values, 10)) {
        return "a face refers to a vertex beyond a thousand million";
    }
    return {};
}

void check_lines(std::string_view text, const std::string& path) {
    std::size_t line_number = 0;
    std::size_t begin = 0;
    while (begin < text.size()) {
        ++line_number;
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string problem = problem_of(text.substr(begin, end - begin));
        if (!problem.empty()) {
            refuse(path, fmt::format("line {}: {}", line_number, problem));
        }
        begin = end + 1;
    }
}

/// A corner's position, normal and uv; -1 for none.
struct Corner {
    std::ptrdiff_t point, normal, place;

    bool operator==(const Corner&) const = default;
};

struct CornerHash {
    std::size_t operator()(const Corner& corner) const {
        std::size_t hash = static_cast<std::size_t>(corner.point + 1);
        for (const std::ptrdiff_t part : {corner.normal, corner.place}) {
            hash =
                (hash ^ (hash >> 29)) * 0x9e3779b97f4a7c15ull + static_cast<std::size_t>(part + 1);
        }
        return hash ^ (hash >> 32);
    }
};

/// Corners with their normal and uv become vertices; equal ones are shared.
class MeshBuilder {
  public:
    explicit MeshBuilder(const std::string& path) : path_(path) {}

    void add_face(const tinyobj::index_t* indices, int count) {
        if (count < 3 || count > kMaxCorners) {
            refuse(path_,
                   fmt::format("a face of {} corners (3 to {} are possible)", count, kMaxCorners));
        }
        std::vector<std::uint32_t> corners;
        std::vector<Vec3> places;
        for (int i = 0; i < count; ++i) {
            corners.push_back(vertex_of(indices[i]));
            places.push_back(shape_.vertices[corners.back()]);
        }
        for (const auto& triangle : triangulate(places)) {
            shape_.triangles.push_back(
                {corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]});
        }
        if (shape_.triangles.size() > input_limit(kMaxMeshTriangles)) {
            refuse(path_, beyond_limit(input_limit(kMaxMeshTriangles), "triangles"));
        }
    }

    MeshShape finish() {
        if (shape_.triangles.empty()) {
            refuse(path_, "the file has no faces; is it an OBJ file?");
        }
        // Normals and uv are used only if every corner has them.
        if (without_normal_) {
            shape_.normals.clear();
        }
        if (without_uv_) {
            shape_.uv.clear();
        }
        return std::move(shape_);
    }

    std::vector<Vec3> points;
    std::vector<Vec3> normals;
    std::vector<Vec2> uv;

  private:
    /// 1 is the first entry of the file yet, -1 the last; -1 is returned for none (0).
    std::ptrdiff_t resolve(int index, std::size_t count, const char* kind) const {
        if (index == 0) {
            return -1;
        }
        const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(count);
        const std::ptrdiff_t at = index > 0 ? std::ptrdiff_t{index} - 1 : size + index;
        if (at < 0 || at >= size) {
            refuse(path_, fmt::format("a face refers to {} {}, but only {} came before it", kind,
                                      index, count));
        }
        return at;
    }

    std::uint32_t vertex_of(const tinyobj::index_t& index) {
        const std::ptrdiff_t point = resolve(index.vertex_index, points.size(), "vertex");
        const std::ptrdiff_t normal = resolve(index.normal_index, normals.size(), "normal");
        const std::ptrdiff_t place = resolve(index.texcoord_index, uv.size(), "texture coordinate");
        if (point < 0) {
            refuse(path_, "a face refers to vertex 0; OBJ counts from 1");
        }
        const auto [known, is_new] = known_.try_emplace(
            Corner{point, normal, place}, static_cast<std::uint32_t>(shape_.vertices.size()));
        if (is_new) {
            shape_.vertices.push_back(points[static_cast<std::size_t>(point)]);
            shape_.normals.push_back(normal < 0 ? Vec3(0, 0, 0)
                                                : normals[static_cast<std::size_t>(normal)]);
            shape_.uv.push_back(place < 0 ? Vec2(0, 0) : uv[static_cast<std::size_t>(place)]);
            without_normal_ = without_normal_ || normal < 0;
            without_uv_ = without_uv_ || place < 0;
        }
        return known->second;
    }

    const std::string& path_;
    MeshShape shape_;
    std::unordered_map<Corner, std::uint32_t, CornerHash> known_;
    bool without_normal_ = false;
    bool without_uv_ = false;
};

tinyobj::callback_t callbacks() {
    tinyobj::callback_t result;
    result.vertex_cb = [](void* user, tinyobj::real_t x, tinyobj::real_t y, tinyobj::real_t z,
                          tinyobj::real_t) {
        static_cast<MeshBuilder*>(user)->points.emplace_back(x, y, z);
    };
    result.normal_cb = [](void* user, tinyobj::real_t x, tinyobj::real_t y, tinyobj::real_t z) {
        static_cast<MeshBuilder*>(user)->normals.emplace_back(x, y, z);
    };
    result.texcoord_cb = [](void* user, tinyobj::real_t x, tinyobj::real_t y, tinyobj::real_t) {
        static_cast<MeshBuilder*>(user)->uv.emplace_back(x, y);
    };
    result.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
        static_cast<MeshBuilder*>(user)->add_face(indices, count);
    };
    return result;
}

}  // namespace

MeshShape read_obj(const std::string& path) {
    std::string text = read_mesh_text(path);
    check_lines(text, path);
    std::istringstream stream(std::move(text));
    MeshBuilder builder(path);
    std::string warnings;
    std::string errors;
    const bool read =
        tinyobj::LoadObjWithCallback(stream, callbacks(), &builder, nullptr, &warnings, &errors);
    if (!read) {
        refuse(path, "not a readable OBJ file: " + errors);
    }
    return builder.finish();
}

}  // namespace carom::render
