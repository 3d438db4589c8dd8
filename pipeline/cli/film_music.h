// The music of films, for commands that may run in a program without a decoder.
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/video/output_settings.h"
#include "sound/mix/added_sound.h"

namespace carom::cli {

/// The music of a film of so many samples, to be mixed with its sound; empty if there is none. The
/// program must be able to read it. Throws InputError if the file cannot be played; of a shot, this
/// is reported at its place.
[[nodiscard]] sound::AddedSound film_music(const pipeline::OutputSettings& output,
                                           std::int64_t film_samples,
                                           const CommandContext& context);
[[nodiscard]] sound::AddedSound film_music(const ShotInput& input, std::int64_t film_samples,
                                           const CommandContext& context);

/// Reports that a shot's music cannot be read, and throws InputError.
[[noreturn]] void refuse_music(const ShotInput& input, const std::string& reason, Console& console);

}  // namespace carom::cli
