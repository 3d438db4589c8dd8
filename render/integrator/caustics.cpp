#include "render/integrator/caustics.h"

#include <algorithm>

#include "render/integrator/scalar_kernels.h"

namespace carom::render {
namespace {

constexpr float kCoatReflectance = 0.04f;  // of index 1.5, straight on

/// The BSDF times the cosine, for light from a direction on the viewer's side.
V3f scattered(const scalar::BsdfOf<scalar::One>& bsdf, const V3f& direction) {
    const auto wi = bsdf.frame.from_world(direction);
    if (!scalar::side_of<scalar::One>(bsdf, direction, wi.z).is_above) {
        return {0, 0, 0};
    }
    const auto base = scalar::base_towards<scalar::One>(bsdf, wi, false);
    const auto coat = scalar::coat_towards<scalar::One>(bsdf, wi, false);
    return base.value + coat.value;
}

}  // namespace

Caustics::Caustics(const TransportScene& scene)
    : scene_(scene), light_count_(scene.lights.first_emissive()) {
    for (const SpecularSphere& sphere : specular_spheres(scene)) {
        add(sphere);
    }
    for (const SpecularSphere& sphere : clear_spheres(scene)) {
        add(sphere);
    }
}

void Caustics::add(const SpecularSphere& sphere) {
    const V3f middle = sphere.centres.center();
    const float travel = 0.5f * sphere.centres.size().length();
    float total = 0;
    std::vector<float> intensities;
    for (std::size_t light = 0; light < light_count_; ++light) {
        intensities.push_back(connection_importance(scene_, sphere, light));
        total += intensities.back();
    }
    if (total <= 0) {
        return;
    }
    index_.resize(std::max<std::size_t>(index_.size(), sphere.object + 1u), -1);
    index_[sphere.object] = static_cast<int>(spheres_.size());
    spheres_.push_back(sphere);
    intensity_.push_back(total);
    pairs_.insert(pairs_.end(), intensities.begin(), intensities.end());
    const float fraction =
        sphere.refracts ? 1.0f : luminance(sphere.material->mirror_reflectance(1));
    sphere_bounds_.push_back({middle, sphere.radius + travel, sphere.radius * sphere.radius,
                              std::max(1.0f, fraction / kCoatReflectance)});
}

inline float Caustics::weight(std::size_t sphere, const V3f& position, const V3f& normal) const {
    const SphereBounds& bounds = sphere_bounds_[sphere];
    return scalar::solid_angle_fraction<scalar::One>(
        bounds.centre - position, normal, bounds.bounding_radius, bounds.radius2, bounds.gain);
}

// `own`: the sphere that the vertex lies on, which reflects nothing onto it.
float Caustics::total_weight(const V3f& position, const V3f& normal, std::size_t own) const {
    float total = 0;
    for (std::size_t i = 0; i < spheres_.size(); ++i) {
        total += weight(i, position, normal);
    }
    return own < spheres_.size() ? total - weight(own, position, normal) : total;
}

// A vertex connects with a probability equal to the total weight of the spheres: most vertices are
// far from spheres and cost nothing.
V3f Caustics::estimate(const Path& path, const Receiver& vertex, const PathDimensions& dimensions,
                       RenderStatistics& count) const {
    const std::uint32_t object = vertex.object;
    const std::size_t own = object < index_.size() && index_[object] >= 0
                                ? static_cast<std::size_t>(index_[object])
                                : spheres_.size();
    const V3f normal = vertex.bsdf.geometric_normal;
    const float total = total_weight(vertex.position, normal, own);
    const float survival = std::min(1.0f, total);
    if (!(dimensions.caustic_roulette(path) < survival)) {
        return V3f(0, 0, 0);
    }
    const std::array<float, 4> u = dimensions.caustic(path);
    float rest = u[0] * total;
    std::size_t chosen = spheres_.size();
    float probability = 0;
    for (std::size_t i = 0; i < spheres_.size() && rest >= 0; ++i) {
        const float w = i == own ? 0 : weight(i, vertex.position, normal);
        if (w > 0) {
            chosen = i;  // the last one with a weight if rounding leaves a rest
            probability = w / total;
            rest -= w;
        }
    }
    if (chosen == spheres_.size()) {
        return V3f(0, 0, 0);
    }
    return sample_connection(chosen, path, vertex, u, count) / (survival * probability);
}

V3f Caustics::sample_connection(std::size_t index, const Path& path, const Receiver& vertex,
                                const std::array<float, 4>& u, RenderStatistics& count) const {
    const float* intensities = &pairs_[index * light_count_];
    std::size_t light = 0;
    float rest = u[1] * intensity_[index];
    while (light + 1 < light_count_ && (rest >= intensities[light] || intensities[light] <= 0)) {
        rest -= intensities[light];
        ++light;
    }
    if (intensities[light] <= 0) {
        return V3f(0, 0, 0);
    }
    const float light_probability = intensities[light] / intensity_[index];
    if (spheres_[index].refracts) {
        return sample_refraction(spheres_[index], light, path, vertex, V2f(u[2], u[3]), count) /
               light_probability;
    }
    const auto connection =
        connect(scene_, spheres_[index], light, vertex.position, path.ray.time, V2f(u[2], u[3]));
    if (!connection) {
        return V3f(0, 0, 0);
    }
    const V3f value = scattered(vertex.bsdf, connection->direction) * connection->radiance;
    if (!(luminance(value) > 0) ||
        is_occluded(scene_, *connection, vertex.origin, path.ray.time, count)) {
        return V3f(0, 0, 0);
    }
    return value * (connection->solid_angle / light_probability);
}

V3f Caustics::sample_refraction(const SpecularSphere& sphere, std::size_t light, const Path& path,
                                const Receiver& vertex, const V2f& u,
                                RenderStatistics& count) const {
    const RefractedConnections found =
        connect_through(scene_, sphere, light, vertex.position, path.ray.time, u);
    V3f sum(0, 0, 0);
    for (int i = 0; i < found.count; ++i) {
        const RefractedConnections::One& one = found.at[static_cast<std::size_t>(i)];
        const SpecularConnection& outside = one.outside;
        const V3f value = scattered(vertex.bsdf, outside.direction) * outside.radiance;
        if (luminance(value) > 0 &&
            !is_occluded(scene_, one, vertex.origin, path.ray.time, count)) {
            sum += value * outside.solid_angle;
        }
    }
    return sum;
}

}  // namespace carom::render
