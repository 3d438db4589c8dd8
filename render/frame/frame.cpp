#include "render/frame/frame.h"

#include <chrono>
#include <utility>
#include <vector>

#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/acceleration/structure_cost.h"
#include "render/frame/adaptive_progress.h"
#include "render/frame/frame_sums_data.h"
#include "render/frame/frame_work.h"
#include "render/frame/tile_loop.h"

namespace carom::render {
namespace {

/// What a frame consists of.
struct Planes {
    Film film;
    AovPlanes aovs;
    DenoiserPlanes denoiser;

    void write(const TileRenderer& tiles, int tile, const TileSums& sums) {
        tiles.write(tile, sums, film);
        tiles.write(tile, sums, aovs);
        tiles.write(tile, sums, denoiser);
    }
};

/// Takes all samples of a tile before those of the next one. Unless `sums` has room for all, only
/// the sums of the tiles in work are in memory.
void render_evenly(const FrameWork& work, const WorkContext& context, FrameSums::Data& sums,
                   Planes& planes) {
    constexpr std::size_t kSide = TileRenderer::kTileSize;
    const TileRenderer& tiles = work.tiles();
    TileProgress progress(context.progress, tiles.tile_count());
    for_all_tiles(
        tiles.tile_count(), context, sums.statistics,
        [&](int tile) {
            std::vector<PixelSums> own(sums.pixels.empty() ? kSide * kSide : 0);
            const TileSums pixels =
                own.empty() ? tiles.sums_of(tile, sums.pixels) : TileSums{own.data(), kSide};
            const RenderStatistics count =
                tiles.add_samples(tile, pixels, {tiles.samples()}, context.stop);
            if (!context.stop.stop_requested()) {
                planes.write(tiles, tile, pixels);
            }
            return count;
        },
        [&](int) { progress.finish_tile(); });
}

void render_adaptively(const FrameWork& work, const WorkContext& context, FrameSums::Data& sums,
                       Planes& planes) {
    using Clock = std::chrono::steady_clock;
    const TileRenderer& tiles = work.tiles();
    const int count = tiles.tile_count();
    AdaptiveProgress progress(context.progress, work.settings(), count);
    sums.seconds.resize(static_cast<std::size_t>(count));
    for_all_tiles(
        count, context, sums.statistics,
        [&](int n) {
            const Clock::time_point begin = Clock::now();
            const int tile = progress.nth_tile(n);
            const RenderStatistics rays = tiles.add_samples(tile, tiles.sums_of(tile, sums.pixels),
                                                            {tiles.samples()}, context.stop);
            sums.seconds[static_cast<std::size_t>(tile)] +=
                std::chrono::duration<float>(Clock::now() - begin).count();
            return rays;
        },
        [&](int n) {
            const int tile = progress.nth_tile(n);
            progress.first_samples_done(
                tile, tiles.deviations(tile, sums.pixels),
                static_cast<double>(sums.seconds[static_cast<std::size_t>(tile)]));
        });
    if (sums.plan.empty()) {
        sums.plan = work.plan(sums.pixels, context);
    }
    progress.set_plan(tiles.further_samples(sums.plan));
    for_all_tiles(
        count, context, sums.statistics,
        [&](int tile) {
            const TileSums pixels = tiles.sums_of(tile, sums.pixels);
            const RenderStatistics rays =
                tiles.add_samples(tile, pixels, SampleLimit::planned(sums.plan), context.stop);
            if (!context.stop.stop_requested()) {
                planes.write(tiles, tile, pixels);
            }
            return rays;
        },
        [&](int tile) { progress.tile_done(tile); });
}

/// With room for the sums of a frame, unless it has them.
void make_room(FrameSums::Data& sums, std::size_t pixels) {
    if (sums.pixels.empty()) {
        sums.pixels.resize(pixels);
    }
    if (sums.pixels.size() != pixels) {
        throw Error("the sums are those of a frame of another size");
    }
}

}  // namespace

Film render_frame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                  const FrameInput& frame, const RenderSettings& settings,
                  const WorkContext& context, FrameSums* sums, StructureProbe* probe) {
    const FlushDenormals flush;  // while Embree builds
    const FrameWork work(scene, tracks, frame, settings,
                         probe != nullptr ? probe->options : StructureOptions{});
    Planes planes{work.empty_film(), work.make_aovs(settings.aovs), work.make_denoiser_planes()};
    FrameSums own;
    FrameSums::Data& data = sums != nullptr ? sums->data() : own.data();
    if (sums != nullptr || work.tiles().is_adaptive()) {
        make_room(data, work.pixel_count());
    }
    if (work.tiles().is_adaptive()) {
        render_adaptively(work, context, data, planes);
    } else {
        render_evenly(work, context, data, planes);
    }
    Film film = std::move(planes.film);
    film.statistics = data.statistics;
    work.add_reflections(film, planes.denoiser, planes.aovs, context);
    film.aovs = planes.aovs.take();
    film.notes = planes.aovs.take_notes();
    planes.denoiser.append_to(film);
    if (probe != nullptr) {
        probe->cost = work.scene().cost();
    }
    return film;
}

}  // namespace carom::render
