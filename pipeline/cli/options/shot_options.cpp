// The options of the commands that simulate or describe a shot without rendering it.
#include <cstdlib>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/cli/options/shared_options.h"
#include "pipeline/export/json_parts.h"
#include "pipeline/export/sample_times.h"
#include "pipeline/report/report_parts.h"

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
    description.argument("SHOT", command.input.path, "The shot; - reads it from standard input.")
        .offers(Offer::files, {"yaml", "yml"});
    add_changes(description, command.input);
    add_output(
        description, command.output,
        "The bake; - writes it to standard output, which must be a pipe or a file. The default "
        "is the shot's name and .bake.");
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
    description.flag("--lux", command.lux,
                     "Print how brightly the table is lit, in lux at nine points seen from above: "
                     "the middle of the bed, and the middles and the corners of the rails.");
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
                     "every value the file and line that it comes from, or 'default'. Of a film, "
                     "all its shots one after the other.");
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
    const std::string parts = join(pipeline::json_part_names(), ", ");
    description.option("--only", &command.only, "WORDS",
                       "Write only these parts of a .json, as a list with commas: " + parts +
                           ". The meshes of the table are the largest.");
    description.option("--without", &command.without, "WORDS",
                       "Leave out these parts of a .json: meshes,energy.");
    add_cache(description, command.cache);
    description.examples = {{"carom export break.yaml -o break.glb", "The scene with its motion."},
                            {"carom export break.yaml -o break.json --without meshes,energy",
                             "All data but the largest parts."},
                            {"carom export break.yaml --rate 240 -o tracks.csv --events events.csv",
                             "The motion, 240 times per second, and the events, as tables."}};
}

void describe(ReportCommand& command, CommandDescription& description) {
    description.details = {
        "The report lists the events with speeds, spin and cut angles, how each object moved and "
        "where it ended, the energy, and the times of moments. It fits 80 columns. Four or more "
        "impacts of the same two, each within 0.1 s of the one before, are one line.",
        "Of a film of several shots it is that of each shot.",
        "The words of --only and --without are " + join(pipeline::report_words(), ", ") +
            ". 'collisions' are impacts of two objects that move, 'motion' is a change of the kind "
            "of motion, such as rolling. A word of --without has precedence."};
    add_input(description, command.input);
    add_changes(description, command.input);
    description.option("--only", &command.only, "WORDS",
                       "Report only these kinds of events and parts, as a list with commas: "
                       "pots,strikes or collisions,objects.");
    description.option("--without", &command.without, "WORDS", "Leave these out: motion,energy.");
    description.option("--object", &command.objects, "NAME",
                       "Report only events of this ball or object. The option may be repeated.");
    description.option("--from", &command.from, "TIME",
                       "Report only events from this scene time on, a number or a moment such as "
                       "'{contact: [cue, one], before: 0.2s}'.");
    description.option("--to", &command.to, "TIME",
                       "Report only events up to this scene time, written like --from.");
    description.option("--min-impulse", &command.min_impulse, "NS",
                       "Leave out impacts and strikes of a smaller impulse, in newton seconds: "
                       "0.01 is a ball of 170 g at 0.06 m/s.");
    description.flag("--every-impact", command.every_impact,
                     "List every impact on a line of its own.");
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
                            {"carom report break.yaml --only pots,strikes", "Only these events."},
                            {"carom report break.yaml --object cue --from 1s --without motion",
                             "What happens to the cue ball later."},
                            {"carom report break.yaml --json --without energy_over_time",
                             "All of it as data, without the energy of every sample."},
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
