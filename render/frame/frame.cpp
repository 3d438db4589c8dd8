#include "render/frame/frame.h"

#include <chrono>
#include <mutex>
#include <vector>

#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/acceleration/structure_cost.h"
#include "render/frame/adaptive_progress.h"
#include "render/frame/check_settings.h"
#include "render/frame/prepared_scene.h"
#include "render/frame/sample_plan.h"
#include "render/frame/tile_renderer.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

/// Counts finished tiles and calls the caller's function, one call at a time.
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

/// Calls `render_tile` for each of 0 to `tiles` - 1 in parallel, and `tile_done` for each one that
/// was not stopped; adds the counts to `total` in this order.
template <class RenderTile, class TileDone>
void for_all_tiles(int tiles, const WorkContext& context, RenderStatistics& total,
                   const RenderTile& render_tile, const TileDone& tile_done) {
    std::vector<RenderStatistics> counts(static_cast<std::size_t>(tiles));
    parallel_for(counts.size(), [&](std::size_t tile) {
        if (context.stop.stop_requested()) {
            return;
        }
        const FlushDenormals flush;
        counts[tile] = render_tile(static_cast<int>(tile));
        if (!context.stop.stop_requested()) {
            tile_done(static_cast<int>(tile));
        }
    });
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    for (const RenderStatistics& count : counts) {
        total += count;
    }
}

void render_evenly(TileRenderer& renderer, const WorkContext& context, RenderStatistics& total) {
    TileProgress progress(context.progress, renderer.tile_count());
    for_all_tiles(
        renderer.tile_count(), context, total,
        [&](int tile) { return renderer.render(tile, context.stop); },
        [&](int) { progress.finish_tile(); });
}

void render_adaptively(TileRenderer& renderer, const RenderSettings& settings,
                       const WorkContext& context, RenderStatistics& total) {
    using Clock = std::chrono::steady_clock;
    const int tiles = renderer.tile_count();
    AdaptiveProgress progress(context.progress, settings, tiles);
    std::vector<PixelSums> pilot(static_cast<std::size_t>(settings.width) *
                                 static_cast<std::size_t>(settings.height));
    std::vector<double> seconds(static_cast<std::size_t>(tiles));
    for_all_tiles(
        tiles, context, total,
        [&](int n) {
            const Clock::time_point begin = Clock::now();
            const RenderStatistics count =
                renderer.begin(progress.nth_tile(n), pilot, context.stop);
            seconds[static_cast<std::size_t>(n)] =
                std::chrono::duration<double>(Clock::now() - begin).count();
            return count;
        },
        [&](int n) {
            const int tile = progress.nth_tile(n);
            progress.first_samples_done(tile, renderer.deviations(tile, pilot),
                                        seconds[static_cast<std::size_t>(n)]);
        });
    const std::vector<int> plan = plan_samples(pilot, settings);
    progress.set_plan(renderer.further_samples(plan));
    for_all_tiles(
        tiles, context, total,
        [&](int tile) { return renderer.finish(tile, pilot, plan, context.stop); },
        [&](int tile) { progress.tile_done(tile); });
}

/// Adds the images of lights in balls, with as many samples as the picture has on average.
void add_reflections(TileRenderer& renderer, const RenderSettings& settings,
                     const WorkContext& context, RenderStatistics& total) {
    const std::size_t number = renderer.reflection_count();
    const double samples = static_cast<double>(total.camera_rays) /
                           (static_cast<double>(settings.width) * settings.height);
    std::vector<std::vector<Splat>> splats(number);
    std::vector<RenderStatistics> counts(number);
    parallel_for(number, [&](std::size_t i) {
        if (!context.stop.stop_requested()) {
            const FlushDenormals flush;
            splats[i] = renderer.reflection(i, samples, counts[i]);
        }
    });
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    for (std::size_t i = 0; i < number; ++i) {
        renderer.add(splats[i]);
        total += counts[i];
    }
}

}  // namespace

Film render_frame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                  const FrameInput& frame, const RenderSettings& settings,
                  const WorkContext& context, StructureProbe* probe) {
    check(settings, frame, scene.data().branches);
    const FlushDenormals flush;  // while Embree builds
    const PreparedScene::Data& data = scene.data();
    const FrameScene frame_scene(data.geometry, tracks, frame.scene_open, frame.scene_close,
                                 probe != nullptr ? probe->options : StructureOptions{});
    const TransportScene transport{frame_scene, data.materials, data.lights, data.object_count};

    Film film;
    film.width = settings.width;
    film.height = settings.height;
    film.rgba.resize(4 * static_cast<std::size_t>(settings.width) *
                     static_cast<std::size_t>(settings.height));
    AovPlanes aovs(settings, frame, frame_scene, data.names);
    TileRenderer renderer(settings, frame, transport, film, aovs);
    if (renderer.is_adaptive()) {
        render_adaptively(renderer, settings, context, film.statistics);
    } else {
        render_evenly(renderer, context, film.statistics);
    }
    add_reflections(renderer, settings, context, film.statistics);
    film.aovs = aovs.take();
    film.notes = aovs.take_notes();
    if (probe != nullptr) {
        probe->cost = frame_scene.cost();
    }
    return film;
}

}  // namespace carom::render
