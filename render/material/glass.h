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

}  // namespace carom::render
