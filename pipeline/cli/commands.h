// The commands: a struct with the options of each, and the table of all commands.
//
// A new command changes four files: this one (its struct with two functions, its row in
// kCommandTable), options/ (describe: its options and its help), a new file for run, and
// CMakeLists.txt. Parser, help, manual, completion and the choice of the program use these.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace carom::pipeline::solve {
struct AnswerWork;  // pipeline/solve/answers.h
}

namespace carom::cli {

struct CommandContext;      // run_program.h
struct CommandDescription;  // command_description.h

/// How a command prints messages.
struct LoggingOptions {
    bool quiet = false;
    bool json = false;
};

/// The shot or bake, and the changes to it.
struct InputOptions {
    std::string path;
    std::vector<std::string> overrides;  // "render.samples=64"
    std::string quality;                 // "draft", "preview", "final"; empty: the shot's own
    std::string camera_file;             // with the cameras to use; empty: the shot's own
    std::string root;  // the folder in which all files of the shot must lie; empty: anywhere
    /// What was read from standard input (standard_input.h), by its path; else null.
    std::shared_ptr<const std::map<std::string, std::string>> texts = {};
    /// How strikes of `solve` are found; set before the command runs.
    std::shared_ptr<pipeline::solve::AnswerWork> answers = {};
};

struct CacheOptions {
    std::string folder;     // empty: the default
    std::string size;       // its limit, "20 GB"; empty: the default
    bool no_store = false;  // nothing is written to it
};

/// The server of a page.
struct PageOptions {
    int port = 0;              // 0: any free port
    bool no_browser = false;   // only print the address
    std::string idle = "12h";  // the server ends when nothing happened for so long
};

/// The appearance of a plan or a plot.
struct DrawingOptions {
    std::string page = "auto";  // or "light", "dark"
    int width = 2000;           // of a .png, pixels
};

struct RenderCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;  // empty: the shot's name in the current folder
    std::string frames;  // "0-47x2"; empty: all
    std::string chunk;   // "2/8" of these: only frames, no film; empty: a film
    int threads = 0;     // 0: one per processor
    bool dry_run = false;
};
void describe(RenderCommand& command, CommandDescription& description);
void run(const RenderCommand& command, CommandContext& context);

struct MuxCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
    std::string frames;
    bool so_far = false;
};
void describe(MuxCommand& command, CommandDescription& description);
void run(const MuxCommand& command, CommandContext& context);

/// Lists, prunes or verifies the cache, or copies files from or to others.
struct CacheCommand {
    enum class Action { list, prune, verify, push, pull, merge };
    Action action = Action::list;
    CacheOptions cache;
    bool json = false;                 // list
    std::string unused_for;            // prune: "30 d"; empty: any age
    bool all = false;                  // prune
    bool features = false;             // prune: only noisy frames
    bool dry_run = false;              // prune, push, pull, merge
    bool keep = false;                 // verify: damaged files are only listed
    std::string place;                 // push, pull: the other cache, as rsync takes it
    std::vector<std::string> folders;  // merge: the other caches
    InputOptions input;                // push, pull: of a shot; path empty: all files
    std::string frames;                // of the shot
};
void describe(CacheCommand& command, CommandDescription& description);
void run(const CacheCommand& command, CommandContext& context);
/// The same if the command names a shot: only carom-film knows the keys of its frames.
void run_for_shot(const CacheCommand& command, CommandContext& context);

/// Films on a cluster. Strings are as typed.
struct FarmCommand {
    enum class Action {
        submit,
        export_job,
        list,
        status,
        frames,
        watch,
        cancel,
        change,
        logs,
        resume,
        retry,
        skip,
        prefer,
        work,
        finish
    };
    Action action = Action::submit;
    InputOptions input;
    std::string store;   // the cache that all machines share; empty: the default
    std::string output;  // submit
    std::string folder;  // export
    std::string format = "slurm";
    std::string frames;
    std::string job;  // all others: the film, the job's folder, its id or a number in the queue
    std::string partition;
    std::string account;
    std::string time;
    std::string memory = "auto";
    std::string budget;  // empty: what the format needs
    std::string dead_after = "30 s";
    int workers = 0;        // 0: as many as the film has work for
    int tasks_at_once = 0;  // 0: as many as the cluster has room for
    int processors = 1;
    std::optional<std::int64_t> priority;
    std::string exec_after;                   // a command of the shell
    std::vector<std::string> engine_options;  // after --
    bool dry_run = false;
    bool wait = false;
    bool is_shared = false;
    std::string group;                  // submit: with which the store is shared; empty: as it is
    bool json = false;                  // status, list, frames
    std::string sheet;                  // status: a picture of the film so far
    int lines = 20;                     // logs
    std::optional<std::int64_t> frame;  // logs: only of this one
    bool is_running = false;            // list: only those that have not ended
    bool only_failed = false;           // frames
    bool only_slow = false;
    bool only_missing = false;
    bool undo = false;  // skip, prefer
    PageOptions page;   // watch
};
void describe(FarmCommand& command, CommandDescription& description);
void run(const FarmCommand& command, CommandContext& context);

