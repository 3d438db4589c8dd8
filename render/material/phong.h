// A material as the classic model sees it.
#pragma once

#include "render/geometry/ray.h"
#include "render/scene/material_description.h"

namespace carom::render {

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
