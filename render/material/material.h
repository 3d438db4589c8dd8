// A material ready for shading. Both sides of a surface scatter alike, except those of glass.
#pragma once

#include <memory>
#include <optional>

#include "render/geometry/ray.h"
#include "render/material/albedo_tables.h"
#include "render/material/glass.h"
#include "render/material/lobe_constants.h"
#include "render/material/phong.h"
#include "render/material/scalar_kernels.h"
#include "render/scene/material_description.h"
#include "render/texture/texture.h"

namespace carom::render {

/// The part of a `standard` material that does not vary over the surface. From the top down: coat,
/// sheen, then metal or dielectric highlight over a diffuse base. Each layer takes from the layers
/// below what it scatters itself towards the viewer, so that no layering creates energy.
struct LayerConstants {
    float coat_weight = 0;
    float coat_ior = 1.5f;
    float coat_alpha = 0;  // 0: a smooth mirror
    AlbedoTable coat_albedo;

    float sheen = 0;
    V3f sheen_colour{1, 1, 1};
    AlbedoTable sheen_albedo;

    float metal = 0;
    float specular = 0;
    float alpha = 0;  // of metal and highlight, 0: a smooth mirror
    AlbedoTable specular_albedo;
    AlbedoTable mirror_albedo;

    float transmission = 0;                       // fraction of the base that is glass
    std::shared_ptr<const GlassConstants> glass;  // null: not transmissive
};

/// Immutable; shared by all threads.
class Material {
  public:
    /// Throws Error if a texture's file is missing.
    Material(const StandardMaterial& description, ImageCache& images, AlbedoTables& tables);
    Material(const PhongMaterial& description, ImageCache& images);

    [[nodiscard]] const LayerConstants& layers() const { return layers_; }
    /// All numbers for kernels; borrows the tables.
    [[nodiscard]] scalar::LayersOf<scalar::One> numbers() const;
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
        return layers_.glass != nullptr || (is_phong_ && phong_.transmittance != V3f(0, 0, 0));
    }

    [[nodiscard]] bool is_phong() const { return is_phong_; }
    [[nodiscard]] bool is_glass() const { return layers_.glass != nullptr; }

  private:
    Texture texture_;
    LayerConstants layers_;
    PhongModel phong_;
    bool is_phong_ = false;
    V3f emission_{0, 0, 0};
    float bump_ = 0;
};

}  // namespace carom::render
