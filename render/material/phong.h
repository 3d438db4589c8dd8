// A material as the classic model sees it.
#pragma once

#include "render/geometry/ray.h"
#include "render/material/albedo_table.h"
#include "render/scene/material_description.h"

namespace carom::render {

/// The shape of light that is scattered around one direction: cos^n of the angle to it.
struct CosineLobe {
    CosineLobe() = default;
    explicit CosineLobe(double n)
        : exponent(static_cast<float>(n)), kept(AlbedoTable::of_cosine_lobe(n)) {}
    /// The lobe whose mean square of the angle is that of the classic model's rays, n = 2 / s^2 for
    /// the standard deviation s in rad.
    static CosineLobe of_spread(double spread);

    float exponent = -1;  // n; -1: the direction alone
    AlbedoTable kept;     // share on the right side of the surface, by the cosine of the direction
};

/// The part of a phong surface that does not vary: everything but the texture's colour, `base`.
struct PhongModel {
    V3f ambient{0, 0, 0};
    bool has_ambient = false;  // a colour of its own; else that of the diffuse term
    float diffuse_share = 1;   // diffuse colour over `base`
    V3f specular{0, 0, 0};
    float shininess = 1;
    V3f reflectance{0, 0, 0};
    float metal = 0;  // share of `base` that is reflectance too
    float reflectance_spread = 0;
    V3f transmittance{0, 0, 0};
    float transmittance_spread = 0;
    float index = 1;  // inside over outside
    // For path tracing of a phong surface: around the mirrored direction, the same, and the
    // refracted direction.
    CosineLobe highlight_lobe, mirrored_lobe, through_lobe;

    [[nodiscard]] V3f diffuse_colour(const V3f& base) const { return base * diffuse_share; }
    [[nodiscard]] V3f ambient_colour(const V3f& base) const {
        return has_ambient ? ambient : diffuse_colour(base);
    }
    [[nodiscard]] V3f reflectance_colour(const V3f& base) const {
        return reflectance + base * metal;
    }
};

[[nodiscard]] PhongModel phong_model(const PhongMaterial& description);

/// The nearest that the classic model has to a layered surface. Coat and metal reflect what they
/// reflect straight on, whatever the angle; both spread by the GGX alpha of the rougher one that is
/// there. The dielectric highlight becomes a Phong lobe of n = max(2 / alpha^2 - 2, 1) / 4 with the
/// same reflectance f: over the irradiance/pi that the lights give it is as high as the normalised
/// lobe, f (n + 2) / 2 (Lafortune and Willems 1994). Glass
/// reflects what it reflects straight on and takes on its colour at each surface. Sheen is left
/// out.
[[nodiscard]] PhongModel phong_model(const StandardMaterial& description);

}  // namespace carom::render
