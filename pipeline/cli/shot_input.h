// Reads the input of a command: a shot or a bake.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/terminal/console.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/config/named_file.h"
#include "pipeline/config/problem.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

struct ShotInput {
    pipeline::Shot shot;
    std::optional<sim::Bake> bake;  // if the input is a bake
    std::shared_ptr<const pipeline::ShotSource> source;
    bool has_own_cameras = true;  // the cameras are those of `source`, in the same order
};

/// What a command is about, which decides what it warns of and what stops it.
enum class Subject {
    motion,  // only the motion: not the cameras, texts and lights
    plan,    // the motion and the cameras, which are looked at
    film     // pictures or sound: it cannot be made if a moment never comes
};

/// How the input's options change its shot. The options' texts must outlive the result.
[[nodiscard]] pipeline::LoadOptions load_options(const InputOptions& input);

/// All problems of an input, and the input unless one of them is an error.
struct CheckedInput {
    std::vector<pipeline::Problem> problems;
    std::optional<ShotInput> input;
    std::vector<pipeline::NamedFile> files{};  // that it names, also if there is no input
};

/// Reads the input like read_shot_input, but returns its problems. Throws InputError if the options
/// change the physics of a bake.
[[nodiscard]] CheckedInput load_shot_input(const InputOptions& input);

/// Whether the input is a bake: its name ends in .bake, or it has the identifier of the format.
[[nodiscard]] bool is_bake(const InputOptions& input);

/// Whether the input is a film of several shots.
[[nodiscard]] bool is_sequence(const InputOptions& input);

/// Reads and verifies a bake. Throws InputError.
[[nodiscard]] sim::Bake read_bake_input(const InputOptions& input);

/// Reports the problems that concern the subject on the console; throws InputError if one of them
/// is an error.
[[nodiscard]] ShotInput require_shot_input(CheckedInput checked, const InputOptions& input,
                                           Console& console, Subject subject = Subject::film);

/// Reads the shot, or the bake and the shot in it. The problems that concern the subject are
/// reported on the console. Throws InputError if one of them is an error, or if the options change
/// the physics of a bake.
[[nodiscard]] ShotInput read_shot_input(const InputOptions& input, Console& console,
                                        Subject subject = Subject::film);

/// Prints problems in the format of a compiler, or each as a JSON event if the console prints JSON.
/// A quiet console prints no warnings about the shot, because 'carom check' has them. `is_asked`:
/// it prints these as well, which are the command's result or say that the motion is not as meant.
void report_problems(const std::vector<pipeline::Problem>& problems, Console& console,
                     bool is_asked = false);

/// The JSON members of a problem: "file", "line", "column", "end_column" and so on.
[[nodiscard]] JsonMembers members_of(const pipeline::Problem& problem);

/// The number of problems as text: "2 errors and 1 warning"; empty if there are none.
[[nodiscard]] std::string count_text(const std::vector<pipeline::Problem>& problems);

}  // namespace carom::cli
