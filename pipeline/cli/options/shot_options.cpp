// The options of the commands that simulate or describe a shot without rendering it.
#include <cstdlib>

#include <fmt/core.h>

#include "pipeline/cli/options/shared_options.h"
#include "pipeline/export/sample_times.h"

namespace carom::cli {

namespace {

/// Empty if the text is a rate that sample_times accepts.
std::string rate_problem(const std::string& text) {
    char* end = nullptr;
    const double rate = std::strtod(text.c_str(), &end);
    const bool is_number = !text.empty() && *end == '\0';
    if (is_number && rate > 0 && rate <= pipeline::kHighestRate) {
        return {};
    }
    return fmt::format(
        "'{}' is not a number of samples per second; write a number above 0 and at most {}, such "
        "as 240",
        text, static_cast<int>(pipeline::kHighestRate));
}

}  // namespace

void describe(BakeCommand& command, CommandDescription& description) {
    description.details = {
        "A bake contains the motion of every object, the events and the shot itself. Every command "
        "that accepts a shot also accepts its bake, and does not simulate it again."};
    description.argument("SHOT", command.input.path, "The shot.")
        .offers(Offer::files, {"yaml", "yml"});
    add_changes(description, command.input);
    add_output(description, command.output, "The bake. The default is the shot's name and .bake.");
    add_cache(description, command.cache);
    description.examples = {{"carom bake break.yaml -o break.bake", "Simulate the shot once."}};
}

void describe(CheckCommand& command, CommandDescription& description) {
    description.details = {
        "An error is something that carom cannot use. A warning is about something valid that is "
        "probably a mistake: a strike that misses, a camera inside a ball. To find these, the shot "
        "is simulated, for about 2 s at most, unless the cache has its bake.",
        "The files that the shot names are opened and read: meshes, pictures, fonts, music and the "
        "configuration of OpenColorIO.",
        "The exit code is 0 if the shot can be rendered, with or without warnings, and 2 if not."};
    add_input(description, command.input);
    add_changes(description, command.input);
    add_camera_file(description, command.input);
    description.flag("--json", command.json,
                     "Print the problems as a JSON array on standard output, for editors.");
    description.flag("--quick", command.quick,
                     "Report only what can be known without simulating the shot.");
    description.flag(
        "--full", command.full,
        "Read also large files whole. Without it, files are read whole that have up to "
        "64 MB together, and of larger ones only the headers.");
    add_cache(description, command.cache);
    description.examples = {
        {"carom check break.yaml", "All errors and warnings, each with file, line and column."},
        {"carom check break.yaml --set render.samples=0", "Check whether a change is valid."}};
}

void describe(InfoCommand& command, CommandDescription& description) {
    description.details = {
        "The summary lists the film's length and size, its cameras, and the simulated and the "
        "visible objects."};
    add_input(description, command.input);
    add_changes(description, command.input);
    add_camera_file(description, command.input);
    description.flag("--resolved", command.resolved,
                     "Print the whole shot as YAML, after includes, presets and --set, and for "
                     "every value the file and line that it comes from, or 'default'.");
    add_output(description, command.output, "Write to this file instead of standard output.");
    description.examples = {
        {"carom info break.yaml", "A summary."},
        {"carom info break.yaml --resolved --quality draft", "Every value of the draft."}};
}

void describe(ExportCommand& command, CommandDescription& description) {
    description.details = {
        "A .glb or .usda file contains the objects at their real size, with colours, cameras and "
        "motion, for Blender, Houdini or a browser; see docs/export.md."};
    add_input(description, command.input);
    add_changes(description, command.input);
    add_output(description, command.output,
               "The file. Its name selects the format: .csv (object, time, position, orientation, "
               "velocities), .json, .glb (glTF) or .usda. The default is the shot's name and .csv; "
               "- writes a CSV table to standard output.");
    description
        .option("--rate", &command.rate, "HZ",
                "Write this number of evenly spaced samples per second (.csv, .json). By default "
                "the keys of each track are written.")
        .checked_by(rate_problem);
    description
        .option("--events", &command.events, "FILE",
                "Also write a table of events: impacts, changes of motion such as rolling, potted "
                "balls and force events. Without -o only this table is written.")
        .offers(Offer::files);
    description
        .option("--contacts", &command.contacts, "FILE",
                "Also write a table of lasting contacts, such as a box that slides on a floor: "
                "both objects, beginning and end, mean force and slip. Without -o only this table "
                "is written.")
        .offers(Offer::files);
    add_cache(description, command.cache);
    description.examples = {{"carom export break.yaml -o break.glb", "The scene with its motion."},
                            {"carom export break.yaml --rate 240 -o tracks.csv --events events.csv",
                             "The motion, 240 times per second, and the events, as tables."}};
}

void describe(ReportCommand& command, CommandDescription& description) {
    description.details = {
        "The report lists the events with speeds, spin and cut angles, how each object moved and "
        "where it ended, and the energy."};
    add_input(description, command.input);
    add_changes(description, command.input);
    add_output(description, command.output, "Write to this file instead of standard output.");
    description.flag("--json", command.json,
                     "Print one JSON object, with all digits, and the times in the film at which "
                     "impacts are heard.");
    description
        .option("--plot", &command.plot, "FILE",
                "Draw the speeds and the energy over time, and how loud the film is, as .svg or "
                ".png. Without -o and --json only the drawing is written.")
        .offers(Offer::files);
    add_drawing(description, command.drawing);
    add_cache(description, command.cache);
    description.examples = {{"carom report break.yaml", "The whole report."},
                            {"carom report break.yaml --plot speeds.svg", "Only the plot."}};
}

void describe(PlanCommand& command, CommandDescription& description) {
    description.details = {
        "The plan shows the table to scale with balls, paths, numbered events and cameras, and the "
        "interval of scene time that each camera shows. It is a quick way to see whether a shot "
        "does what it should."};
    add_input(description, command.input);
    add_changes(description, command.input);
    add_camera_file(description, command.input);
    add_output(
        description, command.output,
        "The drawing, .svg or .png. The default is the shot's name and .svg; - writes SVG to "
        "standard output.");
    add_drawing(description, command.drawing);
    add_cache(description, command.cache);
    description.examples = {{"carom plan break.yaml -o break.svg", "The drawing for a browser."}};
}

}  // namespace carom::cli
