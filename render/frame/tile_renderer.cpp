#include "render/frame/tile_renderer.h"

#include <algorithm>

#include "render/integrator/distributed_integrator.h"
#include "render/integrator/path_integrator.h"
#include "render/sampling/sampler.h"

namespace carom::render {
namespace {

// Samples between looks whether to stop; one of the distributed integrator is a tree of rays.
constexpr int kPathSamplesBetweenStops = 256;

PathSettings path_settings(const RenderSettings& settings) {
    PathSettings path;
    path.max_bounces = settings.max_bounces;
    path.clamp = static_cast<float>(settings.clamp);
    return path;
}

std::unique_ptr<const Integrator> make_integrator(const RenderSettings& settings,
                                                  const TransportScene& scene) {
    if (settings.integrator == IntegratorKind::distributed) {
        return std::make_unique<DistributedIntegrator>(scene, settings.distributed);
    }
    return std::make_unique<PathIntegrator>(scene, path_settings(settings));
}

/// Of `count`, whether the settings switch the effect off.
bool is_off(const RenderSettings& settings, int DistributedSettings::*count) {
    return settings.integrator == IntegratorKind::distributed && settings.distributed.*count == 1;
}

CameraState as_seen(CameraState state, const RenderSettings& settings) {
    if (is_off(settings, &DistributedSettings::lens_samples)) {
        state.lens_radius = 0;
    }
    return state;
}

int tiles_along(int pixels) {
    return (pixels + TileRenderer::kTileSize - 1) / TileRenderer::kTileSize;
}

/// Sums of a pixel's samples, in double: thousands of samples lose nothing.
struct PixelSums {
    Vec3 radiance{0, 0, 0};
    Vec3 normal{0, 0, 0};
    Vec3 albedo{0, 0, 0};
    double coverage = 0;
    double luminance = 0;
    double luminance2 = 0;

    void add(const RadianceSample& sample) {
        radiance += Vec3(sample.radiance);
        normal += Vec3(sample.normal);
        albedo += Vec3(sample.albedo);
        coverage += static_cast<double>(sample.coverage);
        const double y = static_cast<double>(render::luminance(sample.radiance));
        luminance += y;
        luminance2 += y * y;
    }

    [[nodiscard]] PixelMeans means(int count) const {
        PixelMeans result;
        result.normal = V3f(normal / count);
        result.albedo = V3f(albedo / count);
        const double mean = luminance / count;
        if (count > 1) {
            result.variance =
                static_cast<float>(std::max(0.0, luminance2 / count - mean * mean) / (count - 1));
        }
        return result;
    }
};

}  // namespace

TileRenderer::TileRenderer(const RenderSettings& settings, const FrameInput& frame,
                           const TransportScene& scene, Film& film, AovPlanes& aovs)
    : settings_(settings),
      seed_(frame.seed),
      camera_(as_seen(frame.camera_open, settings), as_seen(frame.camera_close, settings),
              settings.width, settings.height, frame.switch_ratio, settings.filter,
              settings.filter_width),
      pixel_spread_(camera_.frame_at(0).pixel_size),
      integrator_(make_integrator(settings, scene)),
      samples_(settings.integrator == IntegratorKind::distributed
                   ? camera_samples(settings.distributed)
                   : settings.samples),
      samples_between_stops_(
          settings.integrator == IntegratorKind::distributed ? 1 : kPathSamplesBetweenStops),
      is_centred_(is_off(settings, &DistributedSettings::pixel_samples)),
      is_instantaneous_(is_off(settings, &DistributedSettings::blur_samples)),
      film_(film),
      aovs_(aovs),
      tiles_x_(tiles_along(settings.width)),
      tiles_y_(tiles_along(settings.height)) {}

RenderStatistics TileRenderer::render(int tile, const std::stop_token& stop) {
    RenderStatistics count;
    const int x0 = tile % tiles_x_ * kTileSize;
    const int y0 = tile / tiles_x_ * kTileSize;
    for (int y = y0; y < std::min(y0 + kTileSize, settings_.height); ++y) {
        for (int x = x0; x < std::min(x0 + kTileSize, settings_.width); ++x) {
            if (stop.stop_requested()) {
                return count;
            }
            render_pixel(x, y, stop, count);
        }
    }
    return count;
}

Ray TileRenderer::camera_ray(int x, int y, const SampleStream& stream) const {
    CameraSample sample = stream.camera_sample();
    if (is_centred_) {
        sample.pixel = V2f(0.5f, 0.5f);
    }
    if (is_instantaneous_) {
        sample.time = 0.5f;
    }
    return camera_.ray(x, y, sample);
}

void TileRenderer::render_pixel(int x, int y, const std::stop_token& stop,
                                RenderStatistics& count) {
    PixelSums sums;
    for (int sample = 0; sample < samples_; ++sample) {
        if (sample % samples_between_stops_ == samples_between_stops_ - 1 &&
            stop.stop_requested()) {
            return;
        }
        const SampleStream stream(seed_, static_cast<std::uint32_t>(x),
                                  static_cast<std::uint32_t>(y),
                                  static_cast<std::uint32_t>(sample));
        const Ray ray = camera_ray(x, y, stream);
        sums.add(integrator_->sample(ray, pixel_spread_, stream, {x, y, sample}, count));
    }
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(settings_.width) +
        static_cast<std::size_t>(x);
    const double scale = 1.0 / samples_;
    float* rgba = &film_.rgba[4 * pixel];
    for (int channel = 0; channel < 3; ++channel) {
        rgba[channel] = static_cast<float>(sums.radiance[channel] * scale);
    }
    rgba[3] = static_cast<float>(sums.coverage * scale);
    if (!aovs_.empty()) {
        aovs_.write(x, y, sums.means(samples_));
    }
}

}  // namespace carom::render
