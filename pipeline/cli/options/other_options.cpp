// Options of starters, imports, the cache, and of what carom prints about itself.
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

void describe(NewCommand& command, CommandDescription& description) {
    description.details = {"The shot is commented and can be rendered as it is."};
    description.argument("SHOT", command.shot, "The file to write; - is standard output.")
        .offers(Offer::files, {"yaml", "yml"});
    description
        .option("--template", &command.template_name, "NAME",
                "What to start from: break (the default), trick, bank, massé (or masse), jump, "
                "dominoes or empty.")
        .one_of({"break", "trick", "bank", "massé", "masse", "jump", "dominoes", "empty"});
    description.flag("--force", command.force, "Overwrite a file that exists.");
    description.examples = {{"carom new shot.yaml", "A break shot."},
                            {"carom new shot.yaml --template jump", "A jump shot."}};
}

void describe(SchemaCommand& command, CommandDescription& description) {
    description.details = {
        "The schema is of draft 7. An editor with a YAML language server completes and checks a "
        "shot whose first line is '# yaml-language-server: $schema=carom.schema.json'."};
    add_output(description, command.output, "Write to this file instead of standard output.");
    description.examples = {{"carom schema -o carom.schema.json", "The schema as a file."}};
}

void describe(ImportCommand& command, CommandDescription& description) {
    description.details = {
        "What had to be approximated is reported, and stands as comments in the shot. 'carom "
        "render --quality draft' is the format's preview, 'carom frame --frame N' one frame."};
    description
        .argument("SCENE", command.scene,
                  "The text of the scene; docs/import.md describes the format.")
        .offers(Offer::files);
    add_output(description, command.output,
               "The shot. The default is the scene's name and .yaml in the current folder.");
    description
        .option("--unit", &command.unit, "METRES",
                "The length of the scene's unit. With 0.01, the default, a table of 200 by 100 is "
                "2 m long.")
        .between(1e-6, 1e3);
    description
        .option("--up", &command.up, "AXIS", "The axis that points up: y (the default) or z.")
        .one_of({"y", "z"});
    description
        .option("--force-time", &command.force_time, "S",
                "Seconds for which each force acts, which the format does not say (default 0.05).")
        .between(1e-6, 10.0);
    description.examples = {{"carom import scene.txt -o shot.yaml && carom render shot.yaml",
                             "The film of an older scene."}};
}

void describe(ImportTrackCommand& command, CommandDescription& description) {
    description
        .argument("TABLE", command.table,
                  "A CSV file with the columns time, x, y, z and optionally qw, qx, qy, qz or rx, "
                  "ry, rz (degrees), vx, vy, vz, wx, wy, wz, object.")
        .offers(Offer::files, {"csv"});
    add_output(description, command.output,
               "The YAML. The default is the table's name and .yaml in the current folder; - is "
               "standard output.");
    description.option("--object", &command.object, "NAME",
                       "Which object of a table with several, such as 'carom export' writes.");
    description.option("--name", &command.name, "NAME",
                       "Write a file to include, with the motion of the shot's object of this "
                       "name. Without it the file holds the motion alone.");
    description.option("--error", &command.error, "LENGTH",
                       "Leave out rows that the motion meets within this distance (default 0.01 "
                       "mm). With 0 every row becomes a key.");
    description.flag("--linear", command.linear,
                     "Move straight and at constant speed from key to key, not smoothly.");
    description.examples = {{"carom import-track hand.csv --name hand -o hand.yaml",
                             "Write 'include: hand.yaml' in a shot with "
                             "'objects: {hand: {mesh: hand.obj}}'."}};
}

namespace {

CommandDescription& add_action(CommandDescription& description, CacheCommand& cache,
                               const char* name, const char* summary, CacheCommand::Action action) {
    CommandDescription& added = description.command(name, summary);
    added.chosen = [&cache, action] { cache.action = action; };
    add_cache(added, cache.cache);
    return added;
}

}  // namespace

void describe(CacheCommand& command, CommandDescription& description) {
    description.details = {
        "The cache holds bakes and finished frames. Whatever is removed from it is simulated and "
        "rendered again when it is needed.",
        "'carom cache verify' ends with exit code 1 if a file was damaged."};
    CommandDescription& list = add_action(description, command, "list",
                                          "Print how many files there are, how large they "
                                          "are and when they were last used.",
                                          CacheCommand::Action::list);
    list.flag("--json", command.json, "Print one JSON object per file.");
    list.examples = {{"carom cache list", "The size of the cache."}};

    CommandDescription& prune = add_action(
        description, command, "prune", "Remove the files that were not used for the longest time.",
        CacheCommand::Action::prune);
    add_cache_size(prune, command.cache);
    prune
        .option("--unused-for", &command.unused_for, "TIME",
                "Remove everything that was not used for so long: 30d, 12h.")
        .excludes({"--all"});
    prune.flag("--all", command.all, "Remove everything.");
    prune.flag("--dry-run", command.dry_run, "Only print what would be removed.");
    prune.examples = {{"carom cache prune --unused-for 30d", "Forget what is a month old."}};

    CommandDescription& verify =
        add_action(description, command, "verify", "Read every file and remove damaged ones.",
                   CacheCommand::Action::verify);
    verify.flag("--keep", command.keep, "Only print the names of damaged files.");
    verify.examples = {{"carom cache verify", "Find damage, after a full disk for example."}};
    description.examples = {{"carom cache prune --cache-size 5GB", "Make room on the disk."}};
}

void describe(CompletionCommand& command, CommandDescription& description) {
    description.details = {"An installed carom has placed these scripts where the shells look."};
    description.argument("SHELL", command.shell, "bash, zsh or fish.")
        .one_of({"bash", "zsh", "fish"});
    add_output(description, command.output, "Write to this file instead of standard output.");
    description.examples = {
        {"carom completion bash -o ~/.bash_completion", "For a carom that is not installed."}};
}

}  // namespace carom::cli
