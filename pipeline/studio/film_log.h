// The progress of a film, read from the log of the program that makes it.
#pragma once

#include <optional>
#include <string>

#include "pipeline/studio/film_request.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

/// The state of a film that begins.
[[nodiscard]] FilmState first_state(const FilmRequest& request, const PreparedFilm& film);

/// Changes the state by a line of the log of `carom render`. Returns a frame that is finished by
/// it. `stopping`: the film is to end, so that warnings are of no interest.
std::optional<FilmFrame> read_log(const std::string& line, bool stopping, FilmState& state);

/// Changes the state to that after the program ended with `result` (ChildProgram::wait).
/// `stopping`: it was to end. `address`: where the film would be found.
void end_state(int result, bool stopping, const std::string& address, FilmState& state);

}  // namespace carom::studio
