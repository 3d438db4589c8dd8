// The options of the commands for new shots, imports, the cache, the schema and completions.
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

void describe(NewCommand& command, CommandDescription& description) {
    description.details = {"The shot is commented and can be rendered as it is."};
    description.argument("SHOT", command.shot, "The file to write; - is standard output.")
        .offers(Offer::files, {"yaml", "yml"});
    description
        .option("--template", &command.template_name, "NAME",
                "The template: break (the default), trick, bank, massé (or masse), jump, dominoes "
                "or empty.")
        .one_of({"break", "trick", "bank", "massé", "masse", "jump", "dominoes", "set", "empty"});
    description.flag("--force", command.force, "Overwrite a file that exists.");
    description.examples = {{"carom new shot.yaml", "A break shot."},
                            {"carom new shot.yaml --template jump", "A jump shot."}};
}

void describe(StudioCommand& command, CommandDescription& description) {
    description.details = {
        "Starts a server that only this machine can reach, prints its address and opens it in a "
        "browser: the shot's text beside a view of the table. Every change of the text is "
        "simulated at once, and every change in the view is written to the text. Files change "
        "only when they are saved in the page.",
        "On a machine without a display, use --no-browser and pass the port on: ssh -L "
        "8080:127.0.0.1:8080 HOST, with --port 8080 on that machine. Ctrl-C ends the server."};
    description
        .argument("SHOT", command.input.path,
                  "The shot to edit. Without it, the page offers templates, examples and the shots "
                  "that were opened last; new ones are written below the current folder.")
        .offers(Offer::files, {"yaml", "yml"})
        .is_required = false;
    description
        .option("-o,--output", &command.output, "FOLDER",
                "The folder of films and exports. The default is that of the shot.")
        .offers(Offer::folders);
    add_page(description, command.page);
    add_changes(description, command.input);
    add_cache(description, command.cache);
    description.examples = {
        {"carom studio shot.yaml", "Edit a shot in the browser."},
        {"carom studio", "Begin with a template, an example or a recent shot."},
        {"carom studio shot.yaml --port 8080 --no-browser", "The same from another machine."}};
}

void describe(SchemaCommand& command, CommandDescription& description) {
    description.details = {
        "The schema uses draft 7 of JSON Schema. An editor with a YAML language server completes "
        "and checks a shot whose first line is '# yaml-language-server: "
        "$schema=carom.schema.json'."};
    add_output(description, command.output, "Write to this file instead of standard output.");
    description.examples = {{"carom schema -o carom.schema.json", "The schema as a file."}};
}

