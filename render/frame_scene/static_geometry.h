// The geometry that all frames of a shot share: objects, meshes, the hierarchy over static shapes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <Imath/ImathBox.h>

#include "render/acceleration/structure_maker.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"

namespace carom::render {

struct SceneObject;  // scene_object.h

/// Built once per shot, then read by any number of threads.
///
/// Objects are numbered as in the scene. Lights with a surface follow them, in the order of the
/// scene's lights, so that rays hit them: a sphere light from all sides, a rectangle light only
/// from the side to which it radiates; rays from behind pass through it.
class StaticGeometry {
  public:
    /// Reads the mesh files. Throws Error that names the object or file: a mesh that cannot be
    /// read, a material that the scene lacks, a transform that is not invertible, a size that is
    /// not positive. `maker`: as for PreparedScene.
    StaticGeometry(const SceneDescription& scene, const RenderSettings& settings,
                   StructureMaker maker = {});
    ~StaticGeometry();
    StaticGeometry(StaticGeometry&&) noexcept;
    StaticGeometry& operator=(StaticGeometry&&) noexcept;
    StaticGeometry(const StaticGeometry&) = delete;
    StaticGeometry& operator=(const StaticGeometry&) = delete;

    /// Including the lights that follow the scene's objects.
    [[nodiscard]] std::size_t object_count() const;

    /// Index in SceneDescription::lights if the object is a light.
    [[nodiscard]] std::optional<std::uint32_t> light_of_object(std::uint32_t object) const;

    /// The object of a light; none for lights without a surface.
    [[nodiscard]] std::optional<std::uint32_t> object_of_light(std::uint32_t light) const;

    /// The object as described in the scene.
    [[nodiscard]] const SceneObject& object(std::uint32_t object) const;

    [[nodiscard]] const std::string& name_of_object(std::uint32_t object) const;

    /// Index in SceneDescription::materials; kNoMaterial for lights.
    [[nodiscard]] std::uint32_t material_of_object(std::uint32_t object) const;

    /// The same objects, but rays meet only those whose bounds meet the box, and what follows
    /// tracks.
    [[nodiscard]] StaticGeometry within(const Imath::Box3f& box) const;

    struct Data;
    [[nodiscard]] const Data& data() const { return *data_; }

  private:
    explicit StaticGeometry(std::unique_ptr<const Data> data);
    std::unique_ptr<const Data> data_;
};

}  // namespace carom::render
