// Materials for the tests: every lobe alone and in layers.
#pragma once

#include <string>
#include <vector>

#include "render/material/material.h"
#include "render/sampling/scalar_kernels.h"
#include "tests/render/material/scalar_bsdf.h"

namespace carom::render::test_materials {

struct Named {
    std::string name;
    StandardMaterial material;
};

inline StandardMaterial diffuse(double albedo) {
    StandardMaterial m;
    m.base = Vec3(albedo, 0.5 * albedo, 0.25 * albedo);
    return m;
}

inline std::vector<Named> all() {
    std::vector<Named> list;
    list.push_back({"diffuse", diffuse(1.0)});

    StandardMaterial metal = diffuse(0.95);
    metal.metal = 1;
    metal.roughness = 0.4;
    list.push_back({"metal", metal});
    metal.roughness = 1;
    list.push_back({"rough metal", metal});

    StandardMaterial plastic = diffuse(0.9);
    plastic.specular = 1;
    plastic.roughness = 0.45;
    list.push_back({"highlight over diffuse", plastic});
    plastic.metal = 0.4;
    list.push_back({"half metal", plastic});

    StandardMaterial cloth = diffuse(0.8);
    cloth.sheen = 1;
    list.push_back({"sheen over diffuse", cloth});

    StandardMaterial coated = diffuse(0.9);
    coated.coat.weight = 1;
    list.push_back({"smooth coat", coated});
    coated.coat.roughness = 0.5;
    list.push_back({"rough coat", coated});
    coated.coat.weight = 0.6;
    coated.coat.ior = 2.2;
    list.push_back({"partial dense coat", coated});

    StandardMaterial everything = plastic;
    everything.sheen = 0.5;
    everything.coat = {1, 1.5, 0.6};
    list.push_back({"everything", everything});
    return list;
}

/// Transmissive materials, to be seen from both sides.
inline std::vector<Named> glasses() {
    std::vector<Named> list;
    StandardMaterial glass;
    glass.transmission = 1;
    glass.roughness = 0;
    list.push_back({"clear glass", glass});
    glass.roughness = 0.6;
    list.push_back({"frosted glass", glass});
    glass.roughness = 0.8;
    glass.ior = 2.2;
    list.push_back({"rough dense glass", glass});
    glass.roughness = 0.7;
    glass.transmission = 0.5;
    glass.ior = 1.6;
    glass.sheen = 0.5;
    glass.coat = {0.8, 1.5, 0.6};
    list.push_back({"half glass, half diffuse under a coat", glass});
    return list;
}

inline Material make(const StandardMaterial& description) {
    ImageCache images;
    AlbedoTables tables;
    return Material(description, images, tables);
}

/// A direction at `angle` (rad) from `normal`.
inline V3f tilted(const V3f& normal, float angle) {
    const auto basis = scalar::basis_around<scalar::One>(normal);
    const auto s = scalar::sin_cos<scalar::One>(angle);
    return basis.to_world(V3f(s.sine * 0.6f, s.sine * 0.8f, s.cosine));
}

}  // namespace carom::render::test_materials
