// Fuzzes the readers of mesh files. Any bytes must give an Error, or triangles with valid indices
// and finite numbers.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "core/error.h"
#include "render/geometry/mesh_file.h"
#include "render/geometry/validity.h"

namespace {

void require(bool condition, const char* what) {
    if (condition) {
        return;
    }
    std::fprintf(stderr, "an accepted mesh: %s\n", what);
    std::abort();
}

void check(const carom::render::MeshShape& mesh) {
    require(!mesh.triangles.empty(), "without a triangle");
    for (const auto& vertex : mesh.vertices) {
        require(carom::render::is_finite(Imath::V3f(vertex)), "a vertex");
    }
    for (const auto& normal : mesh.normals) {
        require(carom::render::is_finite(Imath::V3f(normal)), "a normal");
    }
    for (const auto& uv : mesh.uv) {
        require(std::isfinite(uv.x) && std::isfinite(uv.y), "a uv");
    }
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t index : triangle) {
            require(index < mesh.vertices.size(), "an index");
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string path = std::filesystem::temp_directory_path() /
                                    ("carom_fuzz_" + std::to_string(::getpid()) + ".obj");
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    try {
        check(carom::render::read_mesh(path));
    } catch (const carom::Error&) {
    }
    return 0;
}
