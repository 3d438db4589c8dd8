#include "render/frame/frame.h"

#include <chrono>
#include <vector>

#include "render/acceleration/flush_denormals.h"
#include "render/acceleration/structure_cost.h"
#include "render/frame/adaptive_progress.h"
#include "render/frame/frame_work.h"
#include "render/frame/sample_plan.h"
#include "render/frame/tile_loop.h"

namespace carom::render {
namespace {

/// Takes all samples of a tile before those of the next one, so that only the sums of the tiles in
/// work are in memory.
void render_evenly(const FrameWork& work, const WorkContext& context, Film& film, AovPlanes& aovs) {
    constexpr std::size_t kSide = TileRenderer::kTileSize;
    const TileRenderer& tiles = work.tiles();
    TileProgress progress(context.progress, tiles.tile_count());
    for_all_tiles(
        tiles.tile_count(), context, film.statistics,
        [&](int tile) {
            std::vector<PixelSums> pixels(kSide * kSide);
            const TileSums sums{pixels.data(), kSide};
            const RenderStatistics count =
                tiles.add_samples(tile, sums, {tiles.samples()}, context.stop);
            if (!context.stop.stop_requested()) {
                tiles.write(tile, sums, film);
                tiles.write(tile, sums, aovs);
            }
            return count;
        },
        [&](int) { progress.finish_tile(); });
}

void render_adaptively(const FrameWork& work, const WorkContext& context, Film& film,
                       AovPlanes& aovs) {
    using Clock = std::chrono::steady_clock;
    const TileRenderer& tiles = work.tiles();
    const int count = tiles.tile_count();
    AdaptiveProgress progress(context.progress, work.settings(), count);
    std::vector<PixelSums> sums(work.pixel_count());
    std::vector<double> seconds(static_cast<std::size_t>(count));
    for_all_tiles(
        count, context, film.statistics,
        [&](int n) {
            const Clock::time_point begin = Clock::now();
            const int tile = progress.nth_tile(n);
            const RenderStatistics rays =
                tiles.add_samples(tile, tiles.sums_of(tile, sums), {tiles.samples()}, context.stop);
            seconds[static_cast<std::size_t>(n)] =
                std::chrono::duration<double>(Clock::now() - begin).count();
            return rays;
        },
        [&](int n) {
            const int tile = progress.nth_tile(n);
            progress.first_samples_done(tile, tiles.deviations(tile, sums),
                                        seconds[static_cast<std::size_t>(n)]);
        });
    const std::vector<int> plan = plan_samples(sums, work.settings());
    progress.set_plan(tiles.further_samples(plan));
    for_all_tiles(
        count, context, film.statistics,
        [&](int tile) {
            const TileSums pixels = tiles.sums_of(tile, sums);
            const RenderStatistics rays =
                tiles.add_samples(tile, pixels, SampleLimit::planned(plan), context.stop);
            if (!context.stop.stop_requested()) {
                tiles.write(tile, pixels, film);
                tiles.write(tile, pixels, aovs);
            }
            return rays;
        },
        [&](int tile) { progress.tile_done(tile); });
}

}  // namespace

Film render_frame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                  const FrameInput& frame, const RenderSettings& settings,
                  const WorkContext& context, StructureProbe* probe) {
    const FlushDenormals flush;  // while Embree builds
    const FrameWork work(scene, tracks, frame, settings,
                         probe != nullptr ? probe->options : StructureOptions{});
    Film film = work.empty_film();
    AovPlanes aovs = work.make_aovs(settings.aovs);
    if (work.tiles().is_adaptive()) {
        render_adaptively(work, context, film, aovs);
    } else {
        render_evenly(work, context, film, aovs);
    }
    work.add_reflections(film, context);
    film.aovs = aovs.take();
    film.notes = aovs.take_notes();
    if (probe != nullptr) {
        probe->cost = work.scene().cost();
    }
    return film;
}

}  // namespace carom::render
