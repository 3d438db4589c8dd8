// A material ready for shading. Both sides of a surface scatter alike, except those of glass.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/geometry/ray.h"
#include "render/material/albedo_tables.h"
#include "render/material/glass.h"
#include "render/material/lobe_constants.h"
#include "render/material/phong.h"
#include "render/material/scalar_kernels.h"
#include "render/scene/material_description.h"
#include "render/texture/texture.h"

namespace carom::render {

/// Immutable; shared by all threads.
class Material {
  public:
    /// Throws Error if a texture's file is missing.
    Material(const StandardMaterial& description, ImageCache& images, AlbedoTables& tables);
    Material(const PhongMaterial& description, ImageCache& images);

    /// All numbers for kernels; borrows the tables.
    [[nodiscard]] const scalar::LayersOf<scalar::One>& numbers() const { return numbers_; }
    /// Null: not transmissive.
    [[nodiscard]] const GlassConstants* glass() const { return glass_.get(); }
    [[nodiscard]] const Texture& texture() const { return texture_; }
    /// Strength of the texture's relief, 0 without one.
    [[nodiscard]] float bump() const { return bump_; }

    /// Albedo or reflectance if it is constant over the surface.
    [[nodiscard]] std::optional<V3f> constant_base() const;

    /// The model for the distributed integrator.
    [[nodiscard]] const PhongModel& phong() const { return phong_; }
    /// Radiance of the surface's front, W/(m^2 sr).
    [[nodiscard]] const V3f& emission() const { return emission_; }
    [[nodiscard]] bool is_emissive() const { return emission_ != V3f(0, 0, 0); }

    /// Whether it reflects specularly by a smooth coat or a smooth base, everywhere along the
    /// geometric normal and with constant reflectance.
    [[nodiscard]] bool is_mirror() const;
    /// Whether it is smooth glass and nothing else.
    [[nodiscard]] bool is_clear_glass() const;
    /// For a mirror: the specular reflectance at an angle with this cosine.
    [[nodiscard]] V3f mirror_reflectance(float cosine) const;

    /// Whether it transmits light.
    [[nodiscard]] bool is_transmissive() const {
        return is_glass() || (is_phong() && phong_.transmittance != V3f(0, 0, 0));
    }

    [[nodiscard]] bool is_phong() const { return numbers_.any_phong; }
    [[nodiscard]] bool is_glass() const { return numbers_.any_glass; }

  private:
    void set_layers(const StandardMaterial& m, AlbedoTables& tables);
    void set_phong();
    void keep(const AlbedoTable& table, const float*& numbers);

    Texture texture_;
    scalar::LayersOf<scalar::One> numbers_{};
    std::vector<std::shared_ptr<const AlbedoTable>> tables_;
    std::shared_ptr<const GlassConstants> glass_;
    PhongModel phong_;
    V3f emission_{0, 0, 0};
    float bump_ = 0;
};

}  // namespace carom::render
