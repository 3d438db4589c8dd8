#include "pipeline/studio/film_request.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/frame_range.h"
#include "pipeline/sequence/load_sequence.h"
#include "pipeline/studio/output_path.h"
#include "pipeline/studio/paths.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/made_by_carom.h"

namespace carom::studio {
namespace {

/// The files that the film would write, without the sound beside pictures (which it may not have).
std::vector<std::string> files_of(const std::string& path,
                                  const std::vector<std::int64_t>& frames) {
    if (!pipeline::is_image_sequence(path)) {
        return {path};
    }
    std::vector<std::string> files;
    files.reserve(frames.size());
    for (const std::int64_t frame : frames) {
        files.push_back(pipeline::path_in_sequence(path, frame));
    }
    return files;
}

/// The first file that exists; if `may_be_own`, only one that carom did not make.
std::optional<std::string> existing_file(const std::vector<std::string>& files, bool may_be_own) {
    const auto found = std::ranges::find_if(files, [&](const std::string& file) {
        return is_there(file) && !(may_be_own && pipeline::is_made_by_carom(file));
    });
    return found == files.end() ? std::nullopt : std::optional(*found);
}

/// The values that replace those of the shot.
std::vector<std::string> overrides_of(const FilmRequest& request, const ProgramOptions& options) {
    std::vector<std::string> all = options.overrides;
    if (const std::vector<int>& size = request.start.size; !size.empty()) {
        all.push_back(fmt::format("render.size=[{}]", fmt::join(size, ", ")));
    }
    return all;
}

const std::string& quality_of(const FilmRequest& request, const ProgramOptions& options) {
    return request.start.quality.empty() ? options.quality : request.start.quality;
}

/// `count`: of the whole film.
std::vector<std::int64_t> frames_of(const FilmRequest& request, std::int64_t count) {
    pipeline::FrameRange range;
    if (!request.start.frames.empty()) {
        range = pipeline::parse_frame_range(request.start.frames);
    }
    std::vector<std::int64_t> frames = range.frames(count);
    if (frames.empty()) {
        throw Error("the film has none of these frames");
    }
    return frames;
}

std::string path_of(const FilmRequest& request, const ProgramOptions& options,
                    const pipeline::VideoFormat& format, const pipeline::OutputSettings& output) {
    std::string path = output_path(request.start.output, request.shot, options.output, request.root,
                                   pipeline::default_extension(output));
    const std::string problem = pipeline::check_video_format(format, output, path);
    if (!problem.empty()) {
        throw Error(problem);
    }
    return path;
}

pipeline::LoadOptions load_options(const FilmRequest& request, const ProgramOptions& options) {
    return {.overrides = overrides_of(request, options),
            .quality = quality_of(request, options),
            .root = request.root};
}

PreparedFilm prepare_shot(const FilmRequest& request, const ProgramOptions& options) {
    pipeline::LoadResult loaded = pipeline::load_shot(request.shot, load_options(request, options));
    if (!loaded.shot) {
        throw Error("the shot has errors, so that no film of it can be made: " +
                    loaded.problems.front().message);
    }
    pipeline::Shot& shot = *loaded.shot;
    PreparedFilm film;
    film.format = {shot.render.width, shot.render.height, shot.timing.fps};
    film.frames = frames_of(request, pipeline::frame_count(shot.cameras, shot.timing));
    film.path = path_of(request, options, film.format, shot.output);
    film.content = FilmedShot{std::move(shot), std::move(loaded.source)};
    return film;
}

PreparedFilm prepare_sequence(const FilmRequest& request, const ProgramOptions& options) {
    pipeline::SequenceResult loaded =
        pipeline::load_sequence(request.shot, load_options(request, options));
    if (!loaded.sequence) {
        throw Error("the film has errors, so that it cannot be made: " +
                    loaded.problems.front().message);
    }
    pipeline::Sequence& sequence = *loaded.sequence;
    PreparedFilm film;
    film.format = {sequence.width, sequence.height, sequence.fps};
    film.frames = frames_of(request, sequence.frames());
    film.path = path_of(request, options, film.format, sequence.output);
    if (pipeline::is_image_sequence(film.path)) {
        throw Error("a film of several shots is written as a video, not as pictures");
    }
    film.content = std::move(sequence);
    return film;
}

}  // namespace

std::variant<PreparedFilm, Exists> prepare_film(const FilmRequest& request,
                                                const ProgramOptions& options,
                                                const std::string& stopped) {
    PreparedFilm film = pipeline::is_sequence_file(request.shot)
                            ? prepare_sequence(request, options)
                            : prepare_shot(request, options);
    if (!request.start.overwrite) {
        const std::vector<std::string> files = files_of(film.path, film.frames);
        if (const auto file = existing_file(files, film.path == stopped)) {
            return Exists{StartFilm::kName, *file,
                          std::filesystem::path(*file).lexically_relative(request.root).string()};
        }
    }
    return film;
}

std::vector<std::string> film_words(const FilmRequest& request, const ProgramOptions& options,
                                    const std::string& path) {
    std::vector<std::string> all{"render", "--log", "json",   "--cache",   options.cache_folder,
                                 "-o",     path,    "--root", request.root};
    if (const std::string& preset = quality_of(request, options); !preset.empty()) {
        all.insert(all.end(), {"--quality", preset});
    }
    if (!request.start.frames.empty()) {
        all.insert(all.end(), {"--frames", request.start.frames});
    }
    for (const std::string& value : overrides_of(request, options)) {
        all.insert(all.end(), {"--set", value});
    }
    all.insert(all.end(), {"--", request.shot});
    return all;
}

}  // namespace carom::studio
