// The parser of the command line: the only file that includes CLI11, which takes seconds to
// compile.
#include "pipeline/cli/command_line.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "core/printable.h"
#include "pipeline/cli/exit_code.h"
#include "pipeline/cli/help_text.h"
#include "pipeline/cli/program_description.h"
#include "pipeline/config/text.h"

namespace carom::cli {

namespace {

// ---- converts the description to CLI11's ------------------------------------------------------

template <class Number>
void limit(CLI::Option& added, const Option& option, Number /*kind*/) {
    if (option.minimum && option.maximum) {
        added.check(
            CLI::Range(static_cast<Number>(*option.minimum), static_cast<Number>(*option.maximum)));
    } else if (option.minimum) {
        added.check(CLI::Range(*option.minimum, std::numeric_limits<double>::max()));
    }
}

CLI::Option& add_target(CLI::App& app, const Option& option) {
    const std::string names =
        (option.short_name.empty() ? "" : option.short_name + ",") + option.name;
    const auto add = [&](auto* target) {
        using T = std::remove_pointer_t<decltype(target)>;
        if constexpr (std::is_same_v<T, bool>) {
            return app.add_flag(names, *target);
        } else {
            CLI::Option* added =
                target != nullptr ? app.add_option(names, *target) : app.add_option(names);
            if constexpr (std::is_same_v<T, std::vector<std::string>>) {
                // One value for each time the option is given; arguments follow one another.
                added->allow_extra_args(option.is_argument());
            } else if constexpr (std::is_arithmetic_v<T>) {
                limit(*added, option, T{});
            } else if constexpr (!std::is_same_v<T, std::string>) {  // std::optional
                limit(*added, option, typename T::value_type{});
            }
            return added;
        }
    };
    return *std::visit(add, option.target);
}

void add_option(CLI::App& app, const Option& option) {
    CLI::Option& added = add_target(app, option);
    added.required(option.is_required);
    if (!option.choices.empty()) {
        added.check(CLI::IsMember(option.choices));
    }
    if (option.must_be_folder) {
        added.check(CLI::ExistingDirectory);
    }
    if (option.problem_of) {
        added.check(option.problem_of);
    }
}

/// The option that takes all words behind it.
constexpr const char* kRest = "--";

bool is_handled_by_parser(const Option& option) {
    const auto* flag = std::get_if<bool*>(&option.target);
    return flag != nullptr && *flag == nullptr;
}

void add_command(CLI::App& app, const CommandDescription& command) {
    for (const Option& option : command.options) {
        if (!is_handled_by_parser(option) && option.name != kRest) {
            add_option(app, option);
        }
    }
    for (const Option& option : command.options) {
        for (const std::string& other : option.excluded) {
            app.get_option(option.name)->excludes(app.get_option(other));
        }
        if (!option.needed.empty()) {
            app.get_option(option.name)->needs(app.get_option(option.needed));
        }
    }
    for (const CommandDescription& below : command.commands) {
        add_command(*app.add_subcommand(below.name, below.summary), below);
    }
    app.require_subcommand(command.commands.empty() ? 0 : 1);
    if (command.chosen) {
        app.callback(command.chosen);
    }
}

/// Takes the words after "--" out of the arguments, if the command has an option for them.
void take_rest(const CommandDescription& program, std::vector<std::string>& arguments) {
    const CommandDescription* command = &program;
    for (const std::string& word : arguments) {
        const CommandDescription* below = command->find_command(word);
        if (below == nullptr) {
            break;
        }
        command = below;
    }
    const Option* rest = command->find_option(kRest);
    const auto mark = std::find(arguments.begin(), arguments.end(), kRest);
    if (rest != nullptr && mark != arguments.end()) {
        std::get<std::vector<std::string>*>(rest->target)->assign(mark + 1, arguments.end());
        arguments.erase(mark, arguments.end());
    }
}

// ---- what is printed instead of running -------------------------------------------------------

/// The help of the innermost command that was given: "carom cache prune".
std::string help_of(const CLI::App& app, const CommandDescription& program) {
    const CommandDescription* command = &program;
    std::string path = program.name;
    for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
        at = at->get_subcommands().front();
        command = command->find_command(at->get_name());
        path += " " + command->name;
    }
    return help_text(*command, path);
}

/// "--frames is given twice; give it once"; empty if this is not the problem.
std::string repeated_option(const CLI::App& app) {
    for (const CLI::App* command : app.get_subcommands()) {
        for (const CLI::Option* option : command->get_options()) {
            if (option->get_items_expected_max() <= 1 && option->count() > 1) {
                return fmt::format(
                    "{} is given {}; give it once", option->get_name(),
                    option->count() == 2 ? "twice" : fmt::format("{} times", option->count()));
            }
        }
        if (std::string below = repeated_option(*command); !below.empty()) {
            return below;
        }
    }
    return "";
}

/// "unknown command 'rendr' (did you mean 'render'?)" instead of CLI11's "a subcommand is
/// required".
std::string usage_error(const CLI::App& app, const CommandDescription& program,
                        const CLI::ParseError& error, const std::vector<std::string>& arguments) {
    if (!app.get_subcommands().empty() || arguments.empty()) {
        const bool is_number = dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
        const std::string repeated = is_number ? repeated_option(app) : "";
        return repeated.empty() ? error.what() : repeated;
    }
    std::vector<std::string> names;
    for (const CommandDescription& command : program.commands) {
        names.push_back(command.name);
    }
    const std::string& given = arguments.front();
    return std::string("unknown ") + (given.starts_with('-') ? "option" : "command") + " '" +
           given + "'" + pipeline::config::hint(given, names).text;
}

EarlyExit exit_with_usage_error(const CLI::App& app, const CommandDescription& program,
                                const CLI::ParseError& error,
                                const std::vector<std::string>& arguments) {
    if (arguments.empty()) {
        return {kWrongUsage, "", help_text(program, program.name)};
    }
    const auto chosen = app.get_subcommands();
    const std::string command = chosen.empty() ? "" : chosen.front()->get_name() + " ";
    return {kWrongUsage, "",
            "carom: error: " + printable(usage_error(app, program, error, arguments)) +
                "\nSee 'carom " + command + "--help'.\n"};
}

}  // namespace

std::variant<CommandLine, EarlyExit> parse_command_line(const std::vector<std::string>& given) {
    ProgramOptions options;
    const CommandDescription program = describe_program(options);
    std::vector<std::string> arguments = given;
    take_rest(program, arguments);
    CLI::App app;
    app.set_version_flag("--version", "carom " CAROM_VERSION);
    add_command(app, program);
    try {
        // CLI11 expects the arguments in reverse order.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        return EarlyExit{kDone, help_of(app, program), ""};
    } catch (const CLI::CallForVersion& version) {
        return EarlyExit{kDone, std::string(version.what()) + "\n", ""};
    } catch (const CLI::ParseError& error) {
        return exit_with_usage_error(app, program, error, arguments);
    }
    return CommandLine{{options.quiet, options.log == "json"},
                       std::move(options.commands[options.chosen])};
}

int print(const EarlyExit& early_exit) {
    std::fputs(early_exit.err.c_str(), stderr);
    std::fputs(early_exit.out.c_str(), stdout);
    if (std::fflush(stdout) != 0) {
        std::fprintf(stderr, "carom: error: cannot write to standard output: %s\n",
                     std::strerror(errno));
        return kFailed;
    }
    return early_exit.exit_code;
}

}  // namespace carom::cli
