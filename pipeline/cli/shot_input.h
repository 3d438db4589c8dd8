// Reading what a command was given: a shot, or a bake.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/terminal/console.h"
#include "pipeline/config/problem.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

struct ShotInput {
    pipeline::Shot shot;
    std::optional<sim::Bake> bake;  // if the input was one
    std::shared_ptr<const pipeline::ShotSource> source;
    bool has_own_cameras = true;  // those of `source`, in their order
};

/// All that is wrong with an input, and the input unless an error is among it.
struct CheckedInput {
    std::vector<pipeline::Problem> problems;
    std::optional<ShotInput> input;
};

/// Throws InputError as below, but nothing that a problem says.
[[nodiscard]] CheckedInput load_shot_input(const InputOptions& input);

/// Whether the file is a bake, by its identifier; a name that ends in .bake promises one.
[[nodiscard]] bool is_bake_file(const std::string& path);

/// The bake, checked. Throws InputError.
[[nodiscard]] sim::Bake read_bake_input(const std::string& path);

/// Reports all problems on the console; throws InputError if one of them is an error.
[[nodiscard]] ShotInput accept_shot_input(CheckedInput checked, const InputOptions& input,
                                          Console& console);

/// The shot, or the bake and the shot that it carries. All problems are reported on the console;
/// throws InputError if one of them is an error, or if the options change the physics of a bake.
[[nodiscard]] ShotInput read_shot_input(const InputOptions& input, Console& console);

/// As a compiler would print them; one JSON event each if the console talks JSON.
void report_problems(const std::vector<pipeline::Problem>& problems, Console& console);

/// "file", "line", "column", "end_column" ... of one.
[[nodiscard]] JsonMembers members_of(const pipeline::Problem& problem);

/// "2 errors and 1 warning"; empty if there are none.
[[nodiscard]] std::string count_text(const std::vector<pipeline::Problem>& problems);

}  // namespace carom::cli
