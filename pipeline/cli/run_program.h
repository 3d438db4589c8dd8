// Runs a command with a console, signal handling and exit codes.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/error.h"
#include "pipeline/cli/commands.h"
#include "pipeline/cli/exit_code.h"
#include "pipeline/cli/terminal/console.h"
#include "pipeline/config/problem.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"
#include "pipeline/video/output_settings.h"
#include "render/acceleration/structure_maker.h"
#include "sim/timeline/timeline.h"
#include "sound/mix/added_sound.h"

namespace carom::cli {

/// The input or the options are invalid: exit code 2.
class InputError : public Error {
  public:
    using Error::Error;
};

/// Finds what check says about the texts of a shot; only programs that link Pango have it.
using FindTextProblems = std::vector<pipeline::Problem> (*)(const pipeline::Shot&,
                                                            const pipeline::ShotSource*,
                                                            const sim::Timeline&);

/// A job of the farm goes on when its tasks are started again, which is for somebody else to do:
/// exit code 75.
class TryAgain : public Error {
  public:
    using Error::Error;
};

/// The time limit of a task of the farm was over: exit code 124.
class OutOfTime : public Error {
  public:
    OutOfTime() : Error("the time limit of this task was over; another one goes on") {}
};

/// The memory of a task of the farm did not suffice: exit code 137.
class OutOfMemory : public Error {
  public:
    OutOfMemory() : Error("there is not enough memory") {}
};

/// Nobody reads standard output any more ("carom report … | head -1"): the command ends silently.
class OutputClosed : public Error {
  public:
    OutputClosed() : Error("standard output is closed") {}
};

/// The environment of a command's handler. Handlers return after success and throw otherwise.
struct CommandContext {
    Console& console;
    std::stop_token stop;
    render::NamedStructures structures = nullptr;  // that the renderer does not have
    /// Opens a film's music (pipeline/video/music_source.h); null in the program that links no
    /// decoder.
    sound::AddedSound (*music)(const pipeline::MusicSettings& settings,
                               std::int64_t film_samples) = nullptr;
    /// Null in the program that lays out no text.
    FindTextProblems text_problems = nullptr;
    /// Prepares the view of a film, and throws Error if it cannot be used; null likewise.
    void (*view)(const pipeline::OutputSettings& output) = nullptr;
    /// What check says about the light on a shot's table; null in the program without a renderer.
    std::string (*table_light)(const pipeline::Shot& shot) = nullptr;
};

/// Runs a command of the programs `here`. Commands of other programs are not linked; for these it
/// throws InputError.
template <Program... here>
void run_here(const Command& command, CommandContext& context) {
    std::visit(
        [&]<class T>(const T& chosen) {
            if constexpr (((kRowOf<T>.program == here) || ...)) {
                run(chosen, context);
            } else {
                throw InputError("this program does not have this command; run carom instead");
            }
        },
        command);
}

using CommandHandler = std::function<void(const Command&, CommandContext&)>;

/// Runs `handler`. If it throws, prints the error on stderr and returns the exit code for it.
[[nodiscard]] ExitCode run_command(const CommandLine& line, const CommandHandler& handler);

/// Writes a result to stdout: a whole text, or a path on a line of its own (on a terminal without
/// control characters). Throws Error.
void print_text(const std::string& text);
void print_path(const std::string& path);

}  // namespace carom::cli
