#include "render/frame/tile_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/frame/sample_plan.h"
#include "render/integrator/distributed_integrator.h"
#include "render/integrator/path_integrator.h"
#include "render/sampling/sampler.h"

namespace carom::render {
namespace {

/// Samples between two checks for a stop request. One of the distributed integrator is a tree of
/// rays; even of the largest some are taken together, for the vector code.
int samples_at_once(const RenderSettings& settings, const TransportScene& scene) {
    constexpr double kRays = 1e6;
    constexpr double kLeast = 16;
    if (settings.integrator != IntegratorKind::distributed) {
        return CameraBatch::kUsual;
    }
    const double rays = rays_per_camera_ray(settings.distributed, scene.lights.lights().size());
    return static_cast<int>(std::clamp<double>(kRays / rays, kLeast, CameraBatch::kUsual));
}

PathSettings path_settings(const RenderSettings& settings) {
    PathSettings path;
    path.max_bounces = settings.max_bounces;
    path.clamp = static_cast<float>(settings.clamp);
    return path;
}

std::unique_ptr<const Integrator> make_integrator(const RenderSettings& settings,
                                                  const TransportScene& scene,
                                                  const LightTracer* light_tracer) {
    if (settings.integrator == IntegratorKind::distributed) {
        return std::make_unique<DistributedIntegrator>(scene, settings.distributed);
    }
    return std::make_unique<PathIntegrator>(scene, path_settings(settings), light_tracer);
}

/// Whether the settings switch the effect of `count` off.
bool is_off(const RenderSettings& settings, int DistributedSettings::*count) {
    return settings.integrator == IntegratorKind::distributed && settings.distributed.*count == 1;
}

CameraState as_seen(CameraState state, const RenderSettings& settings) {
    if (is_off(settings, &DistributedSettings::lens_samples)) {
        state.lens_radius = 0;
    }
    return state;
}

/// The halves of a frame's samples are two nets with scrambling of their own.
std::uint64_t seed_of_half(std::uint64_t seed, int half) {
    return half == 0 ? seed : seed ^ 0x9e3779b97f4a7c15;  // a number without structure
}

/// For exact features. What adaptive sampling leaves is about what this many even samples would.
int expected_samples(const RenderSettings& settings) {
    constexpr int kAdaptive = 64;
    return is_adaptive(settings) ? kAdaptive : settings.samples;
}

static_assert(TileRenderer::kTileSize <= FeatureTracer::kMostSide);
static_assert(std::size_t{TileRenderer::kTileSize} * TileRenderer::kTileSize <=
              DenoiserValues::kMost);

int tiles_along(int pixels) {
    return (pixels + TileRenderer::kTileSize - 1) / TileRenderer::kTileSize;
}

}  // namespace

TileRenderer::TileRenderer(const RenderSettings& settings, const FrameInput& frame,
                           const TransportScene& scene)
    : settings_(settings),
      seed_(frame.seed),
      camera_(as_seen(frame.camera_open, settings), as_seen(frame.camera_close, settings),
              settings.width, settings.height, frame.switch_ratio, settings.filter,
              settings.filter_width),
      pixel_spread_(camera_.frame_at(0).pixel_size),
      light_tracer_(settings.integrator == IntegratorKind::path
                        ? std::make_unique<LightTracer>(scene, camera_)
                        : nullptr),
      integrator_(make_integrator(settings, scene, light_tracer_.get())),
      workspaces_(std::make_unique<WorkspacePool>(*integrator_)),
      samples_(settings.integrator == IntegratorKind::distributed
                   ? camera_samples(settings.distributed)
                   : settings.samples),
      samples_at_once_(samples_at_once(settings, scene)),
      fixings_{is_off(settings, &DistributedSettings::pixel_samples),
               is_off(settings, &DistributedSettings::blur_samples)},
      feature_tracer_(settings.for_denoiser
                          ? std::make_unique<FeatureTracer>(*integrator_, *workspaces_, camera_,
                                                            fixings_, pixel_spread_,
                                                            expected_samples(settings), frame.seed)
                          : nullptr),
      tiles_x_(tiles_along(settings.width)),
      tiles_y_(tiles_along(settings.height)) {}

TileArea TileRenderer::area(int tile) const {
    const int left = tile % tiles_x_ * kTileSize;
    const int top = tile / tiles_x_ * kTileSize;
    return {left, top, std::min(kTileSize, settings_.width - left),
            std::min(kTileSize, settings_.height - top)};
}

/// Calls pixel(x, y, i) for each pixel of the tile, the i-th.
template <class Pixel>
void TileRenderer::for_each_pixel(int tile, const Pixel& pixel) const {
    const TileArea own = area(tile);
    std::size_t i = 0;
    for (int y = own.top; y < own.top + own.height; ++y) {
        for (int x = own.left; x < own.left + own.width; ++x) {
            pixel(x, y, i++);
        }
    }
}

RenderStatistics TileRenderer::add_samples(int tile, TileSums& sums, const SampleLimit& limit,
                                           const std::stop_token& stop) const {
    RenderStatistics count;
    bool is_done = true;
    for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
        is_done = is_done && sums.samples(pixel) >= limit.at(sums, pixel);
    }
    if (is_done) {
        return count;
    }
    SampleQueue queue(
        {*integrator_, *workspaces_, camera_, fixings_, pixel_spread_, samples_at_once_}, stop,
        count);
    for_each_pixel(tile, [&](int x, int y, std::size_t pixel) {
        if (!stop.stop_requested()) {
            request(x, y, limit.at(sums, pixel), sums, pixel, queue);
        }
    });
    queue.flush();
    return count;
}

