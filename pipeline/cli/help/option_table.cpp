#include "pipeline/cli/help/option_table.h"

#include "pipeline/cli/program_description.h"

namespace carom::cli {

namespace {

CommandInfo describe(const CommandDescription& description) {
    CommandInfo command;
    command.name = description.name;
    command.description = description.summary;
    for (const Example& example : description.examples) {
        command.footer += "  " + example.line + "\n";
    }
    for (const Option& option : description.options) {
        std::vector<std::string> choices = option.choices;
        if (option.offer == Offer::presets) {
            choices = {"draft", "preview", "final"};  // what configs/quality has
        }
        if (option.is_argument()) {
            command.arguments.push_back({option.name, option.help, choices});
        } else {
            command.options.push_back(
                {option.short_name, option.name, option.value, option.help, choices});
        }
    }
    for (const CommandDescription& below : description.commands) {
        command.commands.push_back(describe(below));
    }
    return command;
}

}  // namespace

CommandInfo describe_command_line() {
    ProgramOptions options;
    return describe(describe_program(options));
}

}  // namespace carom::cli
