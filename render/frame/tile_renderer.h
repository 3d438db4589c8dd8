// Renders the pixels of one frame, tile by tile.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stop_token>
#include <vector>

#include "render/camera/thin_lens_camera.h"
#include "render/film/film.h"
#include "render/frame/aov_planes.h"
#include "render/frame/denoiser_planes.h"
#include "render/frame/feature_tracer.h"
#include "render/frame/frame.h"
#include "render/frame/sample_queue.h"
#include "render/frame/splat_moments.h"
#include "render/frame/splat_picture.h"
#include "render/frame/tile_sums.h"
#include "render/integrator/integrator.h"
#include "render/integrator/light_tracer.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// The pixels of a tile.
struct TileArea {
    int left = 0;
    int top = 0;
    int width = 0;  // at the frame's edge less than a tile's
    int height = 0;

    [[nodiscard]] std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    /// The number of a pixel of the frame in the tile.
    [[nodiscard]] std::size_t pixel(int x, int y) const {
        return static_cast<std::size_t>(y - top) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x - left);
    }
};

/// How many samples each pixel gets: `most`, and not more than the tile's plan says.
struct SampleLimit {
    int most = 0;
    bool is_planned = false;

    [[nodiscard]] int at(const TileSums& sums, std::size_t pixel) const {
        return is_planned ? std::min(most, sums.planned[pixel]) : most;
    }
};

/// Renders any tile; different tiles may be rendered concurrently. A pixel's value depends only on
/// its position and its number of samples, which are added in order.
class TileRenderer {
  public:
    static constexpr int kTileSize = 16;  // pixels

    TileRenderer(const RenderSettings& settings, const FrameInput& frame,
                 const TransportScene& scene);

    [[nodiscard]] int tile_count() const { return tiles_x_ * tiles_y_; }
    /// Samples of every pixel; with adaptive sampling, the first ones of every pixel.
    [[nodiscard]] int samples() const { return samples_; }
    [[nodiscard]] bool is_adaptive() const { return render::is_adaptive(settings_); }

    [[nodiscard]] TileArea area(int tile) const;
    [[nodiscard]] int tile_of(int x, int y) const {
        return y / kTileSize * tiles_x_ + x / kTileSize;
    }

    /// Adds samples to each pixel of the tile until it has as many as `limit` says. Returns early
    /// once `stop` is requested; what is added by then is counted and stays valid.
    [[nodiscard]] RenderStatistics add_samples(int tile, TileSums& sums, const SampleLimit& limit,
                                               const std::stop_token& stop) const;

    /// Writes the mean colours of the tile's pixels. Pixels without a sample are black.
    void write(int tile, const TileSums& sums, Film& film) const;
    /// Writes the tile's pixels of other channels, except pixels without a sample.
    void write(int tile, const TileSums& sums, AovPlanes& aovs) const;
    /// Writes what the denoiser needs of the tile's pixels. If `sums` do not say what camera rays
    /// saw, these are traced.
    void write(int tile, const TileSums& sums, DenoiserPlanes& planes) const;
    /// Traces camera rays for the tile's pixels, of which `sums` are known. For the denoiser only.
    [[nodiscard]] TracedTile trace_features(int tile, const TileSums& sums) const;

    /// The errors of blocks of 4x4 of the tile's pixels without denoising: means of those of
    /// MeasuredError.
    [[nodiscard]] std::vector<float> errors(int tile, const TileSums& sums) const;

    /// The light that pixels do not sample themselves: `reflection_count` images of lights
    /// (light_tracer.h), each of which adds to any pixels. They may be computed concurrently but
    /// are added in their order.
    [[nodiscard]] std::size_t reflection_count() const;
    /// `half`: of which half of the samples, if these are kept apart.
    [[nodiscard]] std::vector<Splat> reflection(std::size_t index, double samples, int half,
                                                RenderStatistics& count) const;
    void add(const std::vector<Splat>& splats, SplatPicture& picture) const;
    /// Adds an image; the picture gets `weight` times its light.
    void add(const std::vector<Splat>& splats, float weight, SplatMoments& moments) const;

  private:
    template <class Pixel>
    void for_each_pixel_of(const Splat& splat, const Pixel& pixel) const;
    template <class Pixel>
    void for_each_pixel(int tile, const Pixel& pixel) const;
    void request(int x, int y, int samples, TileSums& sums, std::size_t pixel,
                 SampleQueue& queue) const;
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(settings_.width) +
               static_cast<std::size_t>(x);
    }

    RenderSettings settings_;
    std::uint64_t seed_;
    ThinLensCamera camera_;
    float pixel_spread_;
    std::unique_ptr<const LightTracer> light_tracer_;  // for the path integrator only
    std::unique_ptr<const Integrator> integrator_;
    std::unique_ptr<WorkspacePool> workspaces_;
    int samples_;  // per pixel
    int samples_at_once_;
    CameraFixings fixings_;
    std::unique_ptr<const FeatureTracer> feature_tracer_;  // for the denoiser only
    int tiles_x_;
    int tiles_y_;
};

}  // namespace carom::render
