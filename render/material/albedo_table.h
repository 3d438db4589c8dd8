// Directional albedo of lobes, tabulated over the angle.
#pragma once

#include <array>

#include "render/material/albedo_numbers.h"

namespace carom::render {

/// Directional albedo of a lobe over the cosine of the outgoing direction: by quadrature to about
/// 1e-3, and interpolated linearly between nodes that are densest at grazing angles. Zero until
/// built.
class AlbedoTable {
  public:
    /// Rough dielectric boundary of index `ior`; `alpha` >= kSmoothAlpha.
    [[nodiscard]] static AlbedoTable of_dielectric(float alpha, float ior);
    /// Microfacets that reflect everything: the fraction that single scattering keeps.
    [[nodiscard]] static AlbedoTable of_mirrors(float alpha);
    /// Rough boundary of glass; `index`: of the far side over the near side. The fraction that
    /// single scattering reflects or transmits.
    [[nodiscard]] static AlbedoTable of_glass(float alpha, float index);
    [[nodiscard]] static AlbedoTable of_sheen();
    /// A lobe cos^n around an axis, `exponent` n >= 0: the fraction of it on the axis' side of the
    /// surface, over the cosine of the axis to the normal.
    [[nodiscard]] static AlbedoTable of_cosine_lobe(double exponent);

    [[nodiscard]] float at(float cosine) const;
    [[nodiscard]] const std::array<float, kAlbedoNodes>& values() const { return values_; }

  private:
    template <class Albedo>
    static AlbedoTable build(const Albedo& albedo_at);

    std::array<float, kAlbedoNodes> values_{};
};

}  // namespace carom::render
