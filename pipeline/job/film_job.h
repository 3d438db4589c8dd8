// The whole way: bake, render what the store lacks, encode.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/job/frame_range.h"
#include "pipeline/shot/shot.h"
#include "render/film/film.h"
#include "sim/timeline/bake_file.h"

namespace carom::pipeline {

/// Told by a job as it goes; every call comes from one thread at a time.
struct JobObserver {
    std::function<void(std::string_view stage, double share)>
        on_progress{};  // "bake", "render", "encode"
    std::function<void(const std::string& message)> on_warning{};
    std::function<void(std::int64_t frame, bool from_store, double seconds, std::uint64_t rays)>
        on_frame{};
};

struct FilmJobOptions {
    std::string output;        // path of the video
    FrameRange frames;         // empty: all
    std::string cache_folder;  // of bakes and frames
    int threads = 0;           // 0: as many as there are processors
};

struct FilmJobResult {
    std::int64_t frames = 0;
    std::int64_t rendered = 0;  // the others came from the store
    bool baked = false;         // false: the kept bake fitted
};

/// The kept bake if its physics hash fits, else a new one, which is kept. Throws Error, Stopped.
[[nodiscard]] sim::Bake bake_or_reuse(const Shot& shot, const std::string& cache_folder,
                                      const JobObserver& observer, std::stop_token stop,
                                      bool* baked = nullptr);

/// Throws Error, Stopped. What was finished before stays in the store; the video appears whole or
/// not at all.
FilmJobResult make_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                        const JobObserver& observer, std::stop_token stop);

/// One frame, from the store if it is there.
[[nodiscard]] render::Film make_frame(const Shot& shot, const sim::Bake& bake, std::int64_t frame,
                                      const FilmJobOptions& options, const JobObserver& observer,
                                      std::stop_token stop);

}  // namespace carom::pipeline
