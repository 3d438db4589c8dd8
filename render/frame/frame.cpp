#include "render/frame/frame.h"

#include <mutex>
#include <vector>

#include <tbb/parallel_for.h>

#include "render/acceleration/flush_denormals.h"
#include "render/frame/check_settings.h"
#include "render/frame/prepared_scene.h"
#include "render/frame/tile_renderer.h"
#include "sim/timeline/error.h"

namespace carom::render {
namespace {

/// Counts finished tiles and tells the caller, one call at a time.
class TileProgress {
  public:
    TileProgress(const ProgressCallback& callback, int tiles)
        : callback_(callback), tiles_(tiles) {}

    void finish_tile() {
        if (!callback_) {
            return;
        }
        const std::lock_guard<std::mutex> lock(mutex_);
        finished_ += 1;
        callback_(static_cast<double>(finished_) / tiles_);
    }

  private:
    const ProgressCallback& callback_;
    int tiles_;
    int finished_ = 0;
    std::mutex mutex_;
};

void render_tiles(TileRenderer& renderer, std::vector<RenderStatistics>& counts,
                  const WorkContext& context) {
    TileProgress progress(context.progress, renderer.tile_count());
    tbb::parallel_for(
        0, renderer.tile_count(),
        [&](int tile) {
            if (context.stop.stop_requested()) {
                return;
            }
            const FlushDenormals flush;
            counts[static_cast<std::size_t>(tile)] = renderer.render(tile, context.stop);
            if (!context.stop.stop_requested()) {
                progress.finish_tile();
            }
        },
        tbb::simple_partitioner());
}

}  // namespace

Film render_frame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                  const FrameInput& frame, const RenderSettings& settings,
                  const WorkContext& context) {
    check(settings, frame);
    const FlushDenormals flush;  // while Embree builds
    const PreparedScene::Data& data = scene.data();
    check_integrator(settings, data.materials, data.lights.sampled_count());
    const FrameScene frame_scene(data.geometry, tracks, frame.scene_open, frame.scene_close);
    const TransportScene transport{frame_scene, data.materials, data.lights, data.object_count};

    Film film;
    film.width = settings.width;
    film.height = settings.height;
    film.rgba.resize(4 * static_cast<std::size_t>(settings.width) *
                     static_cast<std::size_t>(settings.height));
    AovPlanes aovs(settings, frame, frame_scene);
    TileRenderer renderer(settings, frame, transport, film, aovs);
    std::vector<RenderStatistics> counts(static_cast<std::size_t>(renderer.tile_count()));
    render_tiles(renderer, counts, context);
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    for (const RenderStatistics& count : counts) {
        film.statistics += count;
    }
    film.aovs = aovs.take();
    return film;
}

}  // namespace carom::render
