#include "pipeline/cli/command_line.h"

#include <cstdio>
#include <memory>
#include <sstream>

#include <CLI/CLI.hpp>

#include "pipeline/cli/exit_code.h"
#include "pipeline/cli/help/option_table.h"
#include "pipeline/cli/help_formatter.h"

namespace carom::cli {

namespace {

// The help begins with what most people came for.
constexpr const char* kFirstLines =
    "  carom render shot.yaml -o film.mp4     simulate, render and encode a shot\n"
    "  carom check shot.yaml                  say everything that is wrong with it\n"
    "  carom frame shot.yaml --at 1.5s        one picture of it\n";

constexpr const char* kLastLines =
    "Results go to standard output, all talk to standard error.\n"
    "Exit codes: 0 done, 1 failed while running, 2 wrong usage or input,\n"
    "130 interrupted.\n"
    "'carom COMMAND --help' explains a command.";

std::string example(const char* lines) {
    return std::string("Example:\n") + lines;
}

/// Everything that the options write to.
struct Targets {
    TalkOptions talk;
    std::string log = "text";
    RenderCommand render;
    RetimeCommand retime;
    BakeCommand bake;
    FrameCommand frame;
    ContactSheetCommand sheet;
    InfoCommand info;
    CheckCommand check;
    ExportCommand export_;
    ReportCommand report;
    ImportCommand import_;
    ImportTrackCommand import_track;
    CompletionCommand completion;
    ManualCommand manual;
    MuxCommand mux;
    CacheCommand cache;
    PlanCommand plan;
    NewCommand new_;
    SchemaCommand schema;
};

void add_input(CLI::App& app, InputOptions& input, const char* name, const char* what) {
    app.add_option(name, input.path, what)->required()->option_text(" ");
    app.add_option("--set", input.overrides,
                   "change a value of the shot, by its path: --set render.samples=64; may be "
                   "repeated")
        ->option_text("KEY=VALUE")
        ->allow_extra_args(false);
    app.add_option("--quality", input.quality, "a preset: draft, preview or final")
        ->option_text("NAME");
}

void add_camera_file(CLI::App& app, InputOptions& input) {
    app.add_option("--camera", input.camera_file,
                   "a file whose 'cameras' film instead of the shot's; it may change 'render', "
                   "'output', 'lights' and 'materials', too")
        ->option_text("FILE");
}

void add_talk(CLI::App& app, Targets& targets) {
    app.add_flag("--quiet,-q", targets.talk.quiet, "only errors and warnings");
    app.add_option("--log", targets.log, "how to talk: text, or json for one object per line")
        ->option_text("FORMAT")
        ->check(CLI::IsMember({"text", "json"}));
}

void add_cache(CLI::App& app, CacheOptions& cache) {
    app.add_option("--cache", cache.folder,
                   "where bakes and finished frames are kept (else $CAROM_CACHE, "
                   "$XDG_CACHE_HOME/carom, ~/.cache/carom)")
        ->option_text("FOLDER");
}

void add_cache_size(CLI::App& app, CacheOptions& cache) {
    app.add_option("--cache-size", cache.size,
                   "how large it may grow: 500 MB, 20 GB, none (else $CAROM_CACHE_SIZE, 20 GB); "
                   "what was used longest ago goes first")
        ->option_text("SIZE");
}

void add_frames(CLI::App& app, std::string& frames) {
    app.add_option("--frames", frames,
                   "only these, counted from 0: 0-47, every second one 0-47x2, several 0-9,20")
        ->option_text("RANGE");
}

void add_dry_run(CLI::App& app, bool& dry_run) {
    app.add_flag("--dry-run", dry_run,
                 "only say which frames are there and which would be rendered");
}

void add_threads(CLI::App& app, int& threads) {
    app.add_option("--threads", threads, "for rendering; 0: one per processor")
        ->option_text("N")
        ->check(CLI::Range(0, 1024));
}

void add_output(CLI::App& app, std::string& output, const char* what) {
    app.add_option("-o,--output", output, what)->option_text("FILE");
}

void add_drawing(CLI::App& app, DrawingOptions& drawing) {
    app.add_option("--page", drawing.page,
                   "what a drawing is read on: auto (as the browser prefers), light or dark")
        ->option_text("NAME")
        ->check(CLI::IsMember({"auto", "light", "dark"}));
    app.add_option("--width", drawing.width, "of a .png, in pixels (default 2000)")
        ->option_text("N")
        ->check(CLI::Range(100, 16000));
}

void add_render(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("render", "simulate, render and encode a shot");
    RenderCommand& render = targets.render;
    add_input(command, render.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_camera_file(command, render.input);
    add_output(
        command, render.output,
        "the film: .mp4, .mov, .mkv, .webm, or pictures: shot.####.exr (else the shot's name "
        "in the current folder)");
    add_frames(command, render.frames);
    command
        .add_option("--chunk", render.chunk,
                    "one of several machines' share of them, 2/8: renders and keeps its frames, "
                    "writes no film; 'carom mux' does when all are there")
        ->option_text("K/N");
    add_dry_run(command, render.dry_run);
    add_threads(command, render.threads);
    add_cache(command, render.cache);
    add_cache_size(command, render.cache);
    add_talk(command, targets);
    command.footer(example("  carom render break.yaml --quality draft -o try.mp4\n") +
                   "\nFinished frames are kept: a run that was interrupted goes on where it was\n"
                   "when it is repeated, and a film that changes in part renders only that part.");
}

void add_retime_times(CLI::App& command, RetimeCommand& retime) {
    command
        .add_option("--speed", retime.speed,
                    "seconds of the scene per second of film: 0.125 or 1/8 (else as it was)")
        ->option_text("RATIO");
    command.add_option("--from", retime.from, "scene time to begin with (else all is shown)")
        ->option_text("TIME");
    command.add_option("--to", retime.to, "scene time to end with")->option_text("TIME");
    command.add_flag("--reverse", retime.reverse, "backwards");
    command
        .add_option("--ramp", retime.ramp,
                    "changing speed: film times and speeds, 0s:1,1s:1/8,3s:1/8,4s:1; the last "
                    "time is the film's length")
        ->option_text("T:V,...");
    command.add_option("--easing", retime.easing, "of the ramp: smooth (the default) or linear")
        ->option_text("NAME")
        ->check(CLI::IsMember({"smooth", "linear"}));
    command.add_option("--rig", retime.rig, "show only what this camera of the shot films")
        ->option_text("NAME");
}

void add_retime(CLI::App& app, Targets& targets) {
    CLI::App& command =
        *app.add_subcommand("retime", "film a shot again: slower, backwards, a part of it");
    RetimeCommand& retime = targets.retime;
    RenderCommand& render = retime.render;
    add_input(command, render.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_retime_times(command, retime);
    add_camera_file(command, render.input);
    add_output(command, render.output,
               "the film (else the shot's name and _retimed in the current folder)");
    add_frames(command, render.frames);
    add_dry_run(command, render.dry_run);
    add_threads(command, render.threads);
    add_cache(command, render.cache);
    add_cache_size(command, render.cache);
    add_talk(command, targets);
    command.footer(
        example("  carom retime break.yaml --speed 1/8 --from 1.2s --to 2s -o slow.mp4\n"
                "  carom retime break.bake --reverse -o back.mp4\n") +
        "\nThe cameras go the ways that they went in the film. A shot whose bake was kept\n"
        "is not simulated again, and frames that the film had are not rendered again.");
}

void add_bake(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("bake", "simulate a shot, without a picture");
    add_input(command, targets.bake.input, "SHOT", "a shot");
    add_output(command, targets.bake.output, "else the shot's name and .bake");
    add_cache(command, targets.bake.cache);
    add_talk(command, targets);
    command.footer(example("  carom bake break.yaml -o break.bake"));
}

void add_frame(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("frame", "render one frame of a shot");
    FrameCommand& frame = targets.frame;
    add_input(command, frame.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_camera_file(command, frame.input);
    CLI::Option* number =
        command.add_option("--frame", frame.frame, "its number, counted from 0 (the default)")
            ->option_text("N")
            ->check(CLI::NonNegativeNumber);
    command.add_option("--at", frame.at, "or its time in the film: 1.25s, 500ms")
        ->option_text("TIME")
        ->excludes(number);
    add_output(command, frame.output,
               "the picture: .png, .jpg, .bmp or .tga as the film shows it, .exr as it was "
               "computed (else the shot's name, the frame's number and .png)");
    add_threads(command, frame.threads);
    add_cache(command, frame.cache);
    add_talk(command, targets);
    command.footer(example("  carom frame break.yaml --at 1.25s -o contact.png"));
}

void add_contact_sheet(CLI::App& app, Targets& targets) {
    CLI::App& command =
        *app.add_subcommand("contact-sheet", "a film at a glance: frames of it in a grid");
    ContactSheetCommand& sheet = targets.sheet;
    add_input(command, sheet.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_camera_file(command, sheet.input);
    add_output(command, sheet.output,
               "the picture: .png, .jpg, .bmp or .tga (else the shot's name and _sheet.png)");
    command.add_option("--count", sheet.count, "how many frames, evenly spread (default 12)")
        ->option_text("N")
        ->check(CLI::Range(1, 400));
    command.add_option("--columns", sheet.columns, "side by side (default 4)")
        ->option_text("N")
        ->check(CLI::Range(1, 40));
    command.add_option("--width", sheet.width, "of each, in pixels (default 320)")
        ->option_text("N")
        ->check(CLI::Range(32, 2000));
    add_threads(command, sheet.threads);
    add_cache(command, sheet.cache);
    add_talk(command, targets);
    command.footer(example("  carom contact-sheet break.yaml -o sheet.png") +
                   "\nDraft frames unless --quality says otherwise, each with its number, the\n"
                   "time that it shows and its camera. They are kept like those of a film.");
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
        ->check(CLI::PositiveNumber);
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

void add_new(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("new", "write a starter for a shot");
    NewCommand& new_ = targets.new_;
    command.add_option("SHOT", new_.shot, "the file to write; - is standard output")
        ->required()
        ->option_text(" ");
    command
        .add_option("--template", new_.template_name,
                    "break (the default), trick, bank, massé (or masse), jump, dominoes, empty")
        ->option_text("NAME")
        ->check(CLI::IsMember(
            {"break", "trick", "bank", "massé", "masse", "jump", "dominoes", "empty"}));
    command.add_flag("--force", new_.force, "also over a file that is there");
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

void add_mux(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("mux", "write a film from frames that are stored");
    MuxCommand& mux = targets.mux;
    add_input(command, mux.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_camera_file(command, mux.input);
    add_output(
        command, mux.output,
        "the film: .mp4, .mov, .mkv, .webm, or pictures: shot.####.exr (else the shot's name "
        "in the current folder)");
    add_frames(command, mux.frames);
    add_cache(command, mux.cache);
    add_talk(command, targets);
    command.footer(example("  carom render break.yaml --chunk 1/2 && carom render break.yaml "
                           "--chunk 2/2\n  carom mux break.yaml -o break.mp4") +
                   "\nRenders nothing: frames that are missing are named, with exit code 1.");
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

Command chosen_command(const CLI::App& app, Targets& targets) {
    const std::string name = app.get_subcommands().front()->get_name();
    if (name == "render") {
        return std::move(targets.render);
    }
    if (name == "retime") {
        return std::move(targets.retime);
    }
    if (name == "bake") {
        return std::move(targets.bake);
    }
    if (name == "frame") {
        return std::move(targets.frame);
    }
    if (name == "info") {
        return std::move(targets.info);
    }
    if (name == "contact-sheet") {
        return std::move(targets.sheet);
    }
    if (name == "check") {
        return std::move(targets.check);
    }
    if (name == "report") {
        return std::move(targets.report);
    }
    if (name == "new") {
        return std::move(targets.new_);
    }
    if (name == "schema") {
        return std::move(targets.schema);
    }
    if (name == "plan") {
        return std::move(targets.plan);
    }
    if (name == "mux") {
        return std::move(targets.mux);
    }
    if (name == "cache") {
        return std::move(targets.cache);
    }
    if (name == "import") {
        return std::move(targets.import_);
    }
    if (name == "completion") {
        return std::move(targets.completion);
    }
    if (name == "manual") {
        return std::move(targets.manual);
    }
    if (name == "import-track") {
        return std::move(targets.import_track);
    }
    return std::move(targets.export_);
}

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

/// The whole table; parsing fills `targets`, which outlives it.
std::unique_ptr<CLI::App> make_app(Targets& targets) {
    auto owned = std::make_unique<CLI::App>(kFirstLines, "carom");
    CLI::App& app = *owned;
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_help_flag("-h,--help", "print this help");
    app.set_version_flag("--version", "carom " CAROM_VERSION, "print the version");
    app.require_subcommand(1);
    app.footer(kLastLines);
    add_render(app, targets);
    add_retime(app, targets);
    add_bake(app, targets);
    add_frame(app, targets);
    add_contact_sheet(app, targets);
    add_check(app, targets);
    add_info(app, targets);
    add_export(app, targets);
    add_report(app, targets);
    add_plan(app, targets);
    add_new(app, targets);
    add_schema(app, targets);
    add_import(app, targets);
    add_import_track(app, targets);
    add_mux(app, targets);
    add_cache_actions(app, targets);
    add_completion(app, targets);
    add_manual(app, targets);
    return owned;
}

/// "{text,json}", as IsMember describes itself, as words; empty for other checks.
std::vector<std::string> choices_of(const CLI::Option& option) {
    const std::string name = option.get_name(false, false);
    if (name == "--quality") {
        return {"draft", "preview", "final"};  // what configs/quality has; others may be added
    }
    std::string text;
    try {
        text = const_cast<CLI::Option&>(option).get_validator()->get_description();
    } catch (const CLI::OptionNotFound&) {
        return {};  // it has none
    }
    std::vector<std::string> words;
    if (text.starts_with('{') && text.ends_with('}')) {
        std::istringstream list(text.substr(1, text.size() - 2));
        for (std::string word; std::getline(list, word, ',');) {
            words.push_back(word);
        }
    }
    return words;
}

CommandInfo describe(const CLI::App& app) {
    CommandInfo command{app.get_name(), app.get_description(), app.get_footer(), {}, {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        const std::string description = option->get_description();
        if (option->get_positional()) {
            command.arguments.push_back(
                {option->get_name(true, false), description, choices_of(*option)});
            continue;
        }
        OptionInfo info;
        info.long_name = "--" + option->get_lnames().front();
        if (!option->get_snames().empty()) {
            info.short_name = "-" + option->get_snames().front();
        }
        info.value = option->get_option_text();
        info.description = description;
        info.choices = choices_of(*option);
        command.options.push_back(std::move(info));
    }
    for (const CLI::App* below : app.get_subcommands({})) {
        command.commands.push_back(describe(*below));
    }
    return command;
}

}  // namespace

CommandInfo describe_command_line() {
    Targets targets;
    return describe(*make_app(targets));
}

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
