// The Phong model of a material.
#pragma once

#include "render/geometry/ray.h"
#include "render/material/albedo_table.h"
#include "render/scene/material_description.h"

namespace carom::render {

/// A lobe around one direction: cos^n of the angle to it.
struct CosineLobe {
    CosineLobe() = default;
    explicit CosineLobe(double n)
        : exponent(static_cast<float>(n)), kept(AlbedoTable::of_cosine_lobe(n)) {}
    /// The lobe with the same mean square of the angle as the rays of the classic model: n = 2 /
    /// s^2 for the standard deviation s in rad.
    static CosineLobe of_spread(double spread);

    float exponent = -1;  // n; -1: a single direction
    AlbedoTable kept;     // fraction on the right side of the surface, by the cosine of the axis
};

/// The part of a phong surface that does not vary: everything except the texture's colour, `base`.
struct PhongModel {
    V3f ambient{0, 0, 0};
    bool has_ambient = false;    // an ambient colour of its own; otherwise the diffuse one
    float diffuse_fraction = 1;  // diffuse colour over `base`
    V3f specular{0, 0, 0};
    float shininess = 1;
    V3f reflectance{0, 0, 0};
    float metal = 0;  // fraction of `base` that is also reflectance
    float reflectance_spread = 0;
    V3f transmittance{0, 0, 0};
    float transmittance_spread = 0;
    float index = 1;  // inside over outside
    // For path tracing: the lobes around the mirror direction (highlight, reflection) and around
    // the refracted direction.
    CosineLobe highlight_lobe, mirrored_lobe, through_lobe;

    [[nodiscard]] V3f diffuse_colour(const V3f& base) const { return base * diffuse_fraction; }
    [[nodiscard]] V3f ambient_colour(const V3f& base) const {
        return has_ambient ? ambient : diffuse_colour(base);
    }
    [[nodiscard]] V3f reflectance_colour(const V3f& base) const {
        return reflectance + base * metal;
    }
};

[[nodiscard]] PhongModel phong_model(const PhongMaterial& description);

/// The classic model that is closest to a layered surface. Coat and metal have their reflectance at
/// normal incidence at every angle; both are blurred by the GGX alpha of the rougher one. The
/// dielectric highlight becomes a Phong lobe of n = max(2 / alpha^2 - 2, 1) / 4 with the same
/// reflectance f: relative to irradiance/pi it is as high as the normalised lobe, f (n + 2) / 2
/// (Lafortune and Willems 1994). Glass has its reflectance at normal incidence, and its colour
/// applies at each surface. Sheen is left out.
[[nodiscard]] PhongModel phong_model(const StandardMaterial& description);

}  // namespace carom::render
