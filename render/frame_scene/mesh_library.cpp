#include "render/frame_scene/mesh_library.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <variant>

#include "render/geometry/mesh_file.h"
#include "render/geometry/smooth_normals.h"

namespace carom::render {
namespace {

/// Mapped copies of a mesh may have this many triangles: 8 MB of memory.
constexpr std::size_t kMostCopied = std::size_t{1} << 16;

Hash128 hash_of(const MeshShape& shape) {
    Hasher hasher;
    const auto add = [&](const auto& list) {
        hasher.add(std::uint64_t{list.size()});
        hasher.add_bytes(std::as_bytes(std::span(list)));
    };
    add(shape.vertices);
    add(shape.normals);
    add(shape.uv);
    add(shape.triangles);
    return hasher.finish();
}

/// The entries of linear * transposed(linear), as multiples of a millionth of its trace.
std::array<std::int64_t, 6> stretch_of(const Mat44& map) {
    const auto axis = [&](int row) { return Vec3(map[row][0], map[row][1], map[row][2]); };
    const double trace = axis(0).length2() + axis(1).length2() + axis(2).length2();
    const auto entry = [&](int row, int column) {
        return std::llround(axis(row).dot(axis(column)) / trace * 1e6);
    };
    return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
}

bool keeps_angles(const std::array<std::int64_t, 6>& stretch) {
    return stretch[0] == stretch[1] && stretch[1] == stretch[2] && stretch[3] == 0 &&
           stretch[4] == 0 && stretch[5] == 0;
}

Mat44 without_translation(Mat44 map) {
    map[3][0] = map[3][1] = map[3][2] = 0;
    return map;
}

std::shared_ptr<const TriangleMesh> made(const MeshShape& shape, double smooth_angle,
                                         const Mat44& map, const std::string& name) {
    TriangleMesh mesh = make_mesh(shape, map, name);
    if (smooth_angle > 0) {
        smooth_normals(mesh, smooth_angle);
    }
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

std::array<double, 16> numbers_of(const Mat44& map) {
    std::array<double, 16> numbers{};
    std::copy_n(map.getValue(), numbers.size(), numbers.begin());
    return numbers;
}

}  // namespace

bool MeshLibrary::Mesh::is_shared() const {
    return objects > 1 && (objects - 1) * shape->triangles.size() > kMostCopied;
}

const MeshLibrary::File& MeshLibrary::file_of(const MeshShape& shape) {
    if (shape.file.empty()) {
        const auto [place, is_new] = descriptions_.try_emplace(&shape);
        if (is_new) {
            place->second = {&shape, hash_of(shape)};
        }
        return place->second;
    }
    const auto [place, is_new] = files_.try_emplace(shape.file);
    if (is_new) {
        const MeshShape& read = read_.emplace_back(read_mesh(shape.file));
        place->second = {&read, hash_of(read)};
    }
    return place->second;
}

MeshLibrary::Key MeshLibrary::key_of(const MeshShape& shape, const Mat44& map) {
    Key key;
    key.content = file_of(shape).content;
    key.smooth_angle = shape.smooth_angle;
    if (shape.smooth_angle > 0) {
        key.stretch = stretch_of(map);
    }
    return key;
}

MeshLibrary::MeshLibrary(const SceneDescription& scene, bool may_share) : may_share_(may_share) {
    for (const ObjectDescription& object : scene.objects) {
        const auto* shape = std::get_if<MeshShape>(&object.shape);
        if (shape == nullptr) {
            continue;
        }
        const Key key = key_of(*shape, object.world_from_object);
        Mesh& mesh = meshes_[key];
        if (mesh.objects == 0) {
            mesh.shape = file_of(*shape).shape;
            mesh.own_from_object =
                keeps_angles(key.stretch) ? Mat44() : without_translation(object.world_from_object);
        }
        mesh.objects += 1;
    }
}

void MeshLibrary::give(SceneObject& object, const ObjectDescription& description) {
    const auto& shape = std::get<MeshShape>(description.shape);
    const Mat44& map = description.world_from_object;
    Mesh& mesh = meshes_.at(key_of(shape, map));
    object.mesh_is_mapped = may_share_ && mesh.is_shared();
    std::shared_ptr<const TriangleMesh>& found =
        object.mesh_is_mapped ? mesh.own : mesh.mapped[numbers_of(map)];
    if (!found) {
        found = made(*mesh.shape, shape.smooth_angle,
                     object.mesh_is_mapped ? mesh.own_from_object : map, object.name);
    }
    object.mesh = found;
    if (object.mesh_is_mapped) {
        object.frame = frame_of(mesh.own_from_object.inverse() * map);
    }
    object.bounding_radius = 0;
    for (const V3f& vertex : object.mesh->vertices) {
        object.bounding_radius =
            std::max(object.bounding_radius, object.place_of_vertex(vertex).length());
    }
}

}  // namespace carom::render
