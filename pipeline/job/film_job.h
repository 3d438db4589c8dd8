// The whole way: bake, render what the store lacks, encode.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "pipeline/job/frame_range.h"
#include "pipeline/shot/shot.h"
#include "pipeline/store/cache_care.h"
#include "render/acceleration/structure_factory.h"
#include "render/film/film.h"
#include "sim/timeline/bake_file.h"

namespace carom::pipeline {

struct FrameInputs;  // pipeline/store/frame_inputs.h

/// Told by a job as it goes; every call comes from one thread at a time.
struct JobObserver {
    /// "bake", "render", "encode", one after the other; shares never decrease. Encoding goes on
    /// beside rendering but is told of only when that is over.
    std::function<void(std::string_view stage, double fraction)> on_progress{};
    std::function<void(const std::string& message)> on_warning{};
    /// Once for every frame of the job, in the order in which they are finished.
    std::function<void(std::int64_t frame, bool from_store, double seconds, std::uint64_t rays)>
        on_frame{};
};

struct FilmJobOptions {
    std::string output;        // path of the video, or of an image sequence; empty: frames are
                               // rendered and stored, nothing else
    FrameRange frames;         // empty: all
    FrameChunk chunk;          // of these
    std::string cache_folder;  // of bakes and frames; empty: default_cache_folder()
    std::uint64_t cache_limit = kNoLimit;        // bytes; what was used longest ago goes first
    int threads = 0;                             // 0: as many as there are processors
    render::StructureFactory factory = nullptr;  // of what the renderer does not make itself
    /// Makes the pictures in place of render_frame; `threads` and `factory` do not matter then.
    std::function<render::Film(const FrameInputs&, const WorkContext&)> renderer{};
};

struct FilmJobResult {
    std::int64_t frames = 0;
    std::int64_t pictures = 0;  // that make up the frames: a cross-fade's frame mixes two, and
                                // frames that show the same share one
    std::int64_t rendered = 0;  // of the pictures; the others came from the store
    render::RenderStatistics counts{};  // the rays of those rendered
};

/// Gives the bake the motions that the shot's keys make, in place of such as it has by these names.
/// They are no part of the physics, nor of the bake that is kept.
void add_keyed_motions(sim::Bake& bake, const Shot& shot);

/// How a shot's bake was come by.
enum class BakeOrigin {
    kept,      // by an earlier command
    made,      // simulated now
    replaced,  // simulated now because the kept one is damaged, which a warning says
};

struct BakedShot {
    sim::Bake bake;
    BakeOrigin origin = BakeOrigin::made;
};

/// The shot's bake, simulated now, with its text, assets and keyed motions; nothing is kept. Any
/// number of threads may bake at the same time. Throws Error if the world has problems, Stopped.
[[nodiscard]] sim::Bake bake_shot(const Shot& shot, const WorkContext& context = {});

/// The kept bake if its physics hash fits, else a new one, which is kept; with this shot's text,
/// assets and keyed motions. A kept bake that is damaged is replaced. Throws Error, Stopped.
[[nodiscard]] BakedShot bake_or_reuse(const Shot& shot, const std::string& cache_folder,
                                      const JobObserver& observer, const std::stop_token& stop);

/// The kept bake with the shot's text, assets and keyed motions, if there is one.
[[nodiscard]] std::optional<sim::Bake> find_kept_bake(const Shot& shot,
                                                      const std::string& cache_folder,
                                                      const JobObserver& observer);

/// Renders the frames that the store lacks and encodes all to `options.output`. Any number of
/// threads and processes may make films from one store at the same time. Throws Error, Stopped.
/// What was finished before stays in the store; the video appears whole or not at all.
FilmJobResult make_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                        const JobObserver& observer, const std::stop_token& stop);

/// One frame as the film has it before its view transform: linear light, rounded to half precision
/// as the store holds it. From the store if it is there: then no rays are counted. Throws Error if
/// the film has no such frame, Stopped.
[[nodiscard]] render::Film make_frame(const Shot& shot, const sim::Bake& bake, std::int64_t frame,
                                      const FilmJobOptions& options, const JobObserver& observer,
                                      const std::stop_token& stop);

/// From a frame's number to its picture.
using FrameRenderer = std::function<render::Film(std::int64_t frame, const WorkContext& context)>;

/// Renders frames as make_frame does, but in memory: nothing is looked up, nothing kept or rounded.
/// The scene is prepared with the first frame and serves all others. `timeline` is that of a bake
/// with the shot's keyed motions; `threads` as in FilmJobOptions. The renderer refers to both
/// arguments, is for one thread at a time, and throws like make_frame.
[[nodiscard]] FrameRenderer make_frame_renderer(const Shot& shot, const sim::Timeline& timeline,
                                                int threads = 0);

}  // namespace carom::pipeline
