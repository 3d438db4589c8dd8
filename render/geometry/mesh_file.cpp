#include "render/geometry/mesh_file.h"

#include <fstream>
#include <ios>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "core/limits.h"
#include "render/geometry/file_text.h"
#include "render/geometry/obj_file.h"
#include "render/geometry/ply_file.h"
#include "render/geometry/validity.h"

namespace carom::render {

namespace {

constexpr std::streamoff kMaxFileBytes = 1'000'000'000;

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error("'" + path + "': " + what);
}

/// Physics, plans and exports use the numbers unchecked.
void check_numbers(MeshShape& mesh, const std::string& path) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (!is_finite(V3f(mesh.vertices[i]))) {
            refuse(path, fmt::format("vertex {} is not a finite point", i));
        }
    }
    for (Vec3& normal : mesh.normals) {
        normal = is_finite(V3f(normal)) ? normal : Vec3(0, 0, 0);
    }
    for (Vec2& uv : mesh.uv) {
        uv = is_finite(V3f(Vec3(uv.x, uv.y, 0))) ? uv : Vec2(0, 0);
    }
}

}  // namespace

std::string read_mesh_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) {
        refuse(path, "the mesh cannot be opened");
    }
    const std::streamoff size = file.tellg();
    if (size < 0 || size > static_cast<std::streamoff>(input_limit(kMaxFileBytes))) {
        refuse(path,
               std::string("the mesh is larger than 1 GB or not a file") + how_to_raise_limits());
    }
    std::string text(static_cast<std::size_t>(size), '\0');
    file.seekg(0);
    file.read(text.data(), size);
    if (!file) {
        refuse(path, "the mesh file cannot be read completely");
    }
    return text;
}

MeshReading read_mesh_file(const std::string& path) {
    MeshReading reading;
    try {
        reading.mesh = is_ply(path) ? read_ply(path) : read_obj(path);
        check_numbers(reading.mesh, path);
    } catch (const Error& error) {
        reading.mesh = {};
        const std::string_view what = error.what();
        reading.problems.push_back({0, std::string(what.substr(path.size() + 4))});
    }
    return reading;
}

MeshShape read_mesh(const std::string& path) {
    MeshReading reading = read_mesh_file(path);
    if (!reading.problems.empty()) {
        throw Error(text_of(path, reading.problems.front()));
    }
    return std::move(reading.mesh);
}

std::string text_of(const std::string& path, const MeshRemark& remark) {
    std::string text = "'" + path + "': ";
    if (remark.line > 0) {
        text += fmt::format("line {}: ", remark.line);
    }
    return text + remark.sentence;
}

}  // namespace carom::render
