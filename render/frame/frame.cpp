#include "render/frame/frame.h"

#include <chrono>
#include <utility>
#include <vector>

#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/adaptive_progress.h"
#include "render/frame/frame_sums_data.h"
#include "render/frame/frame_work.h"
#include "render/frame/tile_loop.h"

namespace carom::render {
namespace {

/// What a frame consists of.
struct Planes {
    explicit Planes(const FrameWork& work)
        : film(work.empty_film()),
          aovs(work.make_aovs(work.settings().aovs)),
          denoiser(work.make_denoiser_planes()) {}

    Film film;
    AovPlanes aovs;
    DenoiserPlanes denoiser;

    void write(const TileRenderer& tiles, int tile, const TileSums& sums,
               const std::vector<TracedFeatures>& features = {}) {
        tiles.write(tile, sums, film);
        tiles.write(tile, sums, aovs);
        tiles.write(tile, sums, denoiser, features);
    }
};

/// Takes all samples of a tile before those of the next one. Unless `sums` has room for all, only
/// the sums of the tiles in work are in memory.
Planes render_evenly(const FrameWork& work, const WorkContext& context, FrameSums::Data& sums) {
    Planes planes(work);
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
    return planes;
}

/// The first samples of an adaptive frame.
void take_first_samples(const FrameWork& work, const WorkContext& context, FrameSums::Data& sums,
                        AdaptiveProgress& progress) {
    using Clock = std::chrono::steady_clock;
    const TileRenderer& tiles = work.tiles();
    sums.seconds.resize(static_cast<std::size_t>(tiles.tile_count()));
    for_all_tiles(
        tiles.tile_count(), context, sums.statistics,
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
                tile, tiles.errors(tile, tiles.sums_of(tile, sums.pixels)),
                static_cast<double>(sums.seconds[static_cast<std::size_t>(tile)]));
        });
}

/// The samples that the plan of the sums still asks for.
void take_round(const FrameWork& work, const WorkContext& context, FrameSums::Data& sums,
                AdaptiveProgress& progress) {
    const TileRenderer& tiles = work.tiles();
    for_all_tiles(
        tiles.tile_count(), context, sums.statistics,
        [&](int tile) {
            return tiles.add_samples(tile, tiles.sums_of(tile, sums.pixels),
                                     SampleLimit::planned(sums.plan), context.stop);
        },
        [&](int tile) { progress.tile_done(tile); });
}

Planes render_adaptively(const FrameWork& work, const WorkContext& context, FrameSums::Data& sums) {
    const TileRenderer& tiles = work.tiles();
    AdaptiveProgress progress(context.progress, work.settings(), tiles.tile_count());
    take_first_samples(work, context, sums, progress);
    const bool goes_on = !sums.plan.empty();
    if (!goes_on) {
        sums.features = work.trace_features(sums.pixels, context);
        sums.plan.assign(work.pixel_count(), work.settings().samples);
    } else {
        const std::vector<double> lacking = tiles.lacking_samples(sums.pixels, sums.plan);
        progress.begin_round(lacking, lacking);
        take_round(work, context, sums, progress);
    }
    for (;;) {
        SampleRound round = work.next_round(sums.pixels, sums.features, sums.plan, context);
        if (!round.is_needed) {
            break;
        }
        sums.plan = std::move(round.plan);
        progress.begin_round(tiles.lacking_samples(sums.pixels, sums.plan),
                             tiles.lacking_samples(sums.pixels, round.expected));
        take_round(work, context, sums, progress);
    }
    Planes planes(work);
    RenderStatistics none;
    for_all_tiles(
        tiles.tile_count(), {{}, context.stop}, none,
        [&](int tile) {
            planes.write(tiles, tile, tiles.sums_of(tile, sums.pixels), sums.features);
            return RenderStatistics{};
        },
        [](int) {});
    progress.finish();
    return planes;
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
                  const WorkContext& context, FrameSums* sums) {
    const FlushDenormals flush;
    const FrameWork work(scene, tracks, frame, settings);
    FrameSums own;
    FrameSums::Data& data = sums != nullptr ? sums->data() : own.data();
    if (sums != nullptr || work.tiles().is_adaptive()) {
        make_room(data, work.pixel_count());
    }
    Planes planes = work.tiles().is_adaptive() ? render_adaptively(work, context, data)
                                               : render_evenly(work, context, data);
    Film film = std::move(planes.film);
    film.statistics = data.statistics;
    work.add_reflections(film, planes.denoiser, planes.aovs, context);
    film.aovs = planes.aovs.take();
    film.notes = planes.aovs.take_notes();
    planes.denoiser.append_to(film);
    return film;
}

}  // namespace carom::render