/// How a film is filmed again. The strings are as typed.
struct RetimeWords {
    std::string speed;  // "0.125", "1/8"
    std::string from;   // scene times
    std::string to;
    std::string ramp;    // "0s:1, 1s:1/8"
    std::string easing;  // of the ramp: "smooth", "linear"
    std::string rig;     // a camera's name
    bool reverse = false;
};

/// Films an existing shot at another speed.
struct RetimeCommand {
    RenderCommand render;
    RetimeWords retime;
};
void describe(RetimeCommand& command, CommandDescription& description);
void run(const RetimeCommand& command, CommandContext& context);

struct BakeCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
};
void describe(BakeCommand& command, CommandDescription& description);
void run(const BakeCommand& command, CommandContext& context);

struct FrameCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
    std::optional<std::int64_t> frame;
    std::string at;  // video time, "1.25s"; empty: `frame`, or frame 0 without it
    int threads = 0;
};
void describe(FrameCommand& command, CommandDescription& description);
void run(const FrameCommand& command, CommandContext& context);

/// Prints a summary of a shot.
struct InfoCommand {
    InputOptions input;
    std::string output;     // empty: standard output
    bool resolved = false;  // print the whole shot, every value with its origin
};
void describe(InfoCommand& command, CommandDescription& description);
void run(const InfoCommand& command, CommandContext& context);

/// Renders frames of a film side by side into one picture.
struct ContactSheetCommand {
    InputOptions input;  // quality empty: draft
    CacheOptions cache;
    std::string output;  // empty: the shot's name and _sheet.png in the current folder
    int count = 12;
    int columns = 4;
    int width = 320;  // of one picture, pixels
    int threads = 0;
};
void describe(ContactSheetCommand& command, CommandDescription& description);
void run(const ContactSheetCommand& command, CommandContext& context);

struct CheckCommand {
    InputOptions input;
    CacheOptions cache;
    bool json = false;
    bool quick = false;  // skip checks that need a simulation
    bool full = false;   // read also large files whole
    bool lux = false;    // print the light on the table
};
void describe(CheckCommand& command, CommandDescription& description);
void run(const CheckCommand& command, CommandContext& context);

struct ExportCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
    std::string events;          // a table of events; empty: none
    std::string contacts;        // a table of lasting contacts; empty: none
    std::optional<double> rate;  // Hz; empty: the keys of each track
    std::string only;            // comma-separated parts of a .json; empty: all
    std::string without;         // comma-separated parts
};
void describe(ExportCommand& command, CommandDescription& description);
void run(const ExportCommand& command, CommandContext& context);

struct ReportCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;  // empty: standard output, or with `plot` none
    bool json = false;
    // What is wanted of it; all but the last as typed.
    std::string only;     // comma-separated words
    std::string without;  // comma-separated words
    std::vector<std::string> objects;
    std::string from;  // scene times
    std::string to;
    std::string min_impulse;    // "0.01 N s"
    bool every_impact = false;  // not one line for many of the same two
    std::string plot;           // a drawing, .svg or .png; empty: none
    DrawingOptions drawing;
};
void describe(ReportCommand& command, CommandDescription& description);
void run(const ReportCommand& command, CommandContext& context);

/// Finds strikes by what they shall bring about.
struct SolveCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;   // the shot with the strike that was found; empty: not written
    bool writes = false;  // it into the shot's own file
    bool lists_all = false;
    bool json = false;
    std::string map;  // drawings, .svg or .png; empty: none
    std::string plans;
    DrawingOptions drawing;
};
void describe(SolveCommand& command, CommandDescription& description);
void run(const SolveCommand& command, CommandContext& context);

/// Simulates variants of a shot and measures them. Strings are as typed.
struct SweepCommand {
    InputOptions input;
    std::vector<std::string> vary;
    std::vector<std::string> measures;
    bool lists_measures = false;
    std::optional<std::int64_t> samples;
    std::string sampling = "sobol";
    std::int64_t seed = 0;
    std::string output;  // .csv or .jsonl; empty: standard output, or with `plot` none
    std::string plot;    // a drawing, .svg or .png; empty: none
    DrawingOptions drawing;
    int threads = 0;
};
void describe(SweepCommand& command, CommandDescription& description);
void run(const SweepCommand& command, CommandContext& context);

