// The options of the command that varies values of a shot.
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

namespace {

void add_samples(CommandDescription& description, SweepCommand& command) {
    description
        .option("--samples", &command.samples, "N",
                "Sample ranges without a step and errors N times, for each combination of the "
                "other values.")
        .between(1, 1'000'000);
    description
        .option("--sampling", &command.sampling, "NAME",
                "How they are sampled: sobol (the default, Sobol's sequence), latin (a Latin "
                "hypercube) or random.")
        .one_of({"sobol", "latin", "random"})
        .needs("--samples");
    description
        .option("--seed", &command.seed, "N",
                "Other samples; the same number gives the same ones on every machine (default 0).")
        .from(0)
        .needs("--samples");
}

}  // namespace

void describe(SweepCommand& command, CommandDescription& description) {
    description.details = {
        "Values of the shot are varied, each variant is simulated, and what is measured becomes a "
        "row of a table. Nothing is rendered and the cache is not used.",
        "A varied value is written like one of --set: KEY=LOW..HIGH UNIT:STEP is a range in steps, "
        "KEY=VALUE,VALUE,... a list of numbers or words, and every combination of these is a "
        "variant. KEY=LOW..HIGH UNIT without a step is sampled evenly, and KEY~ERROR UNIT normally "
        "around the shot's value (KEY=VALUE~ERROR UNIT around another one): --samples says how "
        "often.",
        "A measure is its name and its arguments: rebound_angle:cue,2 is the angle at which 'cue' "
        "leaves its second cushion. Where a MOMENT is wanted, it is written as in a shot, or as "
        "words with commas: contact,cue,one or cushion,cue,2. A cell stays empty if what is "
        "measured does not happen. --measures lists all."};
    Option& shot = description.argument("SHOT", command.input.path,
                                        "The shot; - reads it from standard input.");
    shot.is_required = false;
    shot.offers(Offer::files, {"yaml", "yml"});
    description
        .option("--vary", &command.vary, "KEY=VALUES",
                "Vary this value. The option may be repeated.")
        .offers(Offer::keys);
    description
        .option("--measure", &command.measures, "NAME:ARGS",
                "Measure this, as a column of the table. The option may be repeated.")
        .offers(Offer::measures);
    description.flag("--measures", command.lists_measures,
                     "List all measures with their arguments, units and meanings.");
    add_samples(description, command);
    add_changes(description, command.input);
    add_output(description, command.output,
               "The table, .csv or .jsonl (a JSON object in each line). The default is CSV on "
               "standard output.");
    description
        .option("--plot", &command.plot, "FILE",
                "Draw the measures over the varied values, as .svg or .png: lines over one value, "
                "a map over two; of samples the mean. Without -o only the drawing is written.")
        .offers(Offer::files);
    add_drawing(description, command.drawing);
    description
        .option("--threads", &command.threads, "N",
                "Simulate with N threads. 0, the default, means one per processor. The table is "
                "the same.")
        .between(0, 1024);
    description.examples = {
        {"carom sweep --measures", "What can be measured."},
        {"carom sweep bank_shot.yaml --vary 'events[0].strike.speed=1..8 m/s:0.5' --measure "
         "rebound_angle:cue",
         "How the angle of a bank depends on the speed."},
        {"carom sweep bank_shot.yaml --vary 'events[0].strike.speed=1..6 m/s:0.25' --vary "
         "physics.ball_cushion.model=mathavan2010,han2005 --measure speed_kept:cue --plot kept.svg",
         "The same for two models of the cushion, as two lines."},
        {"carom sweep bank_shot.yaml --vary 'events[0].strike.direction=115..119 deg:0.1' --vary "
         "'events[0].strike.speed=1..6 m/s:0.2' --measure pocket:nine --plot map.svg",
         "A map of where the nine goes."},
        {"carom sweep bank_shot.yaml --vary 'events[0].strike.direction~0.3 deg' --vary "
         "'events[0].strike.speed~0.1 m/s' --samples 500 --measure potted:nine -o errors.csv",
         "How sure the shot is, with a player's errors."}};
    description.notes = {
        "Ctrl-C ends the sweep and writes the variants that are finished. docs/sweep.md tells "
        "more."};
}

}  // namespace carom::cli
