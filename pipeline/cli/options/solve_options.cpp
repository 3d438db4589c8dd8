// The options of the command that finds strikes.
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

void describe(SolveCommand& command, CommandDescription& description) {
    description.details = {
        "A shot says in `solve` what a strike shall bring about: which ball falls where, which "
        "balls and cushions are met, where a ball comes to rest. Direction, speed and tip of the "
        "strike are found by simulating, as far as the strike does not give them.",
        "Solutions that go different ways are listed, the best one first: the way, the strike, the "
        "window of directions in which it succeeds, and the chance of a player with the errors of "
        "`solve.player`, with its standard error. Render, check and the studio take the first "
        "one."};
    description.details.emplace_back(
        "solve: {want: [{potted: red, in: top right}, {rest: cue, near: [0.3, 0.1], within: 0.2 "
        "m}], avoid: [{contact: [cue, blue]}], player: club} pots the red and brings the cue ball "
        "to a place. Other wants: {cushions: cue, at_least: 3, before: {contact: [cue, red]}}, "
        "{clears: blue}, and what 'carom sweep --measures' lists, as in {measure: "
        "'rebound_angle:cue', about: 30 deg, within: 1 deg}.");
    description.argument("SHOT", command.input.path, "The shot; - reads it from standard input.")
        .offers(Offer::files, {"yaml", "yml"});
    description.flag("--all", command.lists_all, "List all solutions; by default the three best.");
    description.flag("--json", command.json, "Print all of them as JSON, an object in each line.");
    add_changes(description, command.input);
    add_output(description, command.output,
               "Write the shot with the strike that was found instead of `solve`, as one file "
               "without includes.");
    description.flag("--write", command.writes,
                     "Write the strike into SHOT itself instead of 'solve'; all else stays as it "
                     "is.");
    description
        .option("--map", &command.map, "FILE",
                "Draw what comes of the best strike with other directions and speeds, and where "
                "the struck ball comes to rest under the player's errors, as .svg or .png.")
        .offers(Offer::files);
    description
        .option("--plans", &command.plans, "FILE",
                "Draw each solution: the table with the paths of its balls, as .svg or .png.")
        .offers(Offer::files);
    add_drawing(description, command.drawing);
    add_cache(description, command.cache);
    add_no_store(description, command.cache);
    description.examples = {
        {"carom solve solve_red_black.yaml", "The best strikes."},
        {"carom solve solve_red_black.yaml --set solve.player=beginner --all",
         "All ways, and how sure a beginner would be of each."},
        {"carom solve solve_red_black.yaml --map map.svg --plans ways.png",
         "How exact the strike has to be, and all ways on a sheet."},
        {"carom solve solve_red_black.yaml -o solved.yaml", "The shot with its strike."}};
    description.notes = {"docs/solving.md tells more."};
}

}  // namespace carom::cli
