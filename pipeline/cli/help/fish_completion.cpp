#include <sstream>

#include "core/text.h"
#include "pipeline/cli/help/completion.h"

namespace carom::cli {

namespace {

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char letter : text) {
        if (letter == '\'' || letter == '\\') {
            result += '\\';
        }
        result += letter;
    }
    return result + "'";
}

void write(std::ostringstream& out, const CommandInfo& command, const std::string& condition) {
    std::string names;
    for (const CommandInfo& below : command.commands) {
        names += (names.empty() ? "" : " ") + below.name;
    }
    const std::string line = "complete -c carom -n " + quoted(condition);
    if (!command.commands.empty()) {
        out << line << " -f\n";
    }
    const std::string none_yet = condition == "true"
                                     ? "__fish_use_subcommand"
                                     : condition + "; and not __fish_seen_subcommand_from " + names;
    for (const CommandInfo& below : command.commands) {
        out << "complete -c carom -n " << quoted(none_yet) << " -f -a " << below.name << " -d "
            << quoted(below.description) << "\n";
    }
    const std::string& own = command.commands.empty() ? condition : none_yet;
    for (const OptionInfo& option : command.options) {
        out << "complete -c carom -n " << quoted(own);
        if (!option.short_name.empty()) {
            out << " -s " << option.short_name.substr(1);
        }
        out << " -l " << option.long_name.substr(2);
        if (!option.choices.empty()) {
            out << " -x -a " << quoted(join(option.choices, " "));
        } else if (option.takes_file()) {
            out << " -r -F";
        } else if (option.takes_folder()) {
            out << " -x -a '(__fish_complete_directories)'";
        } else if (!option.value.empty()) {
            out << " -x";
        }
        out << " -d " << quoted(option.description) << "\n";
    }
    for (const ArgumentInfo& argument : command.arguments) {
        if (!argument.choices.empty()) {
            out << line << " -f -a " << quoted(join(argument.choices, " ")) << "\n";
        }
    }
    const std::string seen =
        (condition == "true" ? "" : condition + "; and ") + "__fish_seen_subcommand_from ";
    for (const CommandInfo& below : command.commands) {
        write(out, below, seen + below.name);
    }
}

}  // namespace

std::string fish_completion(const CommandInfo& program) {
    std::ostringstream out;
    out << "# fish completion for carom; made by 'carom completion fish'.\n";
    write(out, program, "true");
    return out.str();
}

}  // namespace carom::cli
