// What all frames of a shot share: the table of objects, meshes, the hierarchy over still ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "render/acceleration/structure_factory.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// Built once per shot, then only read, by any number of threads.
///
/// Objects are numbered as in the scene. Lights that have an area follow them, in the order of the
/// scene's lights, so that rays find them: a sphere light from all sides, a rectangle light only
/// from the side to which it radiates; rays from behind pass through it.
class StaticGeometry {
  public:
    /// Reads the mesh files. Throws Error that names the object or file: a mesh that cannot be
    /// read, a material that the scene does not have, a transform that cannot be inverted, a size
    /// that is not positive; or whose sentence is that of find_problem().
    StaticGeometry(const SceneDescription& scene, const RenderSettings& settings,
                   StructureFactory factory = nullptr);
    ~StaticGeometry();
    StaticGeometry(StaticGeometry&&) noexcept;
    StaticGeometry& operator=(StaticGeometry&&) noexcept;
    StaticGeometry(const StaticGeometry&) = delete;
    StaticGeometry& operator=(const StaticGeometry&) = delete;

    /// With the lights that follow the scene's objects.
    [[nodiscard]] std::size_t object_count() const;

    /// Index in SceneDescription::lights if the object is a light.
    [[nodiscard]] std::optional<std::uint32_t> light_of_object(std::uint32_t object) const;

    /// The object that stands for a light; nothing for an environment.
    [[nodiscard]] std::optional<std::uint32_t> object_of_light(std::uint32_t light) const;

    [[nodiscard]] const std::string& name_of_object(std::uint32_t object) const;

    /// Index in SceneDescription::materials; kNoMaterial for lights.
    [[nodiscard]] std::uint32_t material_of_object(std::uint32_t object) const;

    struct Data;
    [[nodiscard]] const Data& data() const { return *data_; }

  private:
    std::unique_ptr<const Data> data_;
};

}  // namespace carom::render
