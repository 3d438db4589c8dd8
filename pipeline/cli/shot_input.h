// Reading what a command was given: a shot, or a bake.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/terminal/console.h"
#include "pipeline/config/problem.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

struct ShotInput {
    pipeline::Shot shot;
    std::optional<sim::Bake> bake;  // if the input was one
};

/// Whether the file is a bake, by its identifier; a name that ends in .bake promises one.
[[nodiscard]] bool is_bake_file(const std::string& path);

/// The bake, checked. Throws InputError.
[[nodiscard]] sim::Bake read_bake_input(const std::string& path);

/// The shot, or the bake and the shot that it carries. All problems are reported on the console;
/// throws InputError if one of them is an error, or if the options change the physics of a bake.
[[nodiscard]] ShotInput read_shot_input(const InputOptions& input, Console& console);

/// As a compiler would print them; one JSON event each if the console talks JSON.
void report_problems(const std::vector<pipeline::Problem>& problems, Console& console);

/// "2 errors and 1 warning"; empty if there are none.
[[nodiscard]] std::string count_text(const std::vector<pipeline::Problem>& problems);

}  // namespace carom::cli
