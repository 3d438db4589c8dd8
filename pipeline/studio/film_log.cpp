#include "pipeline/studio/film_log.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include <nlohmann/json.hpp>

#include "pipeline/studio/child_program.h"
#include "pipeline/video/image_sequence.h"

namespace carom::studio {
namespace {

constexpr std::size_t kMostWarnings = 20;

}  // namespace

FilmState first_state(const FilmRequest& request, const PreparedFilm& film) {
    FilmState state;
    state.state = "running";
    state.shot = request.shot;
    state.output = film.path;
    state.width = film.format.width;
    state.height = film.format.height;
    state.fps = film.format.fps.to_double();
    state.frames = std::ssize(film.frames);
    return state;
}

std::optional<FilmFrame> read_log(const std::string& line, bool stopping, FilmState& state) {
    const nlohmann::json log = nlohmann::json::parse(line, nullptr, false);
    if (!log.is_object()) {
        state.message = line;  // of a library, or of the system
        return std::nullopt;
    }
    const std::string event = log.value("event", "");
    const std::string level = log.value("level", "");
    if (level == "error") {
        state.message = log.value("message", "");
    } else if (level == "warning" && !stopping && state.warnings.size() < kMostWarnings) {
        state.warnings.push_back(log.value("message", ""));
    } else if (event == "progress" || event == "frame") {
        state.stage = log.value("stage", "");
        state.fraction = log.value("fraction", 0.0);
        state.left = log.value("seconds_left", -1.0);
        // A frame of a fade between shots counts for both.
        state.finished = std::min(log.value("frames_done", state.finished), state.frames);
        state.reused = log.value("frames_found", state.reused);
    }
    if (event != "frame") {
        return std::nullopt;
    }
    return FilmFrame{log.value("frame", std::int64_t{0}),
                     log.value("found", 0) != 0,
                     log.value("seconds", 0.0),
                     {}};
}

void end_state(int result, bool stopping, const std::string& address, FilmState& state) {
    state.left = -1;
    if (result == 0) {
        state.state = "done";
        state.fraction = 1;
        state.finished = state.frames;  // of title cards the log says nothing
        if (!pipeline::is_image_sequence(state.output)) {
            state.address = address;
        }
    } else if (stopping || result == kInterrupted) {
        state.state = "stopped";
    } else {
        state.state = "failed";
        if (state.message.empty()) {
            state.message = result < 0
                                ? "the renderer was ended by signal " + std::to_string(-result)
                                : "the renderer ended with code " + std::to_string(result);
        }
    }
}

}  // namespace carom::studio
