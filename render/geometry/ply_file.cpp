#include "render/geometry/ply_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <span>

#include <fmt/core.h>

#include "core/error.h"
#include "core/limits.h"
#include "render/geometry/file_text.h"
#include "render/geometry/ply_values.h"
#include "render/geometry/polygon.h"
#include "render/geometry/triangle_mesh.h"

namespace carom::render {
namespace {

constexpr std::size_t kMaxCorners = 1'024;  // of one face

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error("'" + path + "': " + what);
}

/// The role of a property of `vertex`: 0 to 2 the position, 3 to 5 the normal, 6 and 7 uv; -1 none.
int slot_of(const PlyProperty& property) {
    static constexpr const char* kNames[8][4] = {
        {"x", "x", "x", "x"},
        {"y", "y", "y", "y"},
        {"z", "z", "z", "z"},
        {"nx", "nx", "nx", "nx"},
        {"ny", "ny", "ny", "ny"},
        {"nz", "nz", "nz", "nz"},
        {"s", "u", "texture_u", "texture_s"},
        {"t", "v", "texture_v", "texture_t"},
    };
    if (property.is_list) {
        return -1;
    }
    for (int slot = 0; slot < 8; ++slot) {
        for (const char* name : kNames[slot]) {
            if (property.name == name) {
                return slot;
            }
        }
    }
    return -1;
}

class PlyReader {
  public:
    PlyReader(const std::string& text, const std::string& path)
        : path_(path), header_(read_ply_header(text, path)), values_(text, header_, path) {}

    MeshShape read() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                read_vertices(element);
            } else if (element.name == "face") {
                read_faces(element);
            } else {
                skip(element);
            }
        }
        if (face_sizes_.empty()) {
            refuse(path_, "the file has no faces");
        }
        make_triangles();
        return std::move(mesh_);
    }

  private:
    void skip(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                values_.skip(property);
            }
        }
    }

    void read_vertices(const PlyElement& element) {
        if (element.count > input_limit(kMaxMeshVertices) || !mesh_.vertices.empty()) {
            refuse(path_, beyond_limit(input_limit(kMaxMeshVertices), "vertices"));
        }
        std::vector<int> slots;
        std::array<bool, 8> has{};
        for (const PlyProperty& property : element.properties) {
            slots.push_back(slot_of(property));
            if (slots.back() >= 0) {
                has[static_cast<std::size_t>(slots.back())] = true;
            }
        }
        if (!has[0] || !has[1] || !has[2]) {
            refuse(path_, "its vertices have no x, y and z");
        }
        const bool has_normals = has[3] && has[4] && has[5];
        const bool has_uv = has[6] && has[7];
        mesh_.vertices.reserve(element.count);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            std::array<double, 8> value{};
            for (std::size_t k = 0; k < slots.size(); ++k) {
                if (slots[k] < 0) {
                    values_.skip(element.properties[k]);
                } else {
                    value[static_cast<std::size_t>(slots[k])] =
                        values_.next(element.properties[k].type);
                }
            }
            mesh_.vertices.emplace_back(value[0], value[1], value[2]);
            if (has_normals) {
                mesh_.normals.emplace_back(value[3], value[4], value[5]);
            }
            if (has_uv) {
                mesh_.uv.emplace_back(value[6], value[7]);
            }
        }
    }

    void read_faces(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                const bool is_corners = property.is_list && (property.name == "vertex_indices" ||
                                                             property.name == "vertex_index");
                if (is_corners) {
                    read_corners(property);
                } else {
                    values_.skip(property);
                }
            }
        }
    }

    void read_corners(const PlyProperty& property) {
        const std::size_t count = values_.next_count(property.count_type);
        if (count < 3 || count > kMaxCorners) {
            refuse(path_,
                   fmt::format("a face of {} corners (3 to {} are possible)", count, kMaxCorners));
        }
        for (std::size_t k = 0; k < count; ++k) {
            const double index = values_.next(property.type);
            if (!(index >= 0) || index != std::floor(index) || index > 4294967295.0) {
                refuse(path_,
                       "a face has a vertex index that is negative, fractional or too large");
            }
            corners_.push_back(static_cast<std::uint32_t>(index));
        }
        face_sizes_.push_back(static_cast<std::uint32_t>(count));
        triangle_count_ += count - 2;
        if (triangle_count_ > input_limit(kMaxMeshTriangles)) {
            refuse(path_, beyond_limit(input_limit(kMaxMeshTriangles), "triangles"));
        }
    }

    void make_triangles() {
        mesh_.triangles.reserve(triangle_count_);
        std::span<const std::uint32_t> left(corners_);
        std::vector<Vec3> places;
        for (const std::uint32_t size : face_sizes_) {
            const auto corners = left.first(size);
            left = left.subspan(size);
            places.clear();
            for (const std::uint32_t corner : corners) {
                if (corner >= mesh_.vertices.size()) {
                    refuse(path_, fmt::format("a face refers to vertex {} of {}", corner,
                                              mesh_.vertices.size()));
                }
                places.push_back(mesh_.vertices[corner]);
            }
            if (size == 3) {
                mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
                continue;
            }
            for (const auto& cut : triangulate(places)) {
                mesh_.triangles.push_back({corners[cut[0]], corners[cut[1]], corners[cut[2]]});
            }
        }
    }

    const std::string& path_;
    PlyHeader header_;
    PlyValues values_;
    MeshShape mesh_;
    std::vector<std::uint32_t> corners_;     // of one face after another
    std::vector<std::uint32_t> face_sizes_;  // corners of each
    std::size_t triangle_count_ = 0;
};

}  // namespace

bool is_ply(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    char start[4] = {};
    file.read(start, sizeof start);
    return file && start[0] == 'p' && start[1] == 'l' && start[2] == 'y' &&
           (start[3] == '\n' || start[3] == '\r');
}

MeshShape read_ply(const std::string& path) {
    const std::string text = read_mesh_text(path);
    return PlyReader(text, path).read();
}

}  // namespace carom::render
