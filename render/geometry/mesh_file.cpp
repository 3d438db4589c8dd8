#include "render/geometry/mesh_file.h"

#include <fstream>
#include <ios>

#include "render/geometry/file_text.h"
#include "render/geometry/obj_file.h"
#include "render/geometry/ply_file.h"
#include "sim/timeline/error.h"
#include "sim/timeline/limits.h"

namespace carom::render {

namespace {

constexpr std::streamoff kMaxFileBytes = 1'000'000'000;

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error("'" + path + "': " + what);
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
        refuse(path, "the mesh cannot be read to its end");
    }
    return text;
}

MeshShape read_mesh(const std::string& path) {
    return is_ply(path) ? read_ply(path) : read_obj(path);
}

}  // namespace carom::render
