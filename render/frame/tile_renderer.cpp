#include "render/frame/tile_renderer.h"

#include <algorithm>

#include "render/sampling/sampler.h"

namespace carom::render {
namespace {

constexpr int kSamplesBetweenStopChecks = 256;

PathSettings path_settings(const RenderSettings& settings) {
    PathSettings path;
    path.max_bounces = settings.max_bounces;
    path.clamp = static_cast<float>(settings.clamp);
    return path;
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
      camera_(frame.camera_open, frame.camera_close, settings.width, settings.height,
              frame.switch_ratio, settings.filter, settings.filter_width),
      pixel_spread_(camera_.frame_at(0).pixel_size),
      integrator_(scene, path_settings(settings)),
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

void TileRenderer::render_pixel(int x, int y, const std::stop_token& stop,
                                RenderStatistics& count) {
    PixelSums sums;
    for (int sample = 0; sample < settings_.samples; ++sample) {
        if (sample % kSamplesBetweenStopChecks == kSamplesBetweenStopChecks - 1 &&
            stop.stop_requested()) {
            return;
        }
        const SampleStream stream(seed_, static_cast<std::uint32_t>(x),
                                  static_cast<std::uint32_t>(y),
                                  static_cast<std::uint32_t>(sample));
        const Ray ray = camera_.ray(x, y, stream.camera_sample());
        sums.add(integrator_.sample(ray, pixel_spread_, stream, {x, y, sample}, count));
    }
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(settings_.width) +
        static_cast<std::size_t>(x);
    const double scale = 1.0 / settings_.samples;
    float* rgba = &film_.rgba[4 * pixel];
    for (int channel = 0; channel < 3; ++channel) {
        rgba[channel] = static_cast<float>(sums.radiance[channel] * scale);
    }
    rgba[3] = static_cast<float>(sums.coverage * scale);
    if (!aovs_.empty()) {
        aovs_.write(x, y, sums.means(settings_.samples));
    }
}

}  // namespace carom::render
