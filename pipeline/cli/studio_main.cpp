// The program libexec/carom/carom-studio, which runs the command `studio`. bin/carom executes it
// with its own arguments.
#include "pipeline/cli/command_line.h"
#include "pipeline/cli/run_program.h"

int main(int argument_count, char** arguments) {
    using namespace carom::cli;
    const auto parsed = parse_command_line({arguments + 1, arguments + argument_count});
    if (const auto* early_exit = std::get_if<EarlyExit>(&parsed)) {
        return print(*early_exit);
    }
    return run_command(std::get<CommandLine>(parsed), run_here<Program::studio>);
}
