#include "render/frame/progressive_frame.h"

#include <algorithm>
#include <utility>

#include "core/assert.h"
#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/frame_sums_data.h"
#include "render/frame/frame_work.h"
#include "render/frame/tile_loop.h"

namespace carom::render {
namespace {

/// A part of a progress callback's range.
WorkContext part_of(const WorkContext& context, double from, double to) {
    WorkContext part{{}, context.stop};
    if (context.progress) {
        part.progress = [&context, from, to](double fraction) {
            context.progress(from + fraction * (to - from));
        };
    }
    return part;
}

}  // namespace

struct ProgressiveFrame::Data {
    Data(const PreparedScene& scene, std::span<const sim::Track> tracks, const FrameInput& frame,
         const RenderSettings& settings)
        : work(scene, tracks, frame, settings) {
        sums.pixels.resize(work.pixel_count());
    }

    FrameWork work;
    FrameSums::Data sums;
    int samples = 0;  // that all pixels have, unless they have all of the current round
    bool is_planned = !work.tiles().is_adaptive();  // no further round is needed

    [[nodiscard]] const TileRenderer& tiles() const { return work.tiles(); }
    /// The most samples of a pixel after the current round.
    [[nodiscard]] int most_of_round() const {
        return sums.plan.empty() ? tiles().samples()
                                 : *std::max_element(sums.plan.begin(), sums.plan.end());
    }
    [[nodiscard]] int most_samples() const {
        const RenderSettings& settings = work.settings();
        return is_planned ? most_of_round() : std::max(settings.samples, settings.max_samples);
    }

    void plan_next_round(const WorkContext& context);
    void add_samples(int up_to, const WorkContext& context);
    void add_reflections(Film& film, const WorkContext& context) const;
    template <class Write>
    void write_tiles(const WorkContext& context, const Write& write);
};

void ProgressiveFrame::Data::add_samples(int up_to, const WorkContext& context) {
    const SampleLimit limit{up_to, sums.plan.empty() ? nullptr : &sums.plan};
    TileProgress progress(context.progress, tiles().tile_count());
    for_all_tiles(
        tiles().tile_count(), context, sums.statistics,
        [&](int tile) {
            return tiles().add_samples(tile, tiles().sums_of(tile, sums.pixels), limit,
                                       context.stop);
        },
        [&](int) { progress.finish_tile(); });
    samples = std::max(samples, up_to);
}

/// Once all pixels have the samples of the current round.
void ProgressiveFrame::Data::plan_next_round(const WorkContext& context) {
    if (sums.plan.empty()) {
        sums.features = work.trace_features(sums.pixels, context);
        sums.plan.assign(work.pixel_count(), work.settings().samples);
    }
    SampleRound round = work.next_round(sums.pixels, sums.features, sums.plan, context);
    is_planned = !round.is_needed;
    sums.plan = std::move(round.plan);
}

template <class Write>
void ProgressiveFrame::Data::write_tiles(const WorkContext& context, const Write& write) {
    RenderStatistics none;
    for_all_tiles(
        tiles().tile_count(), context, none,
        [&](int tile) {
            write(tile, tiles().sums_of(tile, sums.pixels));
            return RenderStatistics{};
        },
        [](int) {});
}

ProgressiveFrame::ProgressiveFrame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                                   const FrameInput& frame, const RenderSettings& settings) {
    const FlushDenormals flush;  // while Embree builds
    data_ = std::make_unique<Data>(scene, tracks, frame, settings);
}

ProgressiveFrame::~ProgressiveFrame() = default;
ProgressiveFrame::ProgressiveFrame(ProgressiveFrame&&) noexcept = default;
ProgressiveFrame& ProgressiveFrame::operator=(ProgressiveFrame&&) noexcept = default;

void ProgressiveFrame::refine(int up_to_samples, const WorkContext& context) {
    if (data_->is_planned && up_to_samples <= data_->samples) {
        return;
    }
    // A round of adaptive sampling fills half of the rest of the progress.
    for (double done = 0;;) {
        const int up_to = std::min(up_to_samples, data_->most_of_round());
        const bool is_last = data_->is_planned || up_to < data_->most_of_round();
        const double end = is_last ? 1 : 0.5 * (1 + done);
        data_->add_samples(up_to, part_of(context, done, end));
        if (is_last) {
            return;
        }
        data_->plan_next_round(context);
        if (data_->is_planned) {
            if (context.progress) {
                context.progress(1);
            }
            return;
        }
        done = end;
    }
}

int ProgressiveFrame::samples() const {
    return data_->samples;
}

int ProgressiveFrame::most_samples() const {
    return data_->most_samples();
}

bool ProgressiveFrame::finished() const {
    return data_->is_planned && data_->samples >= data_->most_samples();
}

const RenderStatistics& ProgressiveFrame::statistics() const {
    return data_->sums.statistics;
}

/// Without planes for the denoiser, even if the settings ask for them.
void ProgressiveFrame::Data::add_reflections(Film& film, const WorkContext& context) const {
    DenoiserPlanes planes = work.make_denoiser_planes();
    AovPlanes no_aovs = work.make_aovs({});
    work.add_reflections(film, planes, no_aovs, context);
}

Film ProgressiveFrame::picture(const WorkContext& context) const {
    Film film = data_->work.empty_film();
    data_->write_tiles(
        context, [&](int tile, const TileSums& sums) { data_->tiles().write(tile, sums, film); });
    film.statistics = data_->sums.statistics;
    data_->add_reflections(film, context);
    return film;
}

std::vector<Channel> ProgressiveFrame::channels(const std::string& aov,
                                                const WorkContext& context) const {
    if (!is_aov(aov)) {
        throw Error("there is no AOV '" + aov + "'");
    }
    AovPlanes planes = data_->work.make_aovs({aov});
    data_->write_tiles(
        context, [&](int tile, const TileSums& sums) { data_->tiles().write(tile, sums, planes); });
    const auto samples = static_cast<double>(data_->sums.statistics.camera_rays);
    data_->work.add_reflections(planes, samples / static_cast<double>(data_->work.pixel_count()),
                                context);
    return planes.take();
}

Film ProgressiveFrame::film(const WorkContext& context) const {
    Film film = data_->work.empty_film();
    AovPlanes planes = data_->work.make_aovs(data_->work.settings().aovs);
    DenoiserPlanes denoiser = data_->work.make_denoiser_planes();
    data_->write_tiles(context, [&](int tile, const TileSums& sums) {
        data_->tiles().write(tile, sums, film);
        data_->tiles().write(tile, sums, planes);
        data_->tiles().write(tile, sums, denoiser, data_->sums.features);
    });
    film.statistics = data_->sums.statistics;
    data_->work.add_reflections(film, denoiser, planes, context);
    film.aovs = planes.take();
    film.notes = planes.take_notes();
    denoiser.append_to(film);
    return film;
}

}  // namespace carom::render
