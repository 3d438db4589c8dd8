// Renders the pixels of one frame, tile by tile.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <stop_token>
#include <vector>

#include "render/camera/thin_lens_camera.h"
#include "render/film/film.h"
#include "render/frame/aov_planes.h"
#include "render/frame/denoiser_planes.h"
#include "render/frame/feature_tracer.h"
#include "render/frame/frame.h"
#include "render/frame/pixel_sums.h"
#include "render/frame/sample_queue.h"
#include "render/frame/splat_moments.h"
#include "render/integrator/integrator.h"
#include "render/integrator/light_tracer.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// The sums of a tile's pixels, alone or among those of the whole picture. Borrowed.
struct TileSums {
    PixelSums* first = nullptr;  // of the pixel at the top left
    std::size_t row = 0;         // from a pixel to the one below it
};

/// How many samples each pixel gets: `most`, and not more than `plan` says if there is one.
struct SampleLimit {
    int most = 0;
    const std::vector<int>* plan = nullptr;  // row by row; borrowed

    /// As many as the plan says.
    [[nodiscard]] static SampleLimit planned(const std::vector<int>& plan) {
        return {std::numeric_limits<int>::max(), &plan};
    }
    [[nodiscard]] int at(std::size_t pixel) const {
        return plan != nullptr ? std::min(most, (*plan)[pixel]) : most;
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

    /// The sums of a tile in those of the whole picture, which are stored row by row.
    [[nodiscard]] TileSums sums_of(int tile, std::vector<PixelSums>& picture) const;

    /// Adds samples to each pixel of the tile until it has as many as `limit` says. Returns early
    /// once `stop` is requested; what is added by then is counted and stays valid.
    [[nodiscard]] RenderStatistics add_samples(int tile, const TileSums& sums,
                                               const SampleLimit& limit,
                                               const std::stop_token& stop) const;

    /// Writes the mean colours of the tile's pixels. Pixels without a sample are black.
    void write(int tile, const TileSums& sums, Film& film) const;
    /// Writes the tile's pixels of other channels, except pixels without a sample.
    void write(int tile, const TileSums& sums, AovPlanes& aovs) const;
    /// Writes what the denoiser needs of the tile's pixels. `features`: what camera rays of the
    /// frame's pixels saw; if there are none, they are traced.
    void write(int tile, const TileSums& sums, DenoiserPlanes& planes,
               const std::vector<TracedFeatures>& features = {}) const;
    /// Traces camera rays for the tile's pixels, of which `sums` are known. For the denoiser only.
    [[nodiscard]] std::vector<FeaturePixel> trace_features(int tile, const TileSums& sums) const;

    /// The errors of blocks of 4x4 of the tile's pixels without denoising: means of those of
    /// MeasuredError.
    [[nodiscard]] std::vector<float> errors(int tile, const TileSums& sums) const;
    /// By tile, the number of samples that its pixels lack for `plan`, as a multiple of the first
    /// ones of all pixels.
    [[nodiscard]] std::vector<double> lacking_samples(const std::vector<PixelSums>& sums,
                                                      const std::vector<int>& plan) const;

    /// The light that pixels do not sample themselves: `reflection_count` images of lights
    /// (light_tracer.h), each of which adds to any pixels. They may be computed concurrently but
    /// are added in their order.
    [[nodiscard]] std::size_t reflection_count() const;
    /// `half`: of which half of the samples, if these are kept apart.
    [[nodiscard]] std::vector<Splat> reflection(std::size_t index, double samples, int half,
                                                RenderStatistics& count) const;
    void add(const std::vector<Splat>& splats, Film& film) const;
    /// Adds an image; the picture gets `weight` times its light.
    void add(const std::vector<Splat>& splats, float weight, SplatMoments& moments) const;

  private:
    template <class Pixel>
    void for_each_pixel_of(const Splat& splat, const Pixel& pixel) const;
    template <class Pixel>
    void for_each_pixel(int tile, const Pixel& pixel) const;
    [[nodiscard]] bool is_done(int tile, const TileSums& sums, const SampleLimit& limit) const;
    [[nodiscard]] PixelSums& at(int tile, const TileSums& sums, int x, int y) const {
        return sums.first[static_cast<std::size_t>(y - tile_top(tile)) * sums.row +
                          static_cast<std::size_t>(x - tile_left(tile))];
    }
    [[nodiscard]] std::vector<FeaturePixel> features_of(int tile, const TileSums& sums) const;
    void request(int x, int y, int samples, PixelSums& sums, SampleQueue& queue) const;
    [[nodiscard]] int tile_left(int tile) const { return tile % tiles_x_ * kTileSize; }
    [[nodiscard]] int tile_top(int tile) const { return tile / tiles_x_ * kTileSize; }
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
    bool counts_objects_;
    int tiles_x_;
    int tiles_y_;
};

}  // namespace carom::render
