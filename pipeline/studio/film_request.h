// A request for a film: what has to be known before it is begun, and the words of the command line.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/config/shot_source.h"
#include "pipeline/sequence/sequence.h"
#include "pipeline/shot/shot.h"
#include "pipeline/studio/messages.h"
#include "pipeline/studio/program_options.h"
#include "pipeline/video/video_format.h"

namespace carom::studio {

/// What a page asked for, and the files that it showed.
struct FilmRequest {
    StartFilm start;
    std::string shot;  // the path of its file
    std::string root;  // the folder below which files are written
};

struct FilmedShot {
    pipeline::Shot shot;
    std::shared_ptr<const pipeline::ShotSource> source;
};

/// What was found out before the film is begun.
struct PreparedFilm {
    std::variant<FilmedShot, pipeline::Sequence> content;
    pipeline::VideoFormat format;
    std::string path;  // of the film, or of the frames of an image sequence
    std::vector<std::int64_t> frames;
};

/// What the film is made from, or the file that it would replace. `stopped`: the path of a film
/// that was stopped; what it left of carom's own files may be replaced. Reads the shot's files,
/// which takes a while. Throws Error if no film can be made of them.
[[nodiscard]] std::variant<PreparedFilm, Exists> prepare_film(const FilmRequest& request,
                                                              const ProgramOptions& options,
                                                              const std::string& stopped);

/// The words after "carom" that make the film as the file `path`.
[[nodiscard]] std::vector<std::string> film_words(const FilmRequest& request,
                                                  const ProgramOptions& options,
                                                  const std::string& path);

}  // namespace carom::studio
