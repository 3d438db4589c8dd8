// Renders the pixels of one frame, tile by tile.
#pragma once

#include <cstddef>
#include <memory>
#include <stop_token>
#include <vector>

#include "render/camera/thin_lens_camera.h"
#include "render/film/film.h"
#include "render/frame/aov_planes.h"
#include "render/frame/frame.h"
#include "render/frame/pixel_sums.h"
#include "render/frame/sample_queue.h"
#include "render/integrator/integrator.h"
#include "render/integrator/light_tracer.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// Renders any tile into its own pixels of the film; tiles may be rendered concurrently. A pixel's
/// value depends only on its position; its samples are added in order.
class TileRenderer {
  public:
    static constexpr int kTileSize = 16;  // pixels

    TileRenderer(const RenderSettings& settings, const FrameInput& frame,
                 const TransportScene& scene, Film& film, AovPlanes& aovs);

    [[nodiscard]] int tile_count() const { return tiles_x_ * tiles_y_; }

    /// Returns early, leaving pixels unwritten, once `stop` is requested; so do the other
    /// functions.
    [[nodiscard]] RenderStatistics render(int tile, const std::stop_token& stop);

    [[nodiscard]] bool is_adaptive() const {
        return settings_.integrator == IntegratorKind::path && settings_.noise > 0;
    }
    /// For adaptive sampling: takes the first samples of each pixel into `pilot`.
    [[nodiscard]] RenderStatistics begin(int tile, std::vector<PixelSums>& pilot,
                                         const std::stop_token& stop);
    /// Standard deviations of the samples of some of the tile's pixels, means over blocks of 4x4.
    [[nodiscard]] std::vector<double> deviations(int tile,
                                                 const std::vector<PixelSums>& pilot) const;
    /// By tile, the number of samples that `plan` adds to the first ones, as a multiple of these.
    [[nodiscard]] std::vector<double> further_samples(const std::vector<int>& plan) const;
    /// Takes the remaining samples up to the number in `plan` and writes the film. Both arguments
    /// row by row.
    [[nodiscard]] RenderStatistics finish(int tile, const std::vector<PixelSums>& pilot,
                                          const std::vector<int>& plan,
                                          const std::stop_token& stop);

    /// The light that pixels do not sample themselves: `reflection_count` images of lights
    /// (light_tracer.h), each of which adds to any pixels. They may be computed concurrently but
    /// are added in their order.
    [[nodiscard]] std::size_t reflection_count() const;
    [[nodiscard]] std::vector<Splat> reflection(std::size_t index, double samples,
                                                RenderStatistics& count) const;
    void add(const std::vector<Splat>& splats);

  private:
    template <class Pixel>
    void for_each_pixel(int tile, const std::stop_token& stop, const Pixel& pixel) const;
    [[nodiscard]] SampleQueue make_queue(const std::stop_token& stop,
                                         RenderStatistics& count) const;
    void request(int x, int y, int from, int to, PixelSums& sums, SampleQueue& queue,
                 int group = -1) const;
    void write(int x, int y, const PixelSums& sums, int samples);
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
    int samples_;  // per pixel
    std::size_t samples_at_once_;
    CameraFixings fixings_;
    Film& film_;
    AovPlanes& aovs_;
    int tiles_x_;
    int tiles_y_;
};

}  // namespace carom::render
