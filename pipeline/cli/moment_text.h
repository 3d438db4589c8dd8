// Moments on the command line: "{contact: [cue, one]}".
#pragma once

#include <string>

#include "pipeline/cli/shot_input.h"

namespace carom::cli {

/// Whether the value of an option is a moment and not a number.
[[nodiscard]] bool is_moment_text(const std::string& text);

/// The scene time (s) of the moment in the motion of the input, which has to be known
/// (know_motion), rounded to the microsecond. `option` ("--from") is for messages. Throws
/// InputError.
[[nodiscard]] double time_of_moment(const std::string& option, const std::string& text,
                                    const ShotInput& input);

}  // namespace carom::cli
