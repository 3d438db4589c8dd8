#include "render/integrator/light_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::render {
namespace {

// Larger images are found well enough by the samples of each pixel.
constexpr float kLargestImage = 256.0f;  // pixels

constexpr int kProbes = 64;

// Splats per sample of a pixel: a number for every pixel that the image may touch, within bounds.
constexpr double kPerPixel = 4;
constexpr double kFewest = 64;
constexpr double kMost = 1024;

// The pixel row of random numbers that no pixel uses.
constexpr std::uint32_t kRow = 0xffffffffu;

struct Extent {
    V2f low{std::numeric_limits<float>::max()};
    V2f high{std::numeric_limits<float>::lowest()};

    void add(const V2f& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    [[nodiscard]] double area() const {
        return static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1);
    }
};

}  // namespace

LightTracer::LightTracer(const TransportScene& scene, const ThinLensCamera& camera)
    : scene_(scene), camera_(camera), light_count_(scene.lights.first_emissive()) {
    for (const SpecularSphere& sphere : specular_spheres(scene)) {
        for (std::size_t light = 0; light < light_count_; ++light) {
            if (connection_importance(scene, sphere, light) > 0) {
                add_if_small(sphere, light);
            }
        }
    }
}

// Estimates with a few probes how large the image is and over how many pixels it is blurred.
void LightTracer::add_if_small(const SpecularSphere& sphere, std::size_t light) {
    RenderStatistics ignored;
    Extent extent;
    float area = 0;
    int found = 0;
    for (int i = 0; i < kProbes; ++i) {
        const SampleStream stream(0, 0, kRow, static_cast<std::uint32_t>(i));
        if (const auto there = sample_splat(sphere, light, stream.camera_sample(), ignored)) {
            extent.add(there->position);
            area += there->area;
            found += 1;
        }
    }
    const bool is_point = scene_.lights.is_delta(light);
    if (is_point || (found > 0 && area < kLargestImage * static_cast<float>(found))) {
        const double pixels = found > 0 ? extent.area() : 0;
        pairs_.push_back({sphere, light, std::clamp(kPerPixel * pixels, kFewest, kMost)});
        covered_.resize(std::max(covered_.size(), (sphere.object + 1) * light_count_));
        covered_[sphere.object * light_count_ + light] = true;
    }
}

std::vector<Splat> LightTracer::splats(std::size_t index, double samples, std::uint64_t seed,
                                       RenderStatistics& count) const {
    const Pair& pair = pairs_[index];
    const auto in_quarter = static_cast<std::uint32_t>(std::ceil(0.25 * samples * pair.size));
    const std::uint32_t number = 4 * in_quarter;
    const float weight = 1.0f / static_cast<float>(number);
    std::vector<Splat> result;
    for (std::uint32_t i = 0; i < number; ++i) {
        const SampleStream stream(seed, static_cast<std::uint32_t>(index), kRow, i);
        if (const auto there =
                sample_splat(pair.sphere, pair.light, stream.camera_sample(), count)) {
            result.push_back(
                {there->position, there->flux * weight, static_cast<int>(i / in_quarter)});
        }
    }
    return result;
}

std::optional<LightTracer::SplatSample> LightTracer::sample_splat(const SpecularSphere& sphere,
                                                                  std::size_t light,
                                                                  const CameraSample& sample,
                                                                  RenderStatistics& count) const {
    // The numbers that place a camera ray in its pixel choose the light's point here.
    const ThinLensCamera::Aperture aperture = camera_.aperture(sample);
    const auto connection =
        connect(scene_, sphere, light, aperture.position, aperture.time, sample.pixel);
    if (!connection) {
        return std::nullopt;
    }
    const auto point = camera_.image_point(aperture, connection->direction);
    if (!point || is_occluded(scene_, *connection, aperture.position, aperture.time, count)) {
        return std::nullopt;
    }
    const float area = connection->solid_angle / point->pixel_solid_angle;
    return SplatSample{point->position, connection->radiance * area, area};
}

}  // namespace carom::render
