// The data of a PreparedScene. Internal to this folder and its tests.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "render/frame/aov_planes.h"
#include "render/frame/frame.h"
#include "render/frame_scene/cut_outs.h"
#include "render/frame_scene/static_geometry.h"
#include "render/light/far_light.h"
#include "render/light/light_set.h"
#include "render/material/material.h"
#include "render/scene/scene_problems.h"

namespace carom::render {

/// What the materials of a scene, which are borrowed, say.
class MaterialCutOuts final : public CutOuts {
  public:
    explicit MaterialCutOuts(const std::vector<Material>& materials) : materials_(materials) {}

    [[nodiscard]] bool is_cut_out(std::uint32_t material) const override {
        return materials_[material].is_cut_out();
    }
    [[nodiscard]] float opacity(const SurfacePoint& point) const override {
        return materials_[point.material].textures().opacity_at(point);
    }

  private:
    const std::vector<Material>& materials_;
};

struct PreparedScene::Data {
    StaticGeometry geometry;
    std::vector<Material> materials;  // in the scene's order
    LightSet lights;
    std::uint32_t object_count = 0;  // of the scene, without lights
    RayBranches branches;
    SceneNames names;
    std::shared_ptr<const FarLight> far{};      // if something is
    std::optional<StaticGeometry> near{};       // likewise: what is in the near box
    std::optional<MaterialCutOuts> cut_outs{};  // likewise
};

}  // namespace carom::render
