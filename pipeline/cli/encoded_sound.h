// Files of sound that need an encoder.
#pragma once

#include <memory>
#include <string>

#include "pipeline/cli/sound_command.h"

namespace carom::cli {

/// Runs the command where its files need an encoder (needs_encoder). Throws Error, Stopped.
void write_encoded_sound(const SoundCommand& command, CommandContext& context);

}  // namespace carom::cli
