#include "render/geometry/mesh_file.h"

#include <algorithm>
#include <fstream>
#include <ios>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "core/limits.h"
#include "render/geometry/mesh_text.h"
#include "render/geometry/obj_file.h"
#include "render/geometry/ply_file.h"
#include "render/geometry/validity.h"

namespace carom::render {
namespace {

constexpr std::streamoff kMaxFileBytes = 1'000'000'000;

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) {
        refuse(0, "the mesh cannot be opened");
    }
    const std::streamoff size = file.tellg();
    if (size < 0 || size > static_cast<std::streamoff>(input_limit(kMaxFileBytes))) {
        refuse(0,
               std::string("the mesh is larger than 1 GB or not a file") + how_to_raise_limits());
    }
    std::string text(static_cast<std::size_t>(size), '\0');
    file.seekg(0);
    file.read(text.data(), size);
    if (!file) {
        refuse(0, "the mesh file cannot be read completely");
    }
    return text;
}

/// Without the byte order mark of UTF-8. Throws MeshRefusal for a text in UTF-16 or UTF-32.
std::string_view without_mark(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.remove_prefix(3);
    }
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
        text.starts_with(std::string_view("\0\0\xFE\xFF", 4))) {
        refuse(0, "a text in UTF-16 or UTF-32; save it as UTF-8");
    }
    return text;
}

void check_no_zero_byte(std::string_view text) {
    const std::size_t at = text.find('\0');
    if (at == std::string_view::npos) {
        return;
    }
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const bool is_wide =
        at < 8 && text.size() > at + 2 && text[at + 1] != '\0' && text[at + 2] == '\0';
    refuse(static_cast<std::size_t>(line),
           is_wide ? "a text in UTF-16; save it as UTF-8" : "a zero byte; this is not an OBJ file");
}

/// Physics, plans and exports use the numbers unchecked.
void check_numbers(MeshShape& mesh, MeshBlemishes& blemishes) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (!is_finite(V3f(mesh.vertices[i]))) {
            refuse(0, fmt::format("vertex {} is not a finite point", i));
        }
    }
    for (Vec3& normal : mesh.normals) {
        const V3f narrow(normal);
        if (!is_finite(narrow) || !(narrow.length() > 0)) {
            normal = is_finite(narrow) ? normal : Vec3(0, 0, 0);
            blemishes.add(MeshBlemish::bad_normal, 0);
        }
    }
    for (Vec2& uv : mesh.uv) {
        if (!is_finite(V3f(Vec3(uv.x, uv.y, 0)))) {
            uv = Vec2(0, 0);
            blemishes.add(MeshBlemish::bad_uv, 0);
        }
    }
}

MeshReading read_whole_ply(std::string_view text) {
    MeshBlemishes blemishes;
    MeshReading reading = read_ply(text, blemishes);
    check_numbers(reading.mesh, blemishes);
    reading.warnings = blemishes.warnings();
    return reading;
}

/// Calls one of the two with the text of a file.
template <class ReadPly, class ReadObj>
auto read_with(const std::string& path, const ReadPly& ply, const ReadObj& obj) {
    const std::string bytes = read_text(path);
    const std::string_view text = without_mark(bytes);
    if (is_ply(text)) {
        return ply(text);
    }
    check_no_zero_byte(text);
    return obj(text);
}

MeshReading refused(const MeshRefusal& refusal) {
    MeshReading reading;
    reading.problems.push_back(refusal.remark);
    return reading;
}

}  // namespace

MeshReading read_mesh_file(const std::string& path) {
    try {
        return read_with(path, read_whole_ply, read_obj);
    } catch (const MeshRefusal& refusal) {
        return refused(refusal);
    }
}

std::vector<MeshReading> read_mesh_parts(const std::string& path) {
    const auto whole = [](std::string_view text) { return std::vector{read_whole_ply(text)}; };
    try {
        return read_with(path, whole, read_obj_parts);
    } catch (const MeshRefusal& refusal) {
        return {refused(refusal)};
    }
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
