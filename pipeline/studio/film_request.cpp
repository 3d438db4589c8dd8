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
#include "pipeline/studio/output_path.h"
#include "pipeline/studio/paths.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/made_by_carom.h"
#include "pipeline/video/video_format.h"

namespace carom::studio {
namespace {

/// The files that the film would write.
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

std::vector<std::int64_t> frames_of(const FilmRequest& request, const pipeline::Shot& shot) {
    pipeline::FrameRange range;
    if (!request.start.frames.empty()) {
        range = pipeline::parse_frame_range(request.start.frames);
    }
    std::vector<std::int64_t> frames =
        range.frames(pipeline::frame_count(shot.cameras, shot.timing));
    if (frames.empty()) {
        throw Error("the film has none of these frames");
    }
    return frames;
}

std::string path_of(const FilmRequest& request, const ProgramOptions& options,
                    const pipeline::Shot& shot) {
    std::string path = output_path(request.start.output, request.shot, options.output, request.root,
                                   pipeline::default_extension(shot.output));
    const std::string problem = pipeline::check_video_format(
        {shot.render.width, shot.render.height, shot.timing.fps}, shot.output, path);
    if (!problem.empty()) {
        throw Error(problem);
    }
    return path;
}

}  // namespace

std::variant<PreparedFilm, Exists> prepare_film(const FilmRequest& request,
                                                const ProgramOptions& options,
                                                const std::string& stopped) {
    pipeline::LoadResult loaded =
        pipeline::load_shot(request.shot, {.overrides = overrides_of(request, options),
                                           .quality = quality_of(request, options),
                                           .root = request.root});
    if (!loaded.shot) {
        throw Error("the shot has errors, so that no film of it can be made: " +
                    loaded.problems.front().message);
    }
    pipeline::Shot& shot = *loaded.shot;
    std::vector<std::int64_t> frames = frames_of(request, shot);
    std::string path = path_of(request, options, shot);
    if (!request.start.overwrite) {
        if (const auto file = existing_file(files_of(path, frames), path == stopped)) {
            return Exists{StartFilm::kName, *file,
                          std::filesystem::path(*file).lexically_relative(request.root).string()};
        }
    }
    return PreparedFilm{std::move(shot), std::move(path), std::move(frames)};
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