void describe(ImportCommand& command, CommandDescription& description) {
    description.details = {
        "Approximations are reported and also written as comments to the shot. 'carom render "
        "--quality draft' corresponds to the preview of the older format, 'carom frame --frame N' "
        "to a single frame.",
        "An OBJ file with several materials becomes one mesh file and one object for each of them, "
        "and its MTL file becomes materials; include the result in a shot."};
    description
        .argument("SCENE", command.scene,
                  "The text of the scene, or an .obj or .ply file; docs/import.md describes both.")
        .offers(Offer::files);
    add_output(description, command.output,
               "The shot. The default is the scene's name and .yaml in the current folder.");
    description
        .option("--unit", &command.unit, "METRES",
                "The length of the file's unit in metres. With 0.01, the default for scenes, a "
                "table of 200 by 100 is 2 m long. The default for meshes is 1.")
        .between(1e-6, 1e3);
    description
        .option("--up", &command.up, "AXIS", "The axis that points up: y (the default) or z.")
        .one_of({"y", "z"});
    description
        .option("--fov", &command.fov, "MEANING",
                "What the number FOV means: the distance of a plane four units wide (distance, the "
                "default), or the manual's formula 2 atan(FOV / 2) (formula).")
        .one_of({"distance", "formula"});
    description
        .option("--boxes", &command.boxes, "MOTION",
                "Which boxes with use_physics move: all but the ground and large ones (auto, the "
                "default), none (fixed) or all (dynamic).")
        .one_of({"auto", "fixed", "dynamic"});
    description
        .option("--force-time", &command.force_time, "S",
                "How long each force acts, in seconds (default 0.05). The older format does not "
                "define it.")
        .between(1e-6, 10.0);
    description.examples = {{"carom import scene.txt -o shot.yaml && carom render shot.yaml",
                             "The film of an older scene."},
                            {"carom import chair.obj --unit 0.001 -o chair.yaml",
                             "The parts of a chair, in millimetres, with their materials."}};
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
                       "The object to import, if the table has several, such as one that 'carom "
                       "export' wrote.");
    description.option("--name", &command.name, "NAME",
                       "Write a file that a shot can include, with the motion of its object of "
                       "this name. Without --name only the motion is written.");
    description.option("--error", &command.error, "LENGTH",
                       "Omit rows if the motion deviates from them by no more than this distance "
                       "(default 0.01 mm). With 0 every row becomes a key.");
    description.flag("--linear", command.linear,
                     "Move straight and at constant speed between keys instead of smoothly.");
    description.examples = {{"carom import-track hand.csv --name hand -o hand.yaml",
                             "Then write 'include: hand.yaml' in a shot with "
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

/// What push and pull have in common.
CommandDescription& add_transfer(CommandDescription& description, CacheCommand& cache,
                                 const char* name, const char* summary, const char* place,
                                 const char* place_help, CacheCommand::Action action) {
    CommandDescription& added = add_action(description, cache, name, summary, action);
    added.argument(place, cache.place, place_help).offers(Offer::folders);
    added
        .argument("SHOT|BAKE", cache.input.path,
                  "Copy only what this film needs: its bake and its frames. Without it, everything "
                  "is copied.")
        .offers(Offer::files, {"yaml", "yml", "bake"})
        .is_required = false;
    add_changes(added, cache.input);
    add_camera_file(added, cache.input);
    add_frames(added, cache.frames);
    add_tier(added);
    added.flag("--dry-run", cache.dry_run, "Only print what would be copied.");
    return added;
}

void describe_transfers(CacheCommand& command, CommandDescription& description) {
    constexpr const char* kPlace =
        "The other cache, as rsync takes it: a folder, HOST:FOLDER (through ssh, or what RSYNC_RSH "
        "names) or rsync://HOST/MODULE.";
    CommandDescription& push = add_transfer(
        description, command, "push", "Copy finished frames and bakes to another cache, by rsync.",
        "DEST", kPlace, CacheCommand::Action::push);
    push.examples = {{"carom cache push node7:/scratch/carom shot.yaml",
                      "Give another machine the bake and the frames of a film."}};
    CommandDescription& pull =
        add_transfer(description, command, "pull",
                     "Copy finished frames and bakes from another cache, by rsync.", "SOURCE",
                     kPlace, CacheCommand::Action::pull);
    add_cache_size(pull, command.cache);
    pull.examples = {{"carom cache pull node7:/scratch/carom shot.yaml",
                      "Fetch what another machine has rendered of a film."}};
    CommandDescription& merge = add_action(
        description, command, "merge", "Copy finished frames and bakes of other caches, by rsync.",
        CacheCommand::Action::merge);
    merge.argument("DIR", command.folders, "The other caches. More than one may be given.")
        .offers(Offer::folders);
    add_cache_size(merge, command.cache);
    merge.flag("--dry-run", command.dry_run, "Only print what would be copied.");
    merge.examples = {{"carom cache merge /media/a/carom /media/b/carom && carom mux shot.yaml",
                       "The film of frames that two machines have rendered."}};
}

}  // namespace

void describe(CacheCommand& command, CommandDescription& description) {
    description.details = {
        "The cache contains bakes, finished frames and answers of `solve`. Files that are removed "
        "from it are made again when they are needed.",
        "'carom cache verify' ends with exit code 1 if a file is damaged.",
        "'push', 'pull' and 'merge' copy only finished, intact files, and never replace one that "
        "the "
        "receiving cache has. They are for machines without a common file system."};
    CommandDescription& list =
        add_action(description, command, "list",
                   "Print the number of files, their size, when they were last used, and the room "
                   "that running jobs have reserved.",
                   CacheCommand::Action::list);
    list.flag("--json", command.json, "Print one JSON object per file and per reservation.");
    list.examples = {{"carom cache list", "The size of the cache."}};

    CommandDescription& prune =
        add_action(description, command, "prune",
                   "Remove the least recently used files until the cache is within its limit.",
                   CacheCommand::Action::prune);
    add_cache_size(prune, command.cache);
    prune
        .option("--unused-for", &command.unused_for, "TIME",
                "Also remove all files that were not used for this long: 30d, 12h.")
        .excludes({"--all"});
    prune.flag("--all", command.all, "Remove everything.");
    prune
        .flag("--features", command.features,
              "Remove only what the denoiser reads: noisy frames with their features. Films show "
              "the denoised ones, which stay; another strength of denoising renders again.")
        .excludes({"--all", "--cache-size"});
    prune.flag("--dry-run", command.dry_run, "Only print what would be removed.");
    prune.examples = {
        {"carom cache prune --unused-for 30d", "Remove what was not used for 30 days."},
        {"carom cache prune --features", "Keep only what films show."}};

    CommandDescription& verify =
        add_action(description, command, "verify", "Read every file and remove damaged ones.",
                   CacheCommand::Action::verify);
    verify.flag("--keep", command.keep, "Only print the names of damaged files.");
    verify.examples = {
        {"carom cache verify", "Find damaged files, for example after the disk was full."}};
    describe_transfers(command, description);
    description.examples = {
        {"carom cache prune --cache-size 5GB", "Reduce the cache to at most 5 GB."}};
}

void describe(CompletionCommand& command, CommandDescription& description) {
    description.details = {"If carom is installed, the shells already find these scripts."};
    description.argument("SHELL", command.shell, "bash, zsh or fish.")
        .one_of({"bash", "zsh", "fish"});
    add_output(description, command.output, "Write to this file instead of standard output.");
    description.examples = {{"carom completion bash -o ~/.bash_completion",
                             "Completion for a carom that is not "
                             "installed."}};
}

}  // namespace carom::cli
