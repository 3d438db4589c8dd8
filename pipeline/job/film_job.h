// Jobs: bake a shot, render the frames that the store does not have, encode the film.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "pipeline/job/frame_range.h"
#include "pipeline/shot/shot.h"
#include "pipeline/store/cache_maintenance.h"
#include "pipeline/store/claim_times.h"
#include "render/acceleration/structure_maker.h"
#include "render/film/film.h"
#include "render/frame/frame_sums.h"
#include "sim/timeline/bake_file.h"

namespace carom::pipeline {

struct FilmPlan;      // pipeline/job/film_plan.h
class FilmSink;       // pipeline/job/film_sink.h
class FilmSource;     // pipeline/job/film_plan.h
struct FrameInputs;   // pipeline/store/frame_inputs.h
class SoundSource;    // pipeline/video/sound_source.h
struct SoundContext;  // pipeline/job/film_sound.h

/// Functions that a job calls while it runs, from one thread at a time.
struct JobObserver {
    /// The stages are "bake", "render" and "encode", one after the other, and fractions never
    /// decrease. Encoding runs in parallel with rendering, but is reported only after it.
    std::function<void(std::string_view stage, double fraction)> on_progress{};
    std::function<void(const std::string& message)> on_warning{};
    /// Called once for every frame of the job, in the order in which they are finished.
    std::function<void(std::int64_t frame, bool from_store, double seconds, std::uint64_t rays)>
        on_frame{};
};

struct FilmJobOptions {
    std::string output;        // path of the video, or of an image sequence; empty: frames are
                               // only rendered and stored
    FrameRange frames;         // empty: all
    FrameChunk chunk;          // of these frames
    std::string cache_folder;  // of bakes and frames; empty: default_cache_folder()
    std::uint64_t cache_limit = kNoLimit;          // bytes; removes the least recently used first
    int threads = 0;                               // 0: one per processor
    render::NamedStructures structures = nullptr;  // that the renderer does not have
    /// Frames that are not stored show the nearest stored one before them (film_so_far.h); nothing
    /// is rendered.
    bool so_far = false;
    /// Evenly sampled pictures keep the sums of their samples in memory, too (32 bytes a pixel, 111
    /// for the denoiser), so that one that is stopped is resumed; adaptively sampled ones do
    /// anyway.
    bool keeps_sums = false;
    ClaimTimes claim_times{};  // of the frames that are being rendered
    /// The cache is only read, if it exists, and nothing is written to it: what is rendered goes to
    /// the output alone (unstored_film.h), and a job that was stopped starts anew.
    bool no_store = false;
    /// Makes the sound of the whole film, also if the job writes only some of its frames; empty:
    /// the shot's own (shot_sound.h). It gets the music of the output settings (film_sound.h).
    std::function<std::unique_ptr<SoundSource>(const SoundContext&)> sound{};
    /// Makes what receives the frames instead of the file `output`.
    std::function<std::unique_ptr<FilmSink>(const FilmSource&, const FilmPlan&)> sink{};
    /// Renders the pictures instead of render_frame; `threads` and `structures` are ignored then.
    std::function<render::Film(const FrameInputs&, const WorkContext&, render::FrameSums*)>
        renderer{};
};

struct FilmJobResult {
    std::int64_t frames = 0;
    std::int64_t pictures = 0;  // of which the frames consist: a frame of a cross-fade mixes two,
                                // and frames that show the same share one
    std::int64_t rendered = 0;  // of the pictures; the others came from the store
    render::RenderStatistics counts{};  // the rays of the rendered pictures
};

/// Adds the motions that the shot's keys define, and that of its cue stick, to the bake, where they
/// replace tracks of the same names. They are not part of the physics, nor of the bake in the
/// cache.
void add_keyed_motions(sim::Bake& bake, const Shot& shot);

/// How a shot's bake was obtained.
enum class BakeOrigin {
    cached,     // by an earlier command
    simulated,  // now
    replaced,   // simulated now because the cached one cannot be used, which a warning reports
    outdated,   // simulated now because another version of carom made the cached one
};

struct BakedShot {
    sim::Bake bake;
    BakeOrigin origin = BakeOrigin::simulated;
};

/// The shot's bake, simulated now, with its text, assets and keyed motions. Nothing is written to
/// the cache. Any number of threads may bake at the same time. Throws Error if the world has
/// problems, Stopped.
[[nodiscard]] sim::Bake bake_shot(const Shot& shot, const WorkContext& context = {});

/// The cached bake if its physics hash matches, otherwise a new one, which is saved in the cache;
/// with this shot's text, assets and keyed motions. A damaged bake is replaced. Throws Error,
/// Stopped.
[[nodiscard]] BakedShot bake_or_reuse(const Shot& shot, const std::string& cache_folder,
                                      const JobObserver& observer, const std::stop_token& stop);

/// Like bake_or_reuse, but nothing is written to the cache, and other processes that simulate the
/// same shot are not waited for. The folder need not exist.
[[nodiscard]] BakedShot bake_without_store(const Shot& shot, const std::string& cache_folder,
                                           const JobObserver& observer,
                                           const std::stop_token& stop);

/// The cached bake with the shot's text, assets and keyed motions, if the cache has one.
[[nodiscard]] std::optional<sim::Bake> find_cached_bake(const Shot& shot,
                                                        const std::string& cache_folder,
                                                        const JobObserver& observer);

/// Renders the frames that the store does not have and encodes all frames to `options.output`. Any
/// number of threads and processes may make films from one store at the same time. Throws Error,
/// Stopped. Frames that were finished by then stay in the store; the video is written completely or
/// not at all.
FilmJobResult make_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                        const JobObserver& observer, const std::stop_token& stop);

/// One frame of the film before its view transform: linear light, rounded to half precision as it
/// is stored. No rays are counted if the frame comes from the store. Throws Error if the film has
/// no such frame, Stopped.
[[nodiscard]] render::Film make_frame(const Shot& shot, const sim::Bake& bake, std::int64_t frame,
                                      const FilmJobOptions& options, const JobObserver& observer,
                                      const std::stop_token& stop);

/// Renders the frame with a given number.
using FrameRenderer = std::function<render::Film(std::int64_t frame, const WorkContext& context)>;

/// Renders frames like make_frame, but in memory: the store is neither read nor written, and
/// nothing is rounded. The scene is prepared with the first frame and reused for all others.
/// `timeline` is that of a bake with the shot's keyed motions; `threads` as in FilmJobOptions. The
/// renderer refers to both arguments, is for one thread at a time, and throws like make_frame.
[[nodiscard]] FrameRenderer make_frame_renderer(const Shot& shot, const sim::Timeline& timeline,
                                                int threads = 0);

}  // namespace carom::pipeline
