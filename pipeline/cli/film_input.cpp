#include "pipeline/cli/film_input.h"

#include <utility>

#include <fmt/core.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/cli/helper_program.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/video/video_format.h"

namespace carom::cli {

using pipeline::FilmJobOptions;
using pipeline::Shot;

namespace {

void require_structure(const std::string& name, const CommandContext& context) {
    if (name != render::kOwnStructure && context.structures == nullptr) {
        throw NeedsProgram("carom-lab");
    }
    try {
        (void)render::structure_maker(context.structures, name);
    } catch (const Error& error) {
        throw InputError(error.what());
    }
}

}  // namespace

ShotInput read_film_input(const InputOptions& input, FileReading reading, CommandContext& context) {
    CheckedInput checked = load_shot_input(input);
    if (checked.input) {
        require_structure(checked.input->shot.render.acceleration, context);
    }
    check_files(checked, reading, context);
    return require_shot_input(std::move(checked), input, context.console);
}

FilmJobOptions job_options(const CacheOptions& cache, const std::string& frames,
                           const std::string& chunk) {
    FilmJobOptions options;
    options.cache_folder = cache.folder;
    options.no_store = cache.no_store;
    try {
        options.cache_limit = pipeline::cache_size_limit(cache.size);
        if (!frames.empty()) {
            options.frames = pipeline::parse_frame_range(frames);
        }
        if (!chunk.empty()) {
            options.chunk = pipeline::parse_frame_chunk(chunk);
        }
    } catch (const Error& error) {
        throw InputError(error.what());
    }
    return options;
}

void require_store(const FilmJobOptions& options) {
    (void)pipeline::open_store(options);
}

void warn_of_no_store(const CacheOptions& cache, Console& console) {
    if (cache.no_store) {
        console.warning("nothing is stored (--no-store): if this is interrupted, it starts anew");
    }
}

std::int64_t film_frames(const Shot& shot) {
    const std::int64_t frames = pipeline::frame_count(shot.cameras, shot.timing);
    if (frames == 0) {
        throw InputError("'" + shot.name + "' has no frames: no camera films it");
    }
    return frames;
}

std::int64_t count_job_frames(const Shot& shot, const FilmJobOptions& options,
                              const std::string& text, Console& console) {
    const std::int64_t all = film_frames(shot);
    const std::vector<std::int64_t> frames = options.frames.frames(all);
    if (frames.empty()) {
        throw InputError(
            fmt::format("--frames {} selects no frame of the film, which has the frames 0 to {}",
                        text, all - 1));
    }
    if (options.frames.last() >= all) {
        console.warning(fmt::format("--frames {} exceeds the film, which has the frames 0 to {}",
                                    text, all - 1));
    }
    return std::ssize(options.chunk.part_of(frames));
}

std::string film_path(const std::string& given, const InputOptions& input, const Shot& shot) {
    return output_or_default(given, input.path, pipeline::default_extension(shot.output));
}

void check_film(const ShotInput& input, const std::string& path, Console& console) {
    const Shot& shot = input.shot;
    const pipeline::VideoFormat format{shot.render.width, shot.render.height, shot.timing.fps};
    const std::string problem = pipeline::check_video_format(format, shot.output, path);
    if (!problem.empty() && problem == pipeline::check_film_size(format, shot.output, path)) {
        report_problems(
            {input.source->problem_at({"render", "size"}, pipeline::Severity::error, problem)},
            console);
        throw InputError("cannot write '" + path + "'");
    }
    if (!problem.empty()) {
        throw InputError(problem);
    }
    check_output_folder(path);
}

}  // namespace carom::cli
