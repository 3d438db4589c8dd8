#include "render/geometry/ply_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/limits.h"
#include "render/geometry/mesh_builder.h"
#include "render/geometry/ply_values.h"
#include "render/geometry/polygon.h"
#include "render/geometry/triangle_mesh.h"
#include "render/geometry/validity.h"

namespace carom::render {
namespace {

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

bool is_list_of(const PlyProperty& property, std::initializer_list<const char*> names) {
    return property.is_list && std::find(names.begin(), names.end(), property.name) != names.end();
}

struct PlaceHash {
    std::size_t operator()(const std::pair<double, double>& place) const {
        const std::hash<double> hash;
        return hash(place.first) * 0x9e3779b97f4a7c15ull ^ hash(place.second);
    }
};

class PlyReader {
  public:
    PlyReader(std::string_view text, MeshBlemishes& blemishes)
        : header_(read_ply_header(text)), values_(text, header_), blemishes_(blemishes) {}

    MeshReading read() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                read_vertices(element);
            } else if (element.name == "face") {
                read_faces(element);
            } else if (element.name == "tristrips") {
                read_strips(element);
            } else {
                skip(element);
            }
        }
        if (faces_.faces.empty()) {
            refuse(0, "the file has no faces");
        }
        if (has_uv_of_corners_) {
            make_mesh_with_corners();
        } else {
            make_mesh();
        }
        reading_.pictures = std::move(header_.pictures);
        return std::move(reading_);
    }

  private:
    void skip(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            values_.begin_element();
            for (const PlyProperty& property : element.properties) {
                values_.skip(property);
            }
        }
    }

    void read_vertices(const PlyElement& element) {
        if (element.count > input_limit(kMaxMeshVertices) || !faces_.points.empty()) {
            refuse(0, beyond_limit(input_limit(kMaxMeshVertices), "vertices"));
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
            refuse(0, "its vertices have no x, y and z");
        }
        const bool has_normals = has[3] && has[4] && has[5];
        const bool has_uv = has[6] && has[7];
        faces_.points.reserve(element.count);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            const std::array<double, 8> value = read_vertex(element, slots);
            faces_.points.emplace_back(value[0], value[1], value[2]);
            if (!is_finite(V3f(faces_.points.back()))) {
                refuse(values_.line(), fmt::format("vertex {} is not a finite point", i));
            }
            if (has_normals) {
                faces_.normals.emplace_back(value[3], value[4], value[5]);
            }
            if (has_uv) {
                faces_.uv.emplace_back(value[6], value[7]);
            }
        }
    }

    /// `slots`: the role of each property.
    std::array<double, 8> read_vertex(const PlyElement& element, const std::vector<int>& slots) {
        std::array<double, 8> value{};
        values_.begin_element();
        for (std::size_t k = 0; k < slots.size(); ++k) {
            if (slots[k] < 0) {
                values_.skip(element.properties[k]);
            } else {
                value[static_cast<std::size_t>(slots[k])] =
                    values_.next(element.properties[k].type);
            }
        }
        return value;
    }

    void read_faces(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            values_.begin_element();
            std::size_t corners = 0;
            uv_.clear();
            bool has_uv = false;
            for (const PlyProperty& property : element.properties) {
                if (is_list_of(property, {"vertex_indices", "vertex_index"})) {
                    corners = read_corners(property);
                } else if (is_list_of(property, {"texcoord", "texcoords"})) {
                    has_uv = true;
                    read_uv(property);
                } else if (!property.is_list && property.name == "texnumber") {
                    check_picture(values_.next(property.type));
                } else {
                    values_.skip(property);
                }
            }
            if (corners > 0 && has_uv) {
                set_uv(corners);
            }
        }
    }

    std::uint32_t read_index(const PlyProperty& property) {
        const double index = values_.next(property.type);
        if (!(index >= 0) || index != std::floor(index) || index >= kNoIndex) {
            refuse(values_.line(),
                   "a face has a vertex index that is negative, fractional or too large");
        }
        return static_cast<std::uint32_t>(index);
    }

    std::size_t read_corners(const PlyProperty& property) {
        const std::size_t count = values_.next_count(property.count_type);
        check_corner_count(count, values_.line());
        for (std::size_t k = 0; k < count; ++k) {
            add_corner(read_index(property));
        }
        end_face(count);
        return count;
    }

    void add_corner(std::uint32_t vertex) {
        faces_.corners.push_back({vertex, kNoIndex, kNoIndex});
    }

    void end_face(std::size_t count) {
        faces_.faces.push_back(
            {static_cast<std::uint32_t>(count), MeshReading::kNoMaterial, values_.line()});
        triangle_count_ += count - 2;
        if (triangle_count_ > input_limit(kMaxMeshTriangles)) {
            refuse(values_.line(), beyond_limit(input_limit(kMaxMeshTriangles), "triangles"));
        }
    }

    /// Strips of triangles, one list or several; a negative index ends a strip. Every second
    /// triangle is turned round, so that all have the same front.
    void read_strips(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            values_.begin_element();
            for (const PlyProperty& property : element.properties) {
                if (is_list_of(property, {"vertex_indices", "vertex_index"})) {
                    read_strip(property);
                } else {
                    values_.skip(property);
                }
            }
        }
    }

    void read_strip(const PlyProperty& property) {
        const std::size_t count = values_.next_count(property.count_type);
        std::array<std::uint32_t, 3> last{};
        std::size_t length = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const double index = values_.next(property.type);
            if (index < 0 && index == std::floor(index)) {
                length = 0;
                continue;
            }
            if (!(index < kNoIndex) || index != std::floor(index)) {
                refuse(values_.line(),
                       "a strip has a vertex index that is fractional or too large");
            }
            last = {last[1], last[2], static_cast<std::uint32_t>(index)};
            ++length;
            const bool is_triangle =
                length >= 3 && last[0] != last[1] && last[1] != last[2] && last[0] != last[2];
            if (is_triangle) {
                const bool is_turned = length % 2 == 0;
                add_corner(last[is_turned ? 1 : 0]);
                add_corner(last[is_turned ? 0 : 1]);
                add_corner(last[2]);
                end_face(3);
            }
        }
    }

    void check_picture(double number) {
        if (!first_picture_) {
            first_picture_ = number;
        } else if (number != *first_picture_) {
            blemishes_.add(MeshBlemish::several_pictures, values_.line());
        }
    }

    void read_uv(const PlyProperty& property) {
        const std::size_t count = values_.next_count(property.count_type);
        for (std::size_t k = 0; k < count; ++k) {
            uv_.push_back(values_.next(property.type));
        }
    }

    /// Gives the corners of the last face the uv that were read beside them.
    void set_uv(std::size_t corners) {
        if (uv_.empty()) {
            return;  // the face has none
        }
        if (uv_.size() != 2 * corners) {
            blemishes_.add(MeshBlemish::uv_count, values_.line());
            return;
        }
        has_uv_of_corners_ = true;
        for (std::size_t k = 0; k < corners; ++k) {
            Vec2 uv(uv_[2 * k], uv_[2 * k + 1]);
            if (!is_finite(V3f(Vec3(uv.x, uv.y, 0)))) {
                blemishes_.add(MeshBlemish::bad_uv, values_.line());
                uv = Vec2(0, 0);
            }
            // -0 and 0 are one place.
            const std::pair place(uv.x + 0.0, uv.y + 0.0);
            const auto [known, is_new] =
                uv_numbers_.try_emplace(place, static_cast<std::uint32_t>(uv_of_corners_.size()));
            if (is_new) {
                uv_of_corners_.emplace_back(place.first, place.second);
            }
            faces_.corners[faces_.corners.size() - corners + k][1] = known->second;
        }
    }

    /// With a uv for each corner: vertices are split where it differs between faces.
    void make_mesh_with_corners() {
        faces_.uv = std::move(uv_of_corners_);
        if (!faces_.normals.empty()) {
            for (MeshCorner& corner : faces_.corners) {
                corner[2] = corner[0];
            }
        }
        build_mesh(faces_, reading_, blemishes_);
    }

    void make_mesh() {
        MeshShape& mesh = reading_.mesh;
        mesh.vertices = std::move(faces_.points);
        mesh.normals = std::move(faces_.normals);
        mesh.uv = std::move(faces_.uv);
        mesh.triangles.reserve(triangle_count_);
        PolygonCutter cutter(faces_.corners.size());
        std::vector<std::uint32_t> indices;
        std::size_t first = 0;
        for (const MeshFaces::Face& face : faces_.faces) {
            indices.clear();
            for (std::size_t i = first; i < first + face.corner_count; ++i) {
                const std::uint32_t vertex = faces_.corners[i][0];
                if (vertex >= mesh.vertices.size()) {
                    refuse(face.line, fmt::format("a face refers to vertex {} of {}", vertex,
                                                  mesh.vertices.size()));
                }
                indices.push_back(vertex);
            }
            first += face.corner_count;
            if (!cutter.cut(mesh.vertices, indices, mesh.triangles)) {
                refuse(face.line, kTooManyCorners);
            }
        }
    }

    PlyHeader header_;
    PlyValues values_;
    MeshBlemishes& blemishes_;
    MeshFaces faces_;
    std::size_t triangle_count_ = 0;
    std::optional<double> first_picture_;
    std::vector<double> uv_;  // of a face
    std::vector<Vec2> uv_of_corners_;
    std::unordered_map<std::pair<double, double>, std::uint32_t, PlaceHash> uv_numbers_;
    bool has_uv_of_corners_ = false;
    MeshReading reading_;
};

}  // namespace

bool is_ply(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\f\v");
    if (first == std::string_view::npos || !text.substr(first).starts_with("ply")) {
        return false;
    }
    const std::string_view rest = text.substr(first + 3, 1);
    return !rest.empty() && (is_blank(rest[0]) || is_line_end(rest[0]));
}

MeshReading read_ply(std::string_view text, MeshBlemishes& blemishes) {
    return PlyReader(text, blemishes).read();
}

}  // namespace carom::render
