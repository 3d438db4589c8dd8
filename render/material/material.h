// A material ready for shading. Both sides of a surface scatter alike, except those of glass.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/geometry/ray.h"
#include "render/material/albedo_tables.h"
#include "render/material/glass.h"
#include "render/material/lobe_constants.h"
#include "render/material/material_textures.h"
#include "render/material/phong.h"
#include "render/material/scalar_kernels.h"
#include "render/scene/material_description.h"

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
    [[nodiscard]] const TexturesOfMaterial& textures() const { return textures_; }
    /// Whether its numbers vary over the surface; `numbers` then has others in their place.
    [[nodiscard]] bool varies() const { return textures_.numbers().varies; }
    /// Of a kind, for as many roughnesses.
    [[nodiscard]] int table_slices() const { return varies() ? kAlbedoSlices : 1; }
    /// Whether it has somewhere, or may have, a rough coat.
    [[nodiscard]] bool has_rough_coat() const;

    /// Albedo or reflectance if it is constant over the surface.
    [[nodiscard]] std::optional<V3f> constant_base() const;

    /// The model for the distributed integrator.
    [[nodiscard]] const PhongModel& phong() const { return phong_; }
    /// Radiance of the surface's front, W/(m^2 sr); if it varies, grey and about its mean.
    [[nodiscard]] const V3f& emission() const { return emission_; }
    [[nodiscard]] bool is_emissive() const { return emission_ != V3f(0, 0, 0); }
    [[nodiscard]] V3f mean_emission() const {
        return emission_varies() ? textures_.mean_emission() : emission_;
    }
    [[nodiscard]] bool emission_varies() const { return textures_.numbers().emission >= 0; }
    /// Whether rays may pass by it as if it were not there.
    [[nodiscard]] bool is_cut_out() const {
        const NumberPick& opacity = textures_.numbers().opacity;
        return opacity.texture >= 0 || opacity.at_zero < 1;
    }

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
    [[nodiscard]] bool has_relief() const {
        return textures_.numbers().relief.kind != ReliefParameters::Kind::none;
    }
    void keep(const AlbedoTable& table, const float*& numbers);
    /// The tables of all roughnesses, or of this alpha if roughness does not vary.
    template <class Table>
    void keep_slices(float alpha, const Table& table_of, const float*& numbers);

    TexturesOfMaterial textures_;
    scalar::LayersOf<scalar::One> numbers_{};
    std::vector<std::shared_ptr<const std::vector<float>>> tables_;
    std::shared_ptr<const GlassConstants> glass_;
    PhongModel phong_;
    V3f emission_{0, 0, 0};
};

}  // namespace carom::render
