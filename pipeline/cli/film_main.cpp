// libexec/carom/carom-film: the commands that render. Started by bin/carom with its own arguments.
#include <cstdio>

#include "pipeline/cli/command_line.h"
#include "pipeline/cli/compare_command.h"
#include "pipeline/cli/contact_sheet_command.h"
#include "pipeline/cli/film_commands.h"
#include "pipeline/cli/overload.h"
#include "pipeline/cli/retime_command.h"

namespace {

using namespace carom::cli;

void run(const Command& command, CommandContext& context) {
    std::visit(
        Overload{
            [&](const RenderCommand& render) { run_render(render, context); },
            [&](const RetimeCommand& retime) { run_retime(retime, context); },
            [&](const MuxCommand& mux) { run_mux(mux, context); },
            [&](const FrameCommand& frame) { run_frame(frame, context); },
            [&](const ContactSheetCommand& sheet) { run_contact_sheet(sheet, context); },
            [&](const CompareCommand& compare) { run_compare(compare, context); },
            [](const auto&) { throw InputError("this program only renders; call carom instead"); },
        },
        command);
}

}  // namespace

int main(int argument_count, char** arguments) {
    const auto parsed = parse_command_line({arguments + 1, arguments + argument_count});
    if (const auto* nothing = std::get_if<NothingToRun>(&parsed)) {
        return print(*nothing);
    }
    return run_command(std::get<CommandLine>(parsed), run);
}
