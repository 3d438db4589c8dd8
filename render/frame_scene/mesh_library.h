// The meshes of a scene, of which equal ones are kept once. Internal to this folder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "core/hash.h"
#include "render/frame_scene/scene_object.h"

namespace carom::render {

/// Small meshes, and those that one object has, are mapped to the axes of the world or the body, in
/// which rays find them fastest. A mesh that many objects have would take its memory for each, so
/// that it stays in axes of its own.
class MeshLibrary {
  public:
    /// Reads the mesh files of `scene`, which outlives this object. Without `may_share` all meshes
    /// are mapped. Throws Error that names the file.
    MeshLibrary(const SceneDescription& scene, bool may_share);

    /// Sets the object's mesh, its axes and its bounding radius. Throws Error that names the
    /// object.
    void give(SceneObject& object, const ObjectDescription& description);

  private:
    /// Equal for meshes that can have the same triangles and normals in axes of their own. Normals
    /// that are made from angles depend on how the mesh is stretched: the entries of the map's
    /// metric, so that turned and mirrored meshes are equal.
    struct Key {
        Hash128 content;
        double smooth_angle = 0;
        std::array<std::int64_t, 6> stretch{};

        [[nodiscard]] bool operator<(const Key& other) const {
            return std::tie(content, smooth_angle, stretch) <
                   std::tie(other.content, other.smooth_angle, other.stretch);
        }
    };
    struct Mesh {
        const MeshShape* shape = nullptr;
        Mat44 own_from_object{};
        std::size_t objects = 0;
        std::shared_ptr<const TriangleMesh> own;  // may be null
        std::map<std::array<double, 16>, std::shared_ptr<const TriangleMesh>> mapped;  // by map

        [[nodiscard]] bool is_shared() const;
    };
    struct File {
        const MeshShape* shape = nullptr;
        Hash128 content;
    };

    [[nodiscard]] const File& file_of(const MeshShape& shape);
    [[nodiscard]] Key key_of(const MeshShape& shape, const Mat44& map);

    bool may_share_;
    std::deque<MeshShape> read_;
    std::map<std::string, File> files_;              // by path
    std::map<const MeshShape*, File> descriptions_;  // without a file
    std::map<Key, Mesh> meshes_;
};

}  // namespace carom::render
