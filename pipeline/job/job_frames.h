// The frames, the folders, the store and the renderer that a job's options select.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/job/damage_report.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/scene_renderer.h"
#include "pipeline/store/frame_store.h"

namespace carom::pipeline {

/// The frames of the job: those of its range, of these the ones of its chunk. Throws Error if there
/// are none.
[[nodiscard]] std::vector<std::int64_t> job_frames(const Shot& shot, const FilmJobOptions& options);

/// The folders of the cache and of its frames.
[[nodiscard]] std::string cache_folder_of(const FilmJobOptions& options);
[[nodiscard]] std::string frames_folder(const FilmJobOptions& options);

/// The store of the job's frames, of which damaged ones are reported, or not; only to be read if
/// the job stores nothing. Throws Error.
[[nodiscard]] FrameStore open_store(const FilmJobOptions& options, DamageReport& damages);
[[nodiscard]] FrameStore open_store(const FilmJobOptions& options);

/// The keys of all files of the cache that a job needs: of its pictures and its bake.
[[nodiscard]] std::vector<Hash128> keys_of(const FilmPlan& plan, const sim::Bake& bake);

/// What renders the job's pictures. It throws Error if the job needs another machine.
[[nodiscard]] RenderFunction renderer_of(const Shot& shot, const FilmJobOptions& options);

}  // namespace carom::pipeline
