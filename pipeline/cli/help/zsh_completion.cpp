#include <sstream>

#include "core/text.h"
#include "pipeline/cli/help/completion.h"

namespace carom::cli {

namespace {

/// Between single quotes; `specials` get a backslash as well.
std::string escaped(const std::string& text, const std::string& specials) {
    std::string result;
    for (const char letter : text) {
        if (letter == '\'') {
            result += "'\\''";
            continue;
        }
        if (specials.find(letter) != std::string::npos) {
            result += '\\';
        }
        result += letter;
    }
    return result;
}

std::string action_of(const std::vector<std::string>& choices, bool is_file, bool is_folder) {
    if (!choices.empty()) {
        return "(" + join(choices, " ") + ")";
    }
    return is_file ? "_files" : is_folder ? "_files -/" : " ";
}

/// One specification of _arguments (zshcompsys(1)).
std::string specification(const OptionInfo& option) {
    const std::string text = "[" + escaped(option.description, "[]:\\") + "]";
    std::string value;
    if (!option.value.empty()) {
        value = ":" + escaped(option.value, ":\\") + ":" +
                action_of(option.choices, option.takes_file(), option.takes_folder());
    }
    const std::string repeats = option.long_name == "--set" ? "*" : "";
    if (option.short_name.empty()) {
        return "'" + repeats + option.long_name + text + value + "'";
    }
    return "'(" + option.short_name + " " + option.long_name + ")'{" + option.short_name + "," +
           option.long_name + "}'" + text + value + "'";
}

/// "_carom_cache_prune" for cache prune.
std::string function_name(const std::string& parent, const std::string& command) {
    std::string name = parent + "_" + command;
    for (char& letter : name) {
        letter = letter == '-' ? '_' : letter;
    }
    return name;
}

void write(std::ostringstream& out, const CommandInfo& command, const std::string& function) {
    for (const CommandInfo& below : command.commands) {
        write(out, below, function_name(function, below.name));
    }
    out << function << "() {\n";
    if (!command.commands.empty()) {
        out << "    local -a commands\n    local line state\n    commands=(\n";
        for (const CommandInfo& below : command.commands) {
            out << "        '" << below.name << ":" << escaped(below.description, ":\\") << "'\n";
        }
        out << "    )\n";
    }
    out << "    _arguments -C \\\n";
    for (const OptionInfo& option : command.options) {
        out << "        " << specification(option) << " \\\n";
    }
    if (command.commands.empty()) {
        for (const ArgumentInfo& argument : command.arguments) {
            out << "        ':" << escaped(argument.name, ":\\") << ":"
                << action_of(argument.choices, true, false) << "' \\\n";
        }
        out << "        && return\n}\n";
        return;
    }
    out << "        '1: :->command' '*:: :->rest' && return\n"
        << "    case $state in\n"
        << "        command) _describe command commands ;;\n"
        << "        rest) case $words[1] in\n";
    for (const CommandInfo& below : command.commands) {
        out << "            " << below.name << ") " << function_name(function, below.name)
            << " ;;\n";
    }
    out << "        esac ;;\n    esac\n}\n";
}

}  // namespace

std::string zsh_completion(const CommandInfo& program) {
    std::ostringstream out;
    out << "#compdef carom\n# zsh completion for carom; made by 'carom completion zsh'.\n";
    write(out, program, "_carom");
    // Loaded as a function of this name at the first completion, or sourced.
    out << "if [ \"$funcstack[1]\" = _carom ]; then _carom \"$@\"; else compdef _carom carom; fi\n";
    return out.str();
}

}  // namespace carom::cli
