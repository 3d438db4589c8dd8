// Checks of the files that an input names.
#pragma once

#include <string>

#include "pipeline/cli/run_program.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/cli/shot_input.h"

namespace carom::cli {

enum class FileReading {
    none,   // the files were checked before
    usual,  // large files by their headers
    full,
};

/// Throws NeedsProgram if the program that decodes music, lays out text and opens views is needed,
/// and is not this one. Callers report nothing before, since the other program does.
void require_film_program(bool is_needed, const CommandContext& context);

/// Opens the files that the input names, and prepares the view of its film, and adds the problems
/// to those of the input, which is lost if one of them is an error. Throws NeedsProgram, before
/// anything is reported, if that needs libraries that this program does not have. Returns a
/// sentence about files of which only the headers were read, or nothing.
std::string check_files(CheckedInput& checked, FileReading reading, const CommandContext& context);

/// The same for a film of several shots.
std::string check_files(pipeline::SequenceResult& loaded, FileReading reading,
                        const CommandContext& context);

/// As read_shot_input and read_sequence_input, with these problems.
[[nodiscard]] ShotInput read_checked_input(const InputOptions& input, FileReading reading,
                                           CommandContext& context,
                                           Subject subject = Subject::film);
[[nodiscard]] pipeline::Sequence read_checked_sequence(const InputOptions& input,
                                                       FileReading reading,
                                                       CommandContext& context);

}  // namespace carom::cli
