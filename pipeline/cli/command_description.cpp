#include "pipeline/cli/command_description.h"

#include <algorithm>
#include <utility>

namespace carom::cli {

Option& Option::one_of(std::vector<std::string> values) {
    choices = std::move(values);
    return *this;
}

Option& Option::from(double smallest) {
    minimum = smallest;
    return *this;
}

Option& Option::between(double smallest, double largest) {
    minimum = smallest;
    maximum = largest;
    return *this;
}

Option& Option::checked_by(std::function<std::string(const std::string&)> check) {
    problem_of = std::move(check);
    return *this;
}

Option& Option::excludes(std::vector<std::string> names) {
    excluded = std::move(names);
    return *this;
}

Option& Option::needs(std::string name_of_other) {
    needed = std::move(name_of_other);
    return *this;
}

Option& Option::offers(Offer what, std::vector<std::string> file_endings) {
    offer = what;
    endings = std::move(file_endings);
    return *this;
}

Option& CommandDescription::flag(const std::string& names, bool& target, std::string help) {
    return option(names, &target, "", std::move(help));
}

Option& CommandDescription::option(const std::string& names, Target target, std::string value,
                                   std::string help) {
    const std::size_t comma = names.find(',');
    const bool has_short_name = comma != std::string::npos;
    Option added;
    added.short_name = has_short_name ? names.substr(0, comma) : "";
    added.name = has_short_name ? names.substr(comma + 1) : names;
    added.value = std::move(value);
    added.help = std::move(help);
    added.target = target;
    return options.emplace_back(std::move(added));
}

Option& CommandDescription::argument(const std::string& argument_name, std::string& target,
                                     std::string help) {
    Option& added = option(argument_name, &target, "", std::move(help));
    added.is_required = true;
    return added;
}

Option& CommandDescription::argument(const std::string& argument_name,
                                     std::vector<std::string>& target, std::string help) {
    Option& added = option(argument_name, &target, "", std::move(help));
    added.is_required = true;
    return added;
}

CommandDescription& CommandDescription::command(std::string command_name,
                                                std::string command_summary) {
    CommandDescription& added = commands.emplace_back();
    added.name = std::move(command_name);
    added.summary = std::move(command_summary);
    return added;
}

const CommandDescription* CommandDescription::find_command(const std::string& command_name) const {
    const auto found = std::ranges::find(commands, command_name, &CommandDescription::name);
    return found == commands.end() ? nullptr : &*found;
}

const Option* CommandDescription::find_option(const std::string& option_name) const {
    const auto found = std::ranges::find_if(options, [&](const Option& option) {
        return !option_name.empty() &&
               (option.name == option_name || option.short_name == option_name);
    });
    return found == options.end() ? nullptr : &*found;
}

}  // namespace carom::cli
