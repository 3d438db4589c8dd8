#include "pipeline/cli/help/option_table.h"

#include <sstream>

#include "pipeline/cli/options/app.h"

namespace carom::cli {

namespace {

/// "{text,json}", as IsMember describes itself, as words; empty for other checks.
std::vector<std::string> choices_of(const CLI::Option& option) {
    const std::string name = option.get_name(false, false);
    if (name == "--quality") {
        return {"draft", "preview", "final"};  // what configs/quality has; others may be added
    }
    std::string text;
    try {
        text = const_cast<CLI::Option&>(option).get_validator()->get_description();
    } catch (const CLI::OptionNotFound&) {
        return {};  // it has none
    }
    std::vector<std::string> words;
    if (text.starts_with('{') && text.ends_with('}')) {
        std::istringstream list(text.substr(1, text.size() - 2));
        for (std::string word; std::getline(list, word, ',');) {
            words.push_back(word);
        }
    }
    return words;
}

CommandInfo describe(const CLI::App& app) {
    CommandInfo command{app.get_name(), app.get_description(), app.get_footer(), {}, {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        const std::string description = option->get_description();
        if (option->get_positional()) {
            command.arguments.push_back(
                {option->get_name(true, false), description, choices_of(*option)});
            continue;
        }
        OptionInfo info;
        info.long_name = "--" + option->get_lnames().front();
        if (!option->get_snames().empty()) {
            info.short_name = "-" + option->get_snames().front();
        }
        info.value = option->get_option_text();
        info.description = description;
        info.choices = choices_of(*option);
        command.options.push_back(std::move(info));
    }
    for (const CLI::App* below : app.get_subcommands({})) {
        command.commands.push_back(describe(*below));
    }
    return command;
}

}  // namespace

CommandInfo describe_command_line() {
    Targets targets;
    return describe(*make_app(targets));
}

}  // namespace carom::cli
