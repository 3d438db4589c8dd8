// The boundary of glass, which reflects and refracts light.
#pragma once

#include <array>
#include <memory>

#include "render/geometry/ray.h"
#include "render/material/albedo_tables.h"
#include "render/scene/material_description.h"

namespace carom::render {

/// The part of a transmissive material that does not vary over the surface.
struct GlassConstants {
    float ior = 1.5f;         // of the inside over the outside, [1, 3]
    float alpha = 0;          // of the microfacets; 0: smooth
    V3f tint{1, 1, 1};        // factor on light that passes the surface
    V3f absorption{0, 0, 0};  // coefficient inside, 1/m
    /// For rough surfaces, seen from outside and from inside: the fraction that single scattering
    /// reflects, and the fraction that it reflects or transmits.
    std::array<AlbedoTable, 2> reflected;
    std::array<AlbedoTable, 2> kept;

    /// The fraction of light that remains after `distance` (m), by the Beer-Lambert law.
    [[nodiscard]] V3f transmittance(float distance) const;
};

/// Null for a material that transmits nothing.
[[nodiscard]] std::shared_ptr<const GlassConstants> glass_constants(const StandardMaterial& m,
                                                                    AlbedoTables& tables);

/// The boundary at one point, seen from one direction. Directions are unit, in the surface's own
/// axes; z is the normal on the viewer's side. Smooth boundaries have Fresnel's exact reflectance,
/// including total reflection. Rough ones follow Walter et al. 2007, "Microfacet models for
/// refraction through rough surfaces", sections 4 and 5, scaled to restore the energy that single
/// scattering between facets loses (as Turquin 2019 does for metals).
///
/// Values are in terms of basic radiance, radiance over the squared index of its medium, which
/// refraction conserves: there is no factor n^2 at the surface, and none for lights, which are all
/// outside.
class GlassLobe {
  public:
    /// `wo`: towards the viewer, wo.z > 0.
    GlassLobe(const GlassConstants& glass, bool is_inside, const V3f& wo);

    struct Value {
        float value = 0;  // times the cosine of `wi`, 1/sr
        float pdf = 0;    // 1/sr
    };
    /// For light from `wi`, on either side; both are 0 for a smooth surface.
    [[nodiscard]] Value evaluate(const V3f& wi) const;

    /// For a smooth surface: the reflectance.
    [[nodiscard]] float reflectance() const { return reflectance_; }
    /// For a smooth surface: the direction from which transmitted light comes; z < 0. Not at total
    /// reflection.
    [[nodiscard]] V3f refracted() const;

    /// For a rough surface: a direction with the density that `evaluate` returns; z > 0: reflected.
    /// It is (0, 0, 0), and to be rejected, if it is on the wrong side.
    [[nodiscard]] V3f sample(const V2f& u) const;

  private:
    const GlassConstants& glass_;
    V3f wo_;
    float index_;        // of the far side over the viewer's
    float reflectance_;  // smooth: Fresnel; rough: the probability of sampling a reflection
    float scale_ = 1;    // restores the energy that single scattering loses
};

}  // namespace carom::render
