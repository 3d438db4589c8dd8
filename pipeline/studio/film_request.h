// A request for a film: what has to be known before it is begun, and the words of the command line.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

struct FilmRunOptions {
    std::string program{};  // carom
    std::vector<std::string> overrides{};
    std::string quality{};       // of requests without one
    std::string output{};        // folder of films; empty: that of the shot
    std::string cache_folder{};  // empty: the usual one
};

/// What a page asked for, and the files that it showed.
struct FilmRequest {
    StartFilm start;
    std::string shot;  // the path of its file
    std::string root;  // the folder below which files are written
};

/// What was found out before the film is begun.
struct PreparedFilm {
    pipeline::Shot shot;
    std::string path;  // of the film, or of the frames of an image sequence
    std::vector<std::int64_t> frames;
};

/// What the film is made from, or the file that it would replace. `stopped`: the path of a film
/// that was stopped; what it left of carom's own files may be replaced. Reads the shot's files,
/// which takes a while. Throws Error if no film can be made of them.
[[nodiscard]] std::variant<PreparedFilm, Exists> prepare_film(const FilmRequest& request,
                                                              const FilmRunOptions& options,
                                                              const std::string& stopped);

/// The words after "carom" that make the film as the file `path`.
[[nodiscard]] std::vector<std::string> film_words(const FilmRequest& request,
                                                  const FilmRunOptions& options,
                                                  const std::string& path);

}  // namespace carom::studio
