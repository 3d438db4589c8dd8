// Which frames of a film the store already has, and the film made only from these.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

struct FilmStatus {
    std::vector<std::int64_t> frames;   // of the job, ascending
    std::vector<std::int64_t> stored;   // of these, intact in the store
    std::vector<std::int64_t> missing;  // all others
    std::int64_t pictures = 0;          // how many pictures the missing frames show
    std::vector<std::int64_t> damaged;  // missing frames that have a damaged file
};

enum class DamagedFrames { keep, remove };

/// Renders nothing, but reads every stored frame to verify it. Damaged ones are kept or removed, so
/// that whoever looks for a frame to render finds it missing. Throws Error, Stopped.
[[nodiscard]] FilmStatus film_status(const Shot& shot, const sim::Bake& bake,
                                     const FilmJobOptions& options, const std::stop_token& stop,
                                     DamagedFrames damaged = DamagedFrames::keep);

/// Throws an Error that names the missing frames, if there are any.
void check_that_all_are_stored(const FilmStatus& status);

/// Like make_film, but only with stored frames. Throws an Error that names the missing frames,
/// unless the film so far is wanted.
FilmJobResult mux_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                       const JobObserver& observer, const std::stop_token& stop);

/// The renderer of a job that only takes stored frames: throws an Error.
[[nodiscard]] render::Film refuse_to_render(const FrameInputs& frame, const WorkContext& context,
                                            render::FrameSums* sums);

/// The same for a film of which film_status() has just found every frame: nothing is verified
/// before the film is begun. Throws Error if a frame is missing or damaged all the same.
FilmJobResult mux_complete_film(const Shot& shot, const sim::Bake& bake,
                                const FilmJobOptions& options, const JobObserver& observer,
                                const std::stop_token& stop);

}  // namespace carom::pipeline
