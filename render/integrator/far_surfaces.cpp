#include "render/integrator/far_surfaces.h"

#include <algorithm>

#include "render/integrator/wave/scalar_kernels.h"
#include "render/light/far_light.h"

namespace carom::render {
namespace {

/// What smooth dielectrics of index 1.5 reflect of light from all around.
constexpr float kGlossOfAll = 0.092F;
/// Metals are followed.
constexpr float kMostMetal = 0.5F;
/// The rays' width at distance 1: what is seen of far textures is blurred.
constexpr float kSpread = 0.1F;

/// The largest value of a number. `constant`: in materials that do not vary.
float most_of(const Material& material, TexturedNumber which, float constant) {
    const NumberPick& pick = material.textures().numbers().numbers[which];
    if (!material.varies()) {
        return constant;
    }
    return pick.texture >= 0 ? std::max(pick.at_zero, pick.at_one) : pick.at_zero;
}

bool is_known(const Material& material) {
    return !material.is_transmissive() && !material.is_phong() &&
           most_of(material, kMetal, material.numbers().metal) <= kMostMetal;
}

float gloss_of(const Material& material) {
    const float coat = most_of(material, kCoatWeight, material.numbers().coat_weight);
    const float specular = most_of(material, kSpecular, material.numbers().specular);
    return kGlossOfAll * (1 - (1 - coat) * (1 - specular));
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
        gloss_.push_back(gloss_of(scene.materials[scene.frame.material(object)]));
    }
}

bool FarSurfaces::is_far(const V3f& origin, const V3f& direction, const Hit& hit) const {
    return hit.object < numbers_.size() && numbers_[hit.object] >= 0 &&
           light_->grid().is_far(origin + direction * hit.t);
}

V3f FarSurfaces::irradiance(const SurfaceQueue& vertices, int vertex) const {
    const auto object = static_cast<std::size_t>(vertices.object.at[vertex]);
    return light_->irradiance(static_cast<std::uint32_t>(numbers_[object]),
                              vertices.position.get(vertex), vertices.geometric_normal.get(vertex));
}

V3f FarSurfaces::diffuse(const WaveScene& scene, const SurfaceQueue& vertices, int vertex,
                         const V3f& wo) const {
    scalar::BsdfOf<scalar::One> bsdf{};
    scalar::set_layers<scalar::One>(scene.materials, vertices, vertex, vertices.material.at[vertex],
                                    bsdf.layers);
    scalar::complete<scalar::One>(bsdf, vertices.base.get(vertex),
                                  vertices.geometric_normal.get(vertex),
                                  vertices.normal.get(vertex), wo, false);
    return bsdf.lobes.diffuse * irradiance(vertices, vertex) * kInversePi;
}

V3f FarSurfaces::whole(const SurfaceQueue& vertices, int vertex) const {
    const float gloss = gloss_[static_cast<std::size_t>(vertices.object.at[vertex])];
    const V3f albedo = vertices.base.get(vertex) * (1 - gloss) + V3f(gloss);
    return albedo * irradiance(vertices, vertex) * kInversePi;
}

FarLookout::FarLookout(const TransportScene& scene, const WaveScene& wave_scene,
                       const WaveKernels& kernels, const FarSurfaces& surfaces, int most)
    : scene_(scene),
      surfaces_(surfaces),
      hits_(scene, wave_scene, kernels, most),
      numbers_(wave_scene.materials.varies ? std::size_t{kTexturedNumbers} : 0),
      most_(most) {
    memory_.reserve(most, rays_, found_, on_surfaces_);
    for (Floats& number : numbers_) {
        memory_.reserve(most, number);
    }
    found_.numbers = numbers_.empty() ? nullptr : numbers_.data();
    rays_.vertex = 1;
}

void FarLookout::take(const ShadowQueue& shadows) {
    taken_.clear();
    for (int k = 0; k < shadows.rays; ++k) {
        for (int vertex = shadows.first; vertex < shadows.last; ++vertex) {
            const int place = shadows.place(k, vertex);
            float& t = shadows.t_max.at[place];
            if (t > kLeastFarDistance && t < kInfinity) {
                taken_.push_back({place, vertex});
                t = 0;
            }
        }
    }
}

void FarLookout::put_back(const ShadowQueue& shadows) {
    for (std::size_t first = 0; first < taken_.size(); first += static_cast<std::size_t>(most_)) {
        trace(shadows, first);
    }
}

void FarLookout::trace(const ShadowQueue& shadows, std::size_t first) {
    const bool has_origins = shadows.ray_origin.x.at != nullptr;
    rays_.count =
        static_cast<int>(std::min(taken_.size() - first, static_cast<std::size_t>(most_)));
    const Taken* const taken = taken_.data() + first;
    for (int i = 0; i < rays_.count; ++i) {
        const auto [place, vertex] = taken[i];
        rays_.origin.set(i,
                         has_origins ? shadows.ray_origin.get(place) : shadows.origin.get(vertex));
        rays_.direction.set(i, shadows.direction.get(place));
        rays_.time.at[i] = shadows.time.at[vertex];
        rays_.throughput.set(i, V3f(1));
        rays_.cone_width.at[i] = 0;
        rays_.cone_spread.at[i] = kSpread;
    }
    const auto arrives = [&](int ray, const V3f& light) {
        const int place = taken[ray].place;
        shadows.radiance.set(place, shadows.radiance.get(place) * light);
        shadows.t_max.at[place] = 1;
    };
    const Hit* const hits = hits_.trace(rays_);
    on_surfaces_.count = 0;
    for (int i = 0; i < rays_.count; ++i) {
        if (hits[i].object == kNoObject) {
            arrives(i, scene_.lights.environment().radiance(rays_.direction.get(i)));
        } else if (surfaces_.is_far(rays_.origin.get(i), rays_.direction.get(i), hits[i])) {
            on_surfaces_.add(i);
        }
    }
    hits_.find(rays_, on_surfaces_, found_);
    for (int i = 0; i < found_.count; ++i) {
        arrives(found_.path.at[i], surfaces_.whole(found_, i));
    }
}

}  // namespace carom::render
