// libexec/carom/carom-lab: `carom compare`, and everything that carom-film does, with the
// structures for comparison. Started by bin/carom or carom-film with the same arguments.
#include "lab/structures/make_structure.h"
#include "pipeline/cli/command_line.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/video/music_source.h"
#include "pipeline/video/view_transform.h"

namespace {

using namespace carom::cli;

void run_in_laboratory(const Command& command, CommandContext& context) {
    context.structures = carom::render::named_structure;
    context.music = carom::pipeline::music_of;
    context.view = carom::pipeline::try_view;
    run_here<Program::film, Program::lab>(command, context);
}

}  // namespace

int main(int argument_count, char** arguments) {
    const auto parsed = parse_command_line({arguments + 1, arguments + argument_count});
    if (const auto* early_exit = std::get_if<EarlyExit>(&parsed)) {
        return print(*early_exit);
    }
    return run_command(std::get<CommandLine>(parsed), run_in_laboratory);
}
