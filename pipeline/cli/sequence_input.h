// Reads films of several shots for commands.
#pragma once

#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/sequence/load_sequence.h"

namespace carom::cli {

/// The film and its problems. `folder_of_shots` as of load_sequence. Throws InputError if an option
/// does not apply to films of several shots.
[[nodiscard]] pipeline::SequenceResult load_sequence_input(const InputOptions& input,
                                                           const std::string& folder_of_shots = {});

/// Reports all problems on the console; throws InputError if one of them is an error.
[[nodiscard]] pipeline::Sequence require_sequence(pipeline::SequenceResult loaded,
                                                  const InputOptions& input, Console& console);

/// The same as both; all problems are reported on the console. Throws InputError if one of them is
/// an error.
[[nodiscard]] pipeline::Sequence read_sequence_input(const InputOptions& input, Console& console,
                                                     const std::string& folder_of_shots = {});

/// The shot of a part as the input of other functions, which takes it out of the part until
/// `take_back`.
[[nodiscard]] ShotInput input_of(pipeline::ShotPart& part);
void take_back(ShotInput input, pipeline::ShotPart& part);

/// Where a part is for messages: "part 2, lesson.yaml".
[[nodiscard]] std::string part_name(std::size_t index, const pipeline::ShotPart& part);

/// What `carom info` prints of a film.
[[nodiscard]] std::string sequence_summary(const pipeline::Sequence& sequence);

/// Writes a plan for each shot.
void plan_sequence(const PlanCommand& command, CommandContext& context);

}  // namespace carom::cli
