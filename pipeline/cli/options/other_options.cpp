// Starters, imports, the cache, and carom about itself.
#include "pipeline/cli/options/command_options.h"
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

void add_new(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("new", "write a starter for a shot");
    NewCommand& options = targets.new_;
    command.add_option("SHOT", options.shot, "the file to write; - is standard output")
        ->required()
        ->option_text(" ");
    command
        .add_option("--template", options.template_name,
                    "break (the default), trick, bank, massé (or masse), jump, dominoes, empty")
        ->option_text("NAME")
        ->check(CLI::IsMember(
            {"break", "trick", "bank", "massé", "masse", "jump", "dominoes", "empty"}));
    command.add_flag("--force", options.force, "also over a file that is there");
    add_talk(command, targets);
    command.footer(example("  carom new shot.yaml --template jump") +
                   "\nIt is commented, and renders as it is.");
}

void add_schema(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("schema", "the JSON Schema of shots, for editors");
    add_output(command, targets.schema.output, "else standard output");
    add_talk(command, targets);
    command.footer(example("  carom schema -o carom.schema.json") +
                   "\nDraft 7. A shot that begins with\n"
                   "  # yaml-language-server: $schema=carom.schema.json\n"
                   "is completed and checked while it is typed.");
}

void add_import(CLI::App& app, Targets& targets) {
    CLI::App& command =
        *app.add_subcommand("import", "make a shot of a scene in the older text format");
    ImportCommand& options = targets.import_;
    command.add_option("SCENE", options.scene, "a scene text (docs/import.md has the format)")
        ->required()
        ->option_text(" ");
    add_output(command, options.output,
               "the shot (else the scene's name and .yaml in the current folder)");
    command
        .add_option("--unit", options.unit,
                    "length of the scene's unit in metres: 0.01 makes its table of 200 by 100 one "
                    "of 2 m (the default)")
        ->option_text("METRES")
        ->check(CLI::Range(1e-6, 1e3));
    command.add_option("--up", options.up, "the axis that points up: y (the default) or z")
        ->option_text("AXIS")
        ->check(CLI::IsMember({"y", "z"}));
    command
        .add_option("--force-time", options.force_time,
                    "seconds for which each force acts, which the format does not say (default "
                    "0.05)")
        ->option_text("S")
        ->check(CLI::Range(1e-6, 10.0));
    add_talk(command, targets);
    command.footer(
        example("  carom import scene.txt -o shot.yaml && carom render shot.yaml") +
        "\nWhat was approximated is said, and stands as comments in the shot.\n"
        "'render --quality draft' is the format's preview, 'frame --frame N' one frame.");
}

void add_import_track(CLI::App& app, Targets& targets) {
    CLI::App& command =
        *app.add_subcommand("import-track", "make a keyed object's motion of a table");
    ImportTrackCommand& options = targets.import_track;
    command
        .add_option("TABLE", options.table,
                    "CSV: columns time, x, y, z and, if there are, qw, qx, qy, qz or rx, ry, rz "
                    "(degrees), vx, vy, vz, wx, wy, wz, object")
        ->required()
        ->option_text(" ");
    add_output(command, options.output,
               "the YAML (else the table's name and .yaml in the current folder; - is standard "
               "output)");
    command.add_option("--object", options.object, "which, of a table with several (carom export)")
        ->option_text("NAME");
    command
        .add_option("--name", options.name,
                    "of the shot's object: writes a file to include, not the motion alone")
        ->option_text("NAME");
    command
        .add_option("--error", options.error,
                    "rows that the motion meets within this are left out (default 0.01 mm; 0: "
                    "every row is a key)")
        ->option_text("LENGTH");
    command.add_flag("--linear", options.linear,
                     "straight and at constant speed from key to key, not smooth");
    add_talk(command, targets);
    command.footer(
        example("  carom import-track hand.csv --name hand -o hand.yaml\n") +
        "\nThen 'include: hand.yaml' in a shot with 'objects: {hand: {mesh: hand.obj}}'.");
}

void add_cache_actions(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("cache", "bakes and finished frames that are kept");
    command.require_subcommand(1);
    CacheCommand& cache = targets.cache;
    const auto add = [&](const char* name, const char* what, CacheCommand::Action action) {
        CLI::App& sub = *command.add_subcommand(name, what);
        sub.callback([&cache, action] { cache.action = action; });
        add_cache(sub, cache.cache);
        add_talk(sub, targets);
        return &sub;
    };
    CLI::App& list =
        *add("list", "how many, how large, when last used", CacheCommand::Action::list);
    list.add_flag("--json", cache.json, "one JSON object per file");
    CLI::App& prune =
        *add("prune", "remove what was used longest ago", CacheCommand::Action::prune);
    add_cache_size(prune, cache.cache);
    prune
        .add_option("--unused-for", cache.unused_for,
                    "remove all that was not used for so long: 30d, 12h")
        ->option_text("TIME");
    CLI::Option* all = prune.add_flag("--all", cache.all, "remove everything");
    prune.get_option("--unused-for")->excludes(all);
    prune.add_flag("--dry-run", cache.dry_run, "only say what would go");
    CLI::App& verify =
        *add("verify", "read every file and remove damaged ones", CacheCommand::Action::verify);
    verify.add_flag("--keep", cache.keep, "only name them");
    command.footer(example("  carom cache prune --cache-size 5GB") +
                   "\nWhatever goes is simulated and rendered again when it is needed.\n"
                   "verify: exit code 1 if a file was damaged.");
}

void add_completion(CLI::App& app, Targets& targets) {
    CLI::App& command =
        *app.add_subcommand("completion", "what completes carom's words in a shell");
    command.add_option("SHELL", targets.completion.shell, "bash, zsh or fish")
        ->required()
        ->option_text(" ")
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    add_output(command, targets.completion.output, "else standard output");
    add_talk(command, targets);
    command.footer(example("  carom completion bash -o ~/.bash_completion\n") +
                   "\nAn installed carom has put them where the shells look.");
}

void add_manual(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("manual", "carom's manual page");
    add_output(command, targets.manual.output, "else standard output");
    add_talk(command, targets);
    command.footer(
        example("  carom manual -o carom.1 && man -l carom.1") +
        "\nThe help of all commands as one page; an installed carom has it as 'man carom'.");
}

}  // namespace carom::cli