struct PlanCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;  // empty: the shot's name and .svg in the current folder
    DrawingOptions drawing;
};
void describe(PlanCommand& command, CommandDescription& description);
void run(const PlanCommand& command, CommandContext& context);

/// Writes the sound of a film, without its pictures.
struct SoundCommand {
    InputOptions input;
    CacheOptions cache;
    RetimeWords retime;
    std::string output;  // empty: the shot's name and .wav, unless other results are wanted
    std::string stems;   // a folder for a file of each group; empty: none
    std::string heard;   // a table; empty: none
    bool report = false;
};
void describe(SoundCommand& command, CommandDescription& description);
void run(const SoundCommand& command, CommandContext& context);
/// Whether the file is not a .wav: only carom-film has the encoders.
[[nodiscard]] bool needs_encoder(const SoundCommand& command);

/// Writes a new shot from a template.
struct NewCommand {
    std::string shot;  // the file to write
    std::string template_name = "break";
    bool force = false;  // overwrite an existing file
};
void describe(NewCommand& command, CommandDescription& description);
void run(const NewCommand& command, CommandContext& context);

/// Prints the JSON Schema of shots.
struct SchemaCommand {
    std::string output;  // empty: standard output
};
void describe(SchemaCommand& command, CommandDescription& description);
void run(const SchemaCommand& command, CommandContext& context);

/// Converts a scene to a shot, or a mesh with materials to objects.
struct ImportCommand {
    std::string scene;           // in the older text format, or an OBJ or PLY file
    std::string output;          // empty: the scene's name and .yaml in the current folder
    std::optional<double> unit;  // m; empty: 0.01 of a scene, 1 of a mesh
    std::string up = "y";
    std::string fov = "distance";
    std::string boxes = "auto";
    double force_time = 0.05;  // s
};
void describe(ImportCommand& command, CommandDescription& description);
void run(const ImportCommand& command, CommandContext& context);

/// Converts a table of motion to a keyed object.
struct ImportTrackCommand {
    std::string table;
    std::string output;  // empty: the table's name and .yaml in the current folder
    std::string object;  // to import from a table with several objects
    std::string name;    // of the shot's object; empty: write only the motion
    std::string error;   // "0.01 mm"
    bool linear = false;
};
void describe(ImportTrackCommand& command, CommandDescription& description);
void run(const ImportTrackCommand& command, CommandContext& context);

/// Shows a shot in a browser while it is edited.
struct StudioCommand {
    InputOptions input;  // of a shot
    CacheOptions cache;
    PageOptions page;
    std::string output;  // folder of films and exports; empty: that of the shot
};
void describe(StudioCommand& command, CommandDescription& description);
void run(const StudioCommand& command, CommandContext& context);

/// Prints a shell completion script.
struct CompletionCommand {
    std::string shell;   // "bash", "zsh", "fish"
    std::string output;  // empty: standard output
};
void describe(CompletionCommand& command, CommandDescription& description);
void run(const CompletionCommand& command, CommandContext& context);

/// Compares acceleration structures or triangle kernels. The strings are as typed.
struct CompareCommand {
    InputOptions input;  // path empty: `scene`
    CacheOptions cache;
    std::string scene;                   // a scene of the laboratory
    std::string triangles;               // comma-separated kernels; empty: compare structures
    std::string techniques;              // for `triangles`, comma-separated
    std::string compilers = "own";       // for `triangles`: or "both"
    int rounds = 5;                      // for `triangles`
    std::string growth;                  // instead of one frame: "spheres", "mesh"
    std::int64_t largest = 1'000'000;    // number of shapes for `growth`
    std::string lanes;                   // comma-separated, for `growth`; empty: the processor's
    std::optional<std::int64_t> motion;  // instead of one frame: this number of balls
    std::string intervals;               // of the shutter, comma-separated, for `motion`
    std::string leaf_capacity;           // comma-separated numbers; empty: the structures' own
    std::string node_capacity;
    std::string grid_density;
    std::string kernel;  // comma-separated triangle tests of the structures; empty: the renderer's
    std::string accelerators = "all";   // comma-separated names
    std::string shadow_rays = "any";    // or "closest", "both"
    std::optional<std::int64_t> frame;  // of a shot
    std::string size;                   // "320x240"; empty: the scene's own
    std::string output;                 // empty: standard output
    bool json = false;
    std::string csv;   // a table; empty: none
    std::string plot;  // a drawing, .svg or .png; empty: none
    DrawingOptions drawing;
    int threads = 0;
};
void describe(CompareCommand& command, CommandDescription& description);
void run(const CompareCommand& command, CommandContext& context);

