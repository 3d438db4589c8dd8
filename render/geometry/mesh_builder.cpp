#include "render/geometry/mesh_builder.h"

#include <span>
#include <unordered_map>

#include <fmt/core.h>

#include "render/geometry/polygon.h"

namespace carom::render {
namespace {

struct CornerHash {
    std::size_t operator()(const MeshCorner& corner) const {
        std::size_t hash = corner[0];
        for (const std::uint32_t part : {corner[1], corner[2]}) {
            hash = (hash ^ (hash >> 29)) * 0x9e3779b97f4a7c15ull + part;
        }
        return hash ^ (hash >> 32);
    }
};

/// The faces that lack one of the things that corners may have.
struct Lacking {
    std::size_t field;
    MeshBlemish blemish;
    bool is_given = false;  // by any corner
    std::size_t faces = 0;  // with a corner that lacks it
    std::size_t first_line = 0;

    void look_at(std::span<const MeshCorner> corners, std::size_t line) {
        bool lacks = false;
        for (const MeshCorner& corner : corners) {
            lacks = lacks || corner[field] == kNoIndex;
            is_given = is_given || corner[field] != kNoIndex;
        }
        first_line = lacks && faces == 0 ? line : first_line;
        faces += lacks ? 1 : 0;
    }

    void report(MeshBlemishes& blemishes) const {
        if (is_given && faces > 0) {
            blemishes.add(blemish, first_line, faces);
        }
    }
};

class Builder {
  public:
    Builder(const MeshFaces& faces, MeshReading& reading, MeshBlemishes& blemishes)
        : faces_(faces), mesh_(reading.mesh), reading_(reading), blemishes_(blemishes) {}

    void build(std::optional<std::uint32_t> material) {
        first_vertex_.assign(faces_.points.size(), kNoIndex);
        PolygonCutter cutter(faces_.corners.size());
        std::vector<std::uint32_t> indices;
        std::span<const MeshCorner> left(faces_.corners);
        for (const MeshFaces::Face& face : faces_.faces) {
            const auto corners = left.first(face.corner_count);
            left = left.subspan(face.corner_count);
            if (material && face.material != *material) {
                continue;
            }
            indices.clear();
            for (const MeshCorner& corner : corners) {
                check_references(corner, face.line);
                indices.push_back(vertex_of(corner));
            }
            uv_.look_at(corners, face.line);
            normals_.look_at(corners, face.line);
            if (!cutter.cut(mesh_.vertices, indices, mesh_.triangles)) {
                refuse(face.line, kTooManyCorners);
            }
            reading_.triangle_materials.resize(mesh_.triangles.size(), face.material);
        }
        if (uv_.faces > 0) {
            mesh_.uv.clear();
        }
        if (normals_.faces > 0) {
            mesh_.normals.clear();
        }
        uv_.report(blemishes_);
        normals_.report(blemishes_);
    }

  private:
    void check_references(const MeshCorner& corner, std::size_t line) const {
        const std::array counts{faces_.points.size(), faces_.uv.size(), faces_.normals.size()};
        for (std::size_t field = 0; field < 3; ++field) {
            if (corner[field] != kNoIndex && corner[field] >= counts[field]) {
                refuse(line,
                       reference_problem(field, std::to_string(std::uint64_t{corner[field]} + 1),
                                         counts[field]));
            }
        }
    }

    std::uint32_t vertex_of(const MeshCorner& corner) {
        std::uint32_t& first = first_vertex_[corner[0]];
        if (first == kNoIndex) {
            first = add_vertex(corner);
            return first;
        }
        if (corners_of_vertices_[first] == corner) {
            return first;
        }
        const auto [known, is_new] = further_vertices_.try_emplace(
            corner, static_cast<std::uint32_t>(mesh_.vertices.size()));
        return is_new ? add_vertex(corner) : known->second;
    }

    std::uint32_t add_vertex(const MeshCorner& corner) {
        mesh_.vertices.push_back(faces_.points[corner[0]]);
        mesh_.uv.push_back(corner[1] == kNoIndex ? Vec2(0, 0) : faces_.uv[corner[1]]);
        mesh_.normals.push_back(corner[2] == kNoIndex ? Vec3(0, 0, 0) : faces_.normals[corner[2]]);
        corners_of_vertices_.push_back(corner);
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    const MeshFaces& faces_;
    MeshShape& mesh_;
    MeshReading& reading_;
    MeshBlemishes& blemishes_;
    Lacking uv_{1, MeshBlemish::some_corners_without_uv};
    Lacking normals_{2, MeshBlemish::some_corners_without_normal};
    std::vector<std::uint32_t> first_vertex_;  // of each point, or kNoIndex
    std::vector<MeshCorner> corners_of_vertices_;
    std::unordered_map<MeshCorner, std::uint32_t, CornerHash> further_vertices_;
};

}  // namespace

std::string reference_problem(std::size_t field, std::string_view index, std::size_t count) {
    static constexpr std::array kKinds = {"vertex", "texture coordinate", "normal"};
    return fmt::format("a face refers to {} {}, but {} {}", kKinds[field], index.substr(0, 24),
                       index.starts_with('-') ? "before it are only" : "the file has only", count);
}

void build_mesh(const MeshFaces& faces, MeshReading& reading, MeshBlemishes& blemishes,
                std::optional<std::uint32_t> material) {
    Builder(faces, reading, blemishes).build(material);
}

}  // namespace carom::render
