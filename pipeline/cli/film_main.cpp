// libexec/carom/carom-film: the commands that render. Started by bin/carom with its own arguments.
#include "pipeline/cli/command_line.h"
#include "pipeline/cli/helper_program.h"
#include "pipeline/cli/run_program.h"

int main(int argument_count, char** arguments) {
    using namespace carom::cli;
    const auto parsed = parse_command_line({arguments + 1, arguments + argument_count});
    if (const auto* nothing = std::get_if<NothingToRun>(&parsed)) {
        return print(*nothing);
    }
    return run_command(std::get<CommandLine>(parsed),
                       [&](const Command& command, CommandContext& context) {
                           try {
                               run_here<Program::film>(command, context);
                           } catch (const OtherProgram& other) {
                               become_program(other.name(), arguments);
                           }
                       });
}
