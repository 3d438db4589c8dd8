#include "pipeline/job/job_frames.h"

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/store/cache_folder.h"

namespace carom::pipeline {

std::vector<std::int64_t> job_frames(const Shot& shot, const FilmJobOptions& options) {
    const std::int64_t count = frame_count(shot.cameras, shot.timing);
    std::vector<std::int64_t> frames = options.chunk.part_of(options.frames.frames(count));
    if (frames.empty()) {
        throw Error(fmt::format("none of the film's {} frames is selected", count));
    }
    return frames;
}

std::string cache_folder_of(const FilmJobOptions& options) {
    return options.cache_folder.empty() ? default_cache_folder() : options.cache_folder;
}

std::string frames_folder(const FilmJobOptions& options) {
    return cache_folder_of(options) + "/frames";
}

}  // namespace carom::pipeline
