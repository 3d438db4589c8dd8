#include "pipeline/cli/program_description.h"

#include <tuple>
#include <variant>

namespace carom::cli {

namespace {

const char* heading_of(Group group) {
    switch (group) {
        case Group::make:
            return "Make a shot";
        case Group::look:
            return "Look at a shot";
        case Group::film:
            return "Film a shot";
        case Group::keep:
            return "Keep results";
        case Group::tools:
            return "Tools";
    }
    return "";
}

void add_help_option(CommandDescription& description) {
    description.option("-h,--help", static_cast<bool*>(nullptr), "", "Print this help.");
}

/// Adds the options that every command has, at the end of its list.
void add_common_options(CommandDescription& description, ProgramOptions& options) {
    add_help_option(description);
    for (CommandDescription& subcommand : description.commands) {
        add_common_options(subcommand, options);
    }
    if (!description.commands.empty()) {
        return;
    }
    description.flag("-q,--quiet", options.quiet,
                     "Print only errors, and warnings of the simulation, such as of a strike that "
                     "misses: no progress, no notes and no other warnings about the shot, which "
                     "'carom check' lists.");
    description
        .option("--log", &options.log, "FORMAT",
                "The format of messages: text (the default), or json with one object per line.")
        .one_of({"text", "json"});
}

void describe_program_itself(CommandDescription& program) {
    program.name = "carom";
    program.summary = "Turn a billiard shot written in YAML into a film.";
    program.details = {
        "A shot is simulated once. Its motion is then filmed by a ray tracer, as often as you "
        "like, at any speed and with any camera."};
    program.examples = {
        {"carom new shot.yaml", "Write a commented shot to start from."},
        {"carom check shot.yaml", "Report every problem of the shot, with its line."},
        {"carom plan shot.yaml -o shot.svg", "Draw the shot from above, within a second."},
        {"carom render shot.yaml -o film.mp4",
         "Simulate the shot, render its frames and write the film."}};
    program.notes = {
        "Results are written to standard output, messages to standard error. The exit code is 0 "
        "after success, 1 after a failure while running, 2 after wrong usage or input, and 130 "
        "after an interruption.",
        "'carom COMMAND --help' explains a command."};
    add_help_option(program);
    program.option("--version", static_cast<bool*>(nullptr), "", "Print the version.");
}

}  // namespace

ProgramOptions::ProgramOptions() {
    const auto add = [&]<class T>(const CommandRow<T>& /*row*/) { commands.emplace_back(T{}); };
    std::apply([&](const auto&... row) { (add(row), ...); }, kCommandTable);
}

CommandDescription describe_program(ProgramOptions& options) {
    CommandDescription program;
    describe_program_itself(program);
    const auto add = [&](const auto& row) {
        const std::size_t index = program.commands.size();
        CommandDescription& added = program.command(row.name, row.summary);
        added.group = heading_of(row.group);
        added.chosen = [&options, index] { options.chosen = index; };
        std::visit([&](auto& command) { describe(command, added); }, options.commands[index]);
        add_common_options(added, options);
    };
    std::apply([&](const auto&... row) { (add(row), ...); }, kCommandTable);
    return program;
}

}  // namespace carom::cli
