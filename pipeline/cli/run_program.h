// The frame around every command: console, signals, exit codes.
#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "core/error.h"
#include "pipeline/cli/commands.h"
#include "pipeline/cli/exit_code.h"
#include "pipeline/cli/terminal/console.h"
#include "render/acceleration/structure_factory.h"

namespace carom::cli {

/// The input or the options are not right: exit code 2.
class InputError : public Error {
  public:
    using Error::Error;
};

/// What a command's handler works with. Handlers return when done; failures are thrown.
struct CommandContext {
    Console& console;
    std::stop_token stop;
    render::StructureFactory factory = nullptr;  // of a program that has more than the renderer
};

/// Runs a command of the programs `here`. What the others run is not linked. Throws InputError for
/// their commands.
template <Program... here>
void run_here(const Command& command, CommandContext& context) {
    std::visit(
        [&]<class T>(const T& chosen) {
            if constexpr (((kRowOf<T>.program == here) || ...)) {
                run(chosen, context);
            } else {
                throw InputError("this command is run by another program; call carom instead");
            }
        },
        command);
}

using CommandHandler = std::function<void(const Command&, CommandContext&)>;

/// Runs `handler` and turns what it throws into a sentence on stderr and an exit code.
[[nodiscard]] ExitCode run_command(const CommandLine& line, const CommandHandler& handler);

/// Writes a result to stdout: a whole text, or a path on a line of its own (on a terminal without
/// its control characters). Throws Error.
void print_text(const std::string& text);
void print_path(const std::string& path);

}  // namespace carom::cli
