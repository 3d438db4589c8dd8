#include "pipeline/cli/help/completion.h"
#include "pipeline/cli/help/manual_page.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

namespace {

void write_result(const std::string& path, const std::string& text) {
    check_output_folder(path);
    write_text_output(path.empty() ? "-" : path, text);
}

}  // namespace

void run(const CompletionCommand& command, CommandContext& /*context*/) {
    const CommandInfo program = describe_command_line();
    write_result(command.output, command.shell == "bash"  ? bash_completion(program)
                                 : command.shell == "zsh" ? zsh_completion(program)
                                                          : fish_completion(program));
}

void run(const ManualCommand& command, CommandContext& /*context*/) {
    write_result(command.output, manual_page(describe_command_line(), CAROM_VERSION));
}

}  // namespace carom::cli
