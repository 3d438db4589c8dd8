// Commands that tell of a shot without rendering it.
#include <cstdlib>

#include "pipeline/cli/options/command_options.h"
#include "pipeline/cli/options/shared_options.h"
#include "pipeline/export/sample_times.h"

namespace carom::cli {

namespace {

/// Empty if the text is a rate that sample_times takes.
std::string rate_problem(const std::string& text) {
    char* end = nullptr;
    const double rate = std::strtod(text.c_str(), &end);
    const bool is_number = !text.empty() && *end == '\0';
    if (is_number && rate > 0 && rate <= pipeline::kHighestRate) {
        return {};
    }
    return "'" + text + "' is not a number of samples per second above 0 and at most " +
           std::to_string(static_cast<int>(pipeline::kHighestRate)) + ", as 240";
}

}  // namespace

void add_bake(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("bake", "simulate a shot, without a picture");
    add_input(command, targets.bake.input, "SHOT", "a shot");
    add_output(command, targets.bake.output, "else the shot's name and .bake");
    add_cache(command, targets.bake.cache);
    add_talk(command, targets);
    command.footer(example("  carom bake break.yaml -o break.bake"));
}

void add_check(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("check", "say everything that is wrong with a shot");
    add_input(command, targets.check.input, "SHOT|BAKE", "a shot or a bake");
    add_camera_file(command, targets.check.input);
    command.add_flag("--json", targets.check.json,
                     "problems as a JSON array on standard output, for editors");
    command.add_flag("--quick", targets.check.quick,
                     "only what can be said without simulating the shot");
    add_cache(command, targets.check.cache);
    add_talk(command, targets);
    command.footer(example("  carom check break.yaml") +
                   "\nErrors, and warnings of what was surely not meant: a strike that misses,\n"
                   "a camera inside a ball. For these the shot is simulated, for 2 s at most,\n"
                   "unless its bake was kept. Exit code 0 if it can be rendered, warnings or\n"
                   "not, 2 if not.");
}

void add_info(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("info", "what a shot comes to");
    InfoCommand& info = targets.info;
    add_input(command, info.input, "SHOT|BAKE", "a shot or a bake");
    add_camera_file(command, info.input);
    command.add_flag("--resolved", info.resolved,
                     "the whole shot as YAML, every value with the file and line it came from");
    add_output(command, info.output, "else standard output");
    add_talk(command, targets);
    command.footer(example("  carom info break.yaml --resolved --quality draft") +
                   "\nAfter includes, presets and --set; what nobody gave is marked 'default'.");
}

void add_export(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("export", "a shot as .csv, .json, .glb or .usda");
    ExportCommand& command_options = targets.export_;
    add_input(command, command_options.input, "SHOT|BAKE", "a shot or a bake");
    add_output(command, command_options.output,
               "by its ending: .csv (object, time, position, orientation, velocities), .json, .glb "
               "(glTF) or .usda; else the shot's name and .csv; - is a table on standard output");
    command
        .add_option("--rate", command_options.rate,
                    "samples per second, evenly; else the keys of each track (.csv, .json)")
        ->option_text("HZ")
        ->check(rate_problem);
    command
        .add_option("--events", command_options.events,
                    "a second table: impacts, rolling, pottings, force events")
        ->option_text("FILE");
    add_cache(command, command_options.cache);
    add_talk(command, targets);
    command.footer(
        example("  carom export break.yaml -o break.glb\n"
                "  carom export break.yaml --rate 240 -o tracks.csv --events events.csv") +
        "\n.glb and .usda have the objects at their real size, with colours, cameras and\n"
        "motion, for Blender, Houdini or a browser; docs/export.md has more.");
}

void add_report(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("report", "what happens in a shot, in numbers");
    ReportCommand& report = targets.report;
    add_input(command, report.input, "SHOT|BAKE", "a shot or a bake");
    add_output(command, report.output, "else standard output");
    command.add_flag("--json", report.json, "one JSON object, with all digits");
    command
        .add_option("--plot", report.plot,
                    "draw the speeds and the energy over time: .svg or .png; without -o and --json "
                    "only that")
        ->option_text("FILE");
    add_drawing(command, report.drawing);
    add_cache(command, report.cache);
    add_talk(command, targets);
    command.footer(
        example("  carom report break.yaml\n"
                "  carom report break.yaml --plot speeds.svg") +
        "\nEvents with speeds, spin and cut angles; how each object moved and ended;\nenergy.");
}

void add_plan(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("plan", "draw a shot from above");
    PlanCommand& plan = targets.plan;
    add_input(command, plan.input, "SHOT|BAKE", "a shot or a bake");
    add_camera_file(command, plan.input);
    add_output(command, plan.output,
               "the drawing, .svg or .png (else the shot's name and .svg; - is standard output)");
    add_drawing(command, plan.drawing);
    add_cache(command, plan.cache);
    add_talk(command, targets);
    command.footer(example("  carom plan break.yaml -o break.svg") +
                   "\nThe table to scale with balls, paths, numbered events and cameras, and what "
                   "each\ncamera shows when.");
}

}  // namespace carom::cli
