// The boundary of glass: light is reflected or passes through, bent by Snell's law.
#pragma once

#include <array>
#include <memory>

#include "render/geometry/ray.h"
#include "render/material/albedo_table.h"
#include "render/scene/material_description.h"

namespace carom::render {

/// What does not vary over the surface of a material that light passes through.
struct GlassConstants {
    float ior = 1.5f;         // of the inside over the outside, [1, 3]
    float alpha = 0;          // of the microfacets; 0: smooth
    V3f tint{1, 1, 1};        // of what passes the surface
    V3f absorption{0, 0, 0};  // inside, 1/m
    /// Rough surfaces, seen from outside and from inside: share that single scattering reflects,
    /// and that it reflects or lets through.
    std::array<AlbedoTable, 2> reflected;
    std::array<AlbedoTable, 2> kept;

    /// Of the light that enters, what is left after `distance` (m): the law of Beer and Lambert.
    [[nodiscard]] V3f left_after(float distance) const;
};

/// Null for a material that lets nothing through.
[[nodiscard]] std::shared_ptr<const GlassConstants> glass_constants(const StandardMaterial& m);

/// The boundary at one point, seen from one direction. Directions are unit, in the surface's own
/// axes, z being the normal on the viewer's side. Smooth: Fresnel's exact reflectance, total
/// reflection included. Rough: Walter et al. 2007, "Microfacet models for refraction through rough
/// surfaces", section 4 and 5, scaled so that what single scattering between facets loses is given
/// back (as Turquin 2019 does for metals).
///
/// Values are in terms of basic radiance, radiance over the squared index of where it travels,
/// which refraction keeps: no factor n^2 at the surface, and none for lights, all of which stand
/// outside.
class GlassLobe {
  public:
    /// `wo`: to the viewer, wo.z > 0.
    GlassLobe(const GlassConstants& glass, bool is_inside, const V3f& wo);

    struct Value {
        float value = 0;  // times the cosine of `wi`, 1/sr
        float pdf = 0;    // 1/sr
    };
    /// For light from `wi`, on either side; both 0 if the surface is smooth.
    [[nodiscard]] Value evaluate(const V3f& wi) const;

    /// Of a smooth surface: the share that it reflects ...
    [[nodiscard]] float reflectance() const { return reflectance_; }
    /// ... and where light comes from that passes through; z < 0. Not at total reflection.
    [[nodiscard]] V3f refracted() const;

    /// Of a rough surface: a direction with the density that `evaluate` gives; z > 0: reflected. A
    /// direction on the wrong side, to be refused, is (0, 0, 0).
    [[nodiscard]] V3f sample(const V2f& u) const;

  private:
    const GlassConstants& glass_;
    V3f wo_;
    float index_;        // of the far side over the viewer's
    float reflectance_;  // smooth: the share; rough: the probability of sampling a reflection
    float scale_ = 1;    // gives back what single scattering loses
};

}  // namespace carom::render
