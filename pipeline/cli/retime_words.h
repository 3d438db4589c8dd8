// The options with which a film is filmed again: --speed, --from, --ramp ...
#pragma once

#include "pipeline/camera/retime.h"
#include "pipeline/cli/commands.h"
#include "pipeline/cli/shot_input.h"

namespace carom::cli {

/// The options but for `from` and `to`, which may be moments. Throws InputError.
[[nodiscard]] pipeline::RetimeOptions parse_retime(const RetimeWords& words);

/// Whether any of the words changes the film.
[[nodiscard]] bool changes_film(const RetimeWords& words);

/// Whether one of the words is a moment, for which the motion of the shot has to be known.
[[nodiscard]] bool names_moments(const RetimeWords& words);

/// The scene time of an option: a number, or a moment, for which the motion of the input has to be
/// known. Empty if it is not given. Throws InputError.
[[nodiscard]] std::optional<pipeline::Rational> scene_time_of(const std::string& option,
                                                              const std::string& text,
                                                              const ShotInput& input);

/// Gives the input's shot the cameras of the new film. If names_moments, its motion has to be known
/// (know_motion). Throws InputError.
void retime(const RetimeWords& words, pipeline::RetimeOptions options, ShotInput& input);

}  // namespace carom::cli
