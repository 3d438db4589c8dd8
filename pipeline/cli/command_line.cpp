#include "pipeline/cli/command_line.h"

#include <cstdio>
#include <memory>
#include <sstream>

#include "pipeline/cli/exit_code.h"
#include "pipeline/cli/help_formatter.h"
#include "pipeline/cli/options/app.h"

namespace carom::cli {

namespace {

/// "unknown command 'rendr' (did you mean 'render'?)" instead of CLI11's "a subcommand is
/// required".
std::string complaint_about(const CLI::App& app, const CLI::ParseError& error,
                            const std::vector<std::string>& arguments) {
    if (!app.get_subcommands().empty() || arguments.empty()) {
        return error.what();
    }
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    const std::string& given = arguments.front();
    const std::string hint = nearest(given, names);
    return std::string("unknown ") + (given.starts_with('-') ? "option" : "command") + " '" +
           given + "'" + (hint.empty() ? "" : " (did you mean '" + hint + "'?)");
}

NothingToRun report(const CLI::App& app, const CLI::ParseError& error,
                    const std::vector<std::string>& arguments) {
    std::ostringstream out;
    std::ostringstream err;
    NothingToRun nothing;
    if (app.exit(error, out, err) == 0) {  // help, version
        nothing.out = out.str();
        return nothing;
    }
    nothing.exit_code = kWrongUsage;
    const auto chosen = app.get_subcommands();
    const std::string command = chosen.empty() ? "" : chosen.front()->get_name() + " ";
    nothing.err = arguments.empty() ? app.help()
                                    : "carom: error: " + complaint_about(app, error, arguments) +
                                          "\n'carom " + command + "--help' says what there is\n";
    return nothing;
}

}  // namespace

std::variant<CommandLine, NothingToRun> parse_command_line(
    const std::vector<std::string>& arguments) {
    Targets targets;
    const std::unique_ptr<CLI::App> owned = make_app(targets);
    CLI::App& app = *owned;
    try {
        // CLI11 takes its arguments from the back.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
        return report(app, error, arguments);
    }
    targets.talk.json = targets.log == "json";
    return CommandLine{targets.talk, chosen_command(app, targets)};
}

int print(const NothingToRun& nothing) {
    std::fputs(nothing.err.c_str(), stderr);
    std::fputs(nothing.out.c_str(), stdout);
    const bool written = std::fflush(stdout) == 0;
    return written ? nothing.exit_code : kFailed;
}

}  // namespace carom::cli