/// Requests the samples that a pixel lacks.
void TileRenderer::request(int x, int y, int samples, TileSums& sums, std::size_t pixel,
                           SampleQueue& queue) const {
    const SampleStream first(seed_, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                             0);
    const SampleStream second(seed_of_half(seed_, 1), static_cast<std::uint32_t>(x),
                              static_cast<std::uint32_t>(y), 0);
    const bool halves = has_halves(settings_);
    for (int sample = sums.samples(pixel); sample < samples; ++sample) {
        const auto number = static_cast<std::uint32_t>(sample);
        if (halves) {
            const SampleStream& half = sample % 2 == 0 ? first : second;
            queue.add(half.of_sample(number / 2), {x, y, sample}, sums, pixel);
        } else {
            queue.add(first.of_sample(number), {x, y, sample}, sums, pixel);
        }
    }
}

void TileRenderer::write(int tile, const TileSums& sums, Film& film) const {
    for_each_pixel(tile, [&](int x, int y, std::size_t pixel) {
        float* rgba = &film.rgba[4 * index(x, y)];
        const V3f mean = sums.mean(pixel);
        std::copy_n(&mean.x, 3, rgba);
        rgba[3] = sums.coverage(pixel);
    });
}

void TileRenderer::write(int tile, const TileSums& sums, AovPlanes& aovs) const {
    if (aovs.empty()) {
        return;
    }
    for_each_pixel(tile, [&](int x, int y, std::size_t pixel) {
        if (sums.samples(pixel) > 0) {
            aovs.write(x, y, sums.means(pixel));
        }
    });
}

TracedTile TileRenderer::trace_features(int tile, const TileSums& sums) const {
    std::vector<FeaturePixel> pixels;
    pixels.reserve(sums.size());
    for_each_pixel(tile, [&](int x, int y, std::size_t pixel) {
        pixels.push_back(
            {x, y, {sums.features_of_half(pixel, 0), sums.features_of_half(pixel, 1)}});
    });
    feature_tracer_->trace(pixels);
    return TracedTile(pixels);
}

void TileRenderer::write(int tile, const TileSums& sums, DenoiserPlanes& planes) const {
    if (planes.empty()) {
        return;
    }
    const TracedTile now = sums.traced.empty() ? trace_features(tile, sums) : TracedTile();
    std::vector<DenoiserPixel> pixels;
    for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
        pixels.push_back({&sums, sums.traced.empty() ? &now : &sums.traced, pixel});
    }
    const TileArea own = area(tile);
    planes.write(pixels, index(own.left, own.top), static_cast<std::size_t>(own.width));
}

std::vector<float> TileRenderer::errors(int tile, const TileSums& sums) const {
    constexpr int kBlock = 4;  // pixels a side
    constexpr int kBlocks = kTileSize / kBlock;
    std::vector<float> errors(std::size_t{kBlocks} * kBlocks);
    std::vector<int> pixels(errors.size());
    for_each_pixel(tile, [&](int x, int y, std::size_t pixel) {
        const int number = y % kTileSize / kBlock * kBlocks + x % kTileSize / kBlock;
        const auto block = static_cast<std::size_t>(number);
        const V3f a = sums.mean_of_half(pixel, 0);
        const V3f b = sums.mean_of_half(pixel, 1);
        errors[block] += error_of_halves(0.5F * (a + b), 0.5F * (a - b));
        pixels[block] += 1;
    });
    std::vector<float> result;
    for (std::size_t block = 0; block < errors.size(); ++block) {
        if (pixels[block] > 0) {
            result.push_back(errors[block] / static_cast<float>(pixels[block]));
        }
    }
    return result;
}

std::size_t TileRenderer::reflection_count() const {
    return light_tracer_ ? light_tracer_->pair_count() : 0;
}

std::vector<Splat> TileRenderer::reflection(std::size_t index, double samples, int half,
                                            RenderStatistics& count) const {
    return light_tracer_->splats(index, samples, seed_of_half(seed_, half), count);
}

/// Calls pixel(x, y, density of its filter there) for the pixels on which the splat lands.
template <class Pixel>
void TileRenderer::for_each_pixel_of(const Splat& splat, const Pixel& pixel) const {
    const PixelFilterSampler& filter = camera_.filter();
    const auto filter_radius = static_cast<float>(0.5 * filter.width());
    const auto first = [&](float place) {
        return std::max(0, static_cast<int>(std::ceil(place - 0.5f - filter_radius)));
    };
    const auto last = [&](float place, int size) {
        return std::min(size - 1, static_cast<int>(std::floor(place - 0.5f + filter_radius)));
    };
    const auto density = [&](float place, int at) {
        return filter.pdf_1d(static_cast<double>(place - 0.5f - static_cast<float>(at)));
    };
    for (int y = first(splat.position.y); y <= last(splat.position.y, settings_.height); ++y) {
        const double across = density(splat.position.y, y);
        for (int x = first(splat.position.x); x <= last(splat.position.x, settings_.width); ++x) {
            pixel(x, y, static_cast<float>(across * density(splat.position.x, x)));
        }
    }
}

void TileRenderer::add(const std::vector<Splat>& splats, SplatPicture& picture) const {
    for (const Splat& splat : splats) {
        for_each_pixel_of(
            splat, [&](int x, int y, float weight) { picture.add(x, y, weight * splat.flux); });
    }
}

void TileRenderer::add(const std::vector<Splat>& splats, float weight,
                       SplatMoments& moments) const {
    for (const Splat& splat : splats) {
        const float flux = luminance(splat.flux);
        for_each_pixel_of(splat, [&](int x, int y, float density) {
            moments.add(index(x, y), splat.quarter, density * flux);
        });
    }
    moments.finish_image(weight);
}

}  // namespace carom::render
