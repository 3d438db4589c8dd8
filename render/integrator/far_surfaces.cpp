#include "render/integrator/far_surfaces.h"

#include <algorithm>

#include "render/integrator/wave/scalar_kernels.h"
#include "render/light/far_light.h"

namespace carom::render {
namespace {

/// What smooth dielectrics of index 1.5 reflect of light from all around.
constexpr float kGlossOfAll = 0.092F;
/// Smoother coats show a picture.
constexpr float kSmooth = 0.12F;  // roughness
/// How much of the light comes from surfaces rather than straight from lamps, roughly: what gloss
/// shows besides highlights.
constexpr float kNotFromLamps = 0.3F;
/// Metals are followed.
constexpr float kMostMetal = 0.5F;
/// The length of rays that do not meet the near box, m: nothing occludes them.
constexpr float kNoWay = 1e-6F;

struct Range {
    float least, most;
};

/// The values of a number. `constant`: in materials that do not vary.
Range range_of(const Material& material, TexturedNumber which, float constant) {
    const NumberPick& pick = material.textures().numbers().numbers[which];
    if (!material.varies()) {
        return {constant, constant};
    }
    const float other = pick.texture >= 0 ? pick.at_one : pick.at_zero;
    return {std::min(pick.at_zero, other), std::max(pick.at_zero, other)};
}

float most_coat(const Material& material) {
    return range_of(material, kCoatWeight, material.numbers().coat_weight).most;
}

bool is_known(const Material& material) {
    return !material.is_transmissive() && !material.is_phong() &&
           range_of(material, kMetal, material.numbers().metal).most <= kMostMetal;
}

bool is_smoothly_coated(const Material& material) {
    const float roughness = std::sqrt(material.numbers().coat_alpha);
    return most_coat(material) > 0 && range_of(material, kCoatRoughness, roughness).least < kSmooth;
}

scalar::BsdfOf<scalar::One> bsdf_of(const WaveScene& scene, const SurfaceQueue& vertices,
                                    int vertex, const V3f& wo) {
    scalar::BsdfOf<scalar::One> bsdf{};
    scalar::set_layers<scalar::One>(scene.materials, vertices, vertex, vertices.material.at[vertex],
                                    bsdf.layers);
    scalar::complete<scalar::One>(bsdf, vertices.base.get(vertex),
                                  vertices.geometric_normal.get(vertex),
                                  vertices.normal.get(vertex), wo, false);
    return bsdf;
}

float gloss_of(const Material& material) {
    const float specular = range_of(material, kSpecular, material.numbers().specular).most;
    return kGlossOfAll * (1 - (1 - most_coat(material)) * (1 - specular));
}

}  // namespace

std::vector<std::int32_t> far_numbers(const TransportScene& scene) {
    std::vector<std::int32_t> numbers;
    std::int32_t number = 0;
    for (std::uint32_t object = 0; object < scene.first_light_object; ++object) {
        const bool is_static = !scene.frame.moves(object);
        const bool may_be_far =
            is_static && is_known(scene.materials[scene.frame.material(object)]);
        numbers.push_back(may_be_far ? number : -1);
        number += is_static ? 1 : 0;
    }
    return numbers;
}

FarSurfaces::FarSurfaces(const TransportScene& scene) : light_(scene.far) {
    if (light_ == nullptr) {
        return;
    }
    numbers_ = far_numbers(scene);
    for (std::uint32_t object = 0; object < scene.first_light_object; ++object) {
        const Material& material = scene.materials[scene.frame.material(object)];
        gloss_.push_back(gloss_of(material));
        has_smooth_coat_.push_back(is_smoothly_coated(material));
    }
}

bool FarSurfaces::is_far(const V3f& origin, const V3f& direction, const Hit& hit,
                         float part) const {
    return hit.object < numbers_.size() && numbers_[hit.object] >= 0 &&
           light_->grid().counts_as_far(origin + direction * hit.t, part);
}

V3f FarSurfaces::irradiance(const SurfaceQueue& vertices, int vertex) const {
    const auto object = static_cast<std::size_t>(vertices.object.at[vertex]);
    return light_->irradiance(static_cast<std::uint32_t>(numbers_[object]),
                              vertices.position.get(vertex), vertices.geometric_normal.get(vertex));
}

V3f FarSurfaces::diffuse(const WaveScene& scene, const SurfaceQueue& vertices, int vertex,
                         const V3f& wo) const {
    return bsdf_of(scene, vertices, vertex, wo).lobes.diffuse * irradiance(vertices, vertex) *
           kInversePi;
}

V3f FarSurfaces::seen(const WaveScene& scene, const SurfaceQueue& vertices, int vertex,
                      const V3f& wo) const {
    const scalar::BsdfOf<scalar::One> bsdf = bsdf_of(scene, vertices, vertex, wo);
    const V3f gloss =
        V3f(bsdf.lobes.coat) +
        bsdf.lobes.specular * scalar::facet_reflectance<scalar::One>(
                                  bsdf.layers, bsdf.lobes.metal_scale, bsdf.base, bsdf.wo.z);
    return (bsdf.lobes.diffuse + kNotFromLamps * gloss) * irradiance(vertices, vertex) * kInversePi;
}

V3f FarSurfaces::whole(const SurfaceQueue& vertices, int vertex) const {
    const float gloss = gloss_[static_cast<std::size_t>(vertices.object.at[vertex])];
    const V3f albedo = vertices.base.get(vertex) * (1 - gloss) + V3f(gloss);
    return albedo * irradiance(vertices, vertex) * kInversePi;
}

void FarShadows::sort(const ShadowQueue& shadows) {
    const FarGrid& grid = scene_.far->grid();
    const bool has_origins = shadows.ray_origin.x.at != nullptr;
    to_surroundings_.clear();
    to_lamps_.clear();
    for (int k = 0; k < shadows.rays; ++k) {
        for (int vertex = shadows.first; vertex < shadows.last; ++vertex) {
            const int place = shadows.place(k, vertex);
            float& t = shadows.t_max.at[place];
            if (!(t > 0)) {
                continue;
            }
            const V3f origin =
                has_origins ? shadows.ray_origin.get(place) : shadows.origin.get(vertex);
            const float out = grid.way_out(origin, shadows.direction.get(place));
            if (t > kLeastFarDistance && t < kInfinity) {
                to_surroundings_.push_back({place, vertex});
                t = std::max(out, kNoWay);
            } else if (t > out) {
                to_lamps_.push_back({place, vertex});
            }
        }
    }
}

void FarShadows::trace(const ShadowQueue& shadows) {
    sort(shadows);
    trace_shadows(scene_.frame.near(), shadows);
    for (const Taken& ray : to_surroundings_) {
        float& t = shadows.t_max.at[ray.place];
        t = t > 0 ? kInfinity : 0;
    }
    std::erase_if(to_lamps_, [&](const Taken& ray) { return !(shadows.t_max.at[ray.place] > 0); });
    trace_to_lamps(shadows);
}

void FarShadows::trace_to_lamps(const ShadowQueue& shadows) {
    const bool has_origins = shadows.ray_origin.x.at != nullptr;
    for (std::vector<float>& numbers : rays_) {
        numbers.resize(std::max(numbers.size(), to_lamps_.size() + RayBatch::kBeyond));
    }
    for (std::size_t i = 0; i < to_lamps_.size(); ++i) {
        const auto [place, vertex] = to_lamps_[i];
        const V3f origin = has_origins ? shadows.ray_origin.get(place) : shadows.origin.get(vertex);
        const V3f direction = shadows.direction.get(place);
        for (int axis = 0; axis < 3; ++axis) {
            rays_[static_cast<std::size_t>(axis)][i] = origin[axis];
            rays_[static_cast<std::size_t>(axis) + 3][i] = direction[axis];
        }
        rays_[6][i] = shadows.time.at[vertex];
        rays_[7][i] = shadows.t_max.at[place];
    }
    scene_.frame.structure().test_occlusion({static_cast<int>(to_lamps_.size()),
                                             {rays_[0].data(), rays_[1].data(), rays_[2].data()},
                                             {rays_[3].data(), rays_[4].data(), rays_[5].data()},
                                             rays_[6].data(),
                                             RayKind::shadow},
                                            rays_[7].data());
    for (std::size_t i = 0; i < to_lamps_.size(); ++i) {
        shadows.t_max.at[to_lamps_[i].place] = rays_[7][i];
    }
}

}  // namespace carom::render
