// The program libexec/carom/carom-studio, which runs the commands `studio` and `farm watch`.
// bin/carom executes it with its own arguments.
#include "pipeline/cli/command_line.h"
#include "pipeline/cli/farm/farm_watch.h"
#include "pipeline/cli/run_program.h"

int main(int argument_count, char** arguments) {
    using namespace carom::cli;
    const auto parsed = parse_command_line({arguments + 1, arguments + argument_count});
    if (const auto* early_exit = std::get_if<EarlyExit>(&parsed)) {
        return print(*early_exit);
    }
    return run_command(std::get<CommandLine>(parsed),
                       [](const Command& command, CommandContext& context) {
                           if (const auto* farm = std::get_if<FarmCommand>(&command)) {
                               return farm_watch(*farm, context);
                           }
                           run_here<Program::studio>(command, context);
                       });
}
