#include "render/frame/frame.h"

#include <mutex>
#include <vector>

#include "render/acceleration/flush_denormals.h"
#include "render/frame/check_settings.h"
#include "render/frame/prepared_scene.h"
#include "render/frame/sample_plan.h"
#include "render/frame/tile_renderer.h"
#include "render/threads/thread_arena.h"
#include "sim/timeline/error.h"

namespace carom::render {
namespace {

/// Counts finished tiles and tells the caller, one call at a time, how far from `start` to `end`
/// they have come.
class TileProgress {
  public:
    TileProgress(const ProgressCallback& callback, int tiles, double start, double end)
        : callback_(callback), tiles_(tiles), start_(start), end_(end) {}

    void finish_tile() {
        if (!callback_) {
            return;
        }
        const std::lock_guard<std::mutex> lock(mutex_);
        finished_ += 1;
        callback_(start_ + (end_ - start_) * finished_ / tiles_);
    }

  private:
    const ProgressCallback& callback_;
    int tiles_;
    double start_;
    double end_;
    int finished_ = 0;
    std::mutex mutex_;
};

struct Share {
    double start = 0;
    double end = 1;
};

/// `render_tile` for each tile, in parallel; its counts are added to `total`, in the tiles' order.
template <class RenderTile>
void for_all_tiles(int tiles, const Share& share, const WorkContext& context,
                   RenderStatistics& total, const RenderTile& render_tile) {
    TileProgress progress(context.progress, tiles, share.start, share.end);
    std::vector<RenderStatistics> counts(static_cast<std::size_t>(tiles));
    parallel_for(counts.size(), [&](std::size_t tile) {
        if (context.stop.stop_requested()) {
            return;
        }
        const FlushDenormals flush;
        counts[tile] = render_tile(static_cast<int>(tile));
        if (!context.stop.stop_requested()) {
            progress.finish_tile();
        }
    });
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    for (const RenderStatistics& count : counts) {
        total += count;
    }
}

void render_adaptively(TileRenderer& renderer, const RenderSettings& settings,
                       const WorkContext& context, RenderStatistics& total) {
    // How much the first samples are of all is known only after them.
    constexpr double kPilotShare = 0.3;
    const int tiles = renderer.tile_count();
    std::vector<PixelSums> pilot(static_cast<std::size_t>(settings.width) *
                                 static_cast<std::size_t>(settings.height));
    for_all_tiles(tiles, {0, kPilotShare}, context, total,
                  [&](int tile) { return renderer.begin(tile, pilot, context.stop); });
    const std::vector<int> plan = plan_samples(pilot, settings);
    for_all_tiles(tiles, {kPilotShare, 1}, context, total,
                  [&](int tile) { return renderer.finish(tile, pilot, plan, context.stop); });
}

/// The images of lights in balls, as well sampled as the picture is on average.
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
    check(settings, frame);
    const FlushDenormals flush;  // while Embree builds
    const PreparedScene::Data& data = scene.data();
    check_integrator(settings, data.materials, data.lights.sampled_count());
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
        for_all_tiles(renderer.tile_count(), {}, context, film.statistics,
                      [&](int tile) { return renderer.render(tile, context.stop); });
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