/// The headings of the help.
enum class Group { make, look, film, keep, tools };

/// The program that runs a command: bin/carom itself, or one in libexec/carom, which it executes:
/// carom-film, carom-lab or carom-studio.
enum class Program { carom, film, lab, studio };

template <class T>
struct CommandRow {
    const char* name;
    Group group;
    Program program;
    const char* summary;  // a sentence
};

/// All commands in the order of the help. The first lines of this file explain how to add one.
inline constexpr std::tuple kCommandTable{
    CommandRow<NewCommand>{"new", Group::make, Program::carom,
                           "Write a commented shot to start from."},
    CommandRow<CheckCommand>{"check", Group::make, Program::carom,
                             "Report every problem of a shot, with its line."},
    CommandRow<ImportCommand>{
        "import", Group::make, Program::carom,
        "Convert a scene of the older text format to a shot, or a mesh with materials to objects."},
    CommandRow<ImportTrackCommand>{"import-track", Group::make, Program::carom,
                                   "Convert a CSV table of motion to a keyed object."},
    CommandRow<StudioCommand>{"studio", Group::make, Program::studio,
                              "Edit a shot in a browser and see at once how it runs."},
    CommandRow<PlanCommand>{"plan", Group::look, Program::carom,
                            "Draw the table from above, with all paths and events."},
    CommandRow<FrameCommand>{"frame", Group::look, Program::film, "Render a single frame."},
    CommandRow<ContactSheetCommand>{"contact-sheet", Group::look, Program::film,
                                    "Render frames of the whole film into one picture."},
    CommandRow<InfoCommand>{"info", Group::look, Program::carom,
                            "Print a summary of a shot, or every value of it."},
    CommandRow<ReportCommand>{"report", Group::look, Program::carom,
                              "Print the events, speeds and energy of a shot."},
    CommandRow<SolveCommand>{"solve", Group::look, Program::carom,
                             "Find the strike that does what the shot wants."},
    CommandRow<SweepCommand>{"sweep", Group::look, Program::carom,
                             "Vary values of a shot and measure what changes."},
    CommandRow<RenderCommand>{"render", Group::film, Program::film,
                              "Simulate a shot, render its frames and write the film."},
    CommandRow<RetimeCommand>{"retime", Group::film, Program::film,
                              "Film a shot again: slower, backwards, or a part of it."},
    CommandRow<MuxCommand>{"mux", Group::film, Program::film,
                           "Write a film from frames that are already rendered."},
    CommandRow<SoundCommand>{"sound", Group::film, Program::carom,
                             "Write the sound of a film, or a list of what is heard."},
    CommandRow<FarmCommand>{"farm", Group::film, Program::film,
                            "Render a film on a Slurm cluster, and follow it."},
    CommandRow<BakeCommand>{"bake", Group::keep, Program::carom,
                            "Simulate a shot and write its motion to a bake file."},
    CommandRow<ExportCommand>{"export", Group::keep, Program::carom,
                              "Write the motion as .csv or .json, the scene as .glb or .usda."},
    CommandRow<CacheCommand>{"cache", Group::keep, Program::carom,
                             "List, prune, verify or copy the cache of bakes and frames."},
    CommandRow<CompareCommand>{"compare", Group::tools, Program::lab,
                               "Measure acceleration structures or ray-triangle tests."},
    CommandRow<SchemaCommand>{"schema", Group::tools, Program::carom,
                              "Print the JSON Schema of shots, for editors."},
    CommandRow<CompletionCommand>{"completion", Group::tools, Program::carom,
                                  "Print a completion script for a shell."},
};

template <class... T>
std::variant<T...> one_of(const std::tuple<CommandRow<T>...>&);

/// A variant of all commands of the table.
using Command = decltype(one_of(kCommandTable));

template <class T>
constexpr CommandRow<T> kRowOf = std::get<CommandRow<T>>(kCommandTable);

[[nodiscard]] inline Program program_of(const Command& command) {
    const auto* cache = std::get_if<CacheCommand>(&command);
    if (cache != nullptr && !cache->input.path.empty()) {
        return Program::film;
    }
    const auto* farm = std::get_if<FarmCommand>(&command);
    if (farm != nullptr && farm->action == FarmCommand::Action::watch) {
        return Program::studio;
    }
    const auto* sound = std::get_if<SoundCommand>(&command);
    if (sound != nullptr && needs_encoder(*sound)) {
        return Program::film;
    }
    return std::visit([]<class T>(const T&) { return kRowOf<T>.program; }, command);
}

struct CommandLine {
    LoggingOptions logging;
    Command command;
};

}  // namespace carom::cli
