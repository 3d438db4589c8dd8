// The commands: what each was asked to do, and the one table of all of them.
//
// A new command touches four files: this one (its struct with two functions, its row in
// kCommandTable), options/ (describe: its options and its help), a file for run, and
// CMakeLists.txt. Parser, help, manual, completion and the choice of the program follow from these.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace carom::cli {

struct CommandContext;      // run_program.h
struct CommandDescription;  // command_description.h

/// How a command talks.
struct LoggingOptions {
    bool quiet = false;
    bool json = false;
};

/// The shot or bake, and what is changed in it.
struct InputOptions {
    std::string path;
    std::vector<std::string> overrides;  // "render.samples=64"
    std::string quality;                 // "draft", "preview", "final"; empty: the shot's own
    std::string camera_file;             // whose cameras film instead; empty: the shot's own
    std::string root;  // the folder below which all files lie that the shot names; empty: anywhere
};

struct CacheOptions {
    std::string folder;  // empty: the usual one
    std::string size;    // its limit, "20 GB"; empty: the usual one
};

/// How a plan or a plot looks.
struct DrawingOptions {
    std::string page = "auto";  // or "light", "dark"
    int width = 2000;           // of a .png, pixels
};

struct RenderCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;  // empty: the shot's name in the current folder
    std::string frames;  // "0-47x2"; empty: all
    std::string chunk;   // "2/8" of these: frames alone, no film; empty: a film
    int threads = 0;     // 0: as many as there are processors
    bool dry_run = false;
};
void describe(RenderCommand& command, CommandDescription& description);
void run(const RenderCommand& command, CommandContext& context);

struct MuxCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
    std::string frames;
};
void describe(MuxCommand& command, CommandDescription& description);
void run(const MuxCommand& command, CommandContext& context);

/// What is in the cache, and what of it goes.
struct CacheCommand {
    enum class Action { list, prune, verify };
    Action action = Action::list;
    CacheOptions cache;
    bool json = false;       // list
    std::string unused_for;  // prune: "30 d"; empty: whatever its age
    bool all = false;        // prune
    bool dry_run = false;    // prune
    bool keep = false;       // verify: damaged files are only named
};
void describe(CacheCommand& command, CommandDescription& description);
void run(const CacheCommand& command, CommandContext& context);

/// The film of an existing shot at another speed. Texts as they were typed.
struct RetimeCommand {
    RenderCommand render;
    std::string speed;  // "0.125", "1/8"
    std::string from;   // scene times
    std::string to;
    std::string ramp;    // "0s:1, 1s:1/8"
    std::string easing;  // of the ramp: "smooth", "linear"
    std::string rig;     // a camera's name
    bool reverse = false;
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
    std::string at;  // video time, "1.25s"; empty: `frame` counts, and without it frame 0
    int threads = 0;
};
void describe(FrameCommand& command, CommandDescription& description);
void run(const FrameCommand& command, CommandContext& context);

/// What a shot comes to.
struct InfoCommand {
    InputOptions input;
    std::string output;     // empty: standard output
    bool resolved = false;  // the whole shot, every value with where it came from
};
void describe(InfoCommand& command, CommandDescription& description);
void run(const InfoCommand& command, CommandContext& context);

/// Frames of a film side by side.
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
    bool quick = false;  // nothing that needs a simulation
};
void describe(CheckCommand& command, CommandDescription& description);
void run(const CheckCommand& command, CommandContext& context);

struct ExportCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
    std::string events;          // a second table; empty: none
    std::optional<double> rate;  // Hz; none: the keys
};
void describe(ExportCommand& command, CommandDescription& description);
void run(const ExportCommand& command, CommandContext& context);

struct ReportCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;  // empty: standard output, or with `plot` none
    bool json = false;
    std::string plot;  // a drawing, .svg or .png; empty: none
    DrawingOptions drawing;
};
void describe(ReportCommand& command, CommandDescription& description);
void run(const ReportCommand& command, CommandContext& context);

struct PlanCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;  // empty: the shot's name and .svg in the current folder
    DrawingOptions drawing;
};
void describe(PlanCommand& command, CommandDescription& description);
void run(const PlanCommand& command, CommandContext& context);

/// A starter for a new shot.
struct NewCommand {
    std::string shot;  // the file to write
    std::string template_name = "break";
    bool force = false;  // also over a file that is there
};
void describe(NewCommand& command, CommandDescription& description);
void run(const NewCommand& command, CommandContext& context);

/// The JSON Schema of shots.
struct SchemaCommand {
    std::string output;  // empty: standard output
};
void describe(SchemaCommand& command, CommandDescription& description);
void run(const SchemaCommand& command, CommandContext& context);

struct ImportCommand {
    std::string scene;   // of the older text format
    std::string output;  // empty: the scene's name and .yaml in the current folder
    double unit = 0.01;  // m
    std::string up = "y";
    double force_time = 0.05;  // s
};
void describe(ImportCommand& command, CommandDescription& description);
void run(const ImportCommand& command, CommandContext& context);

/// A keyed object from a table.
struct ImportTrackCommand {
    std::string table;
    std::string output;  // empty: the table's name and .yaml in the current folder
    std::string object;  // of a table with several
    std::string name;    // of the shot's object; empty: the motion alone
    std::string error;   // "0.01 mm"
    bool linear = false;
};
void describe(ImportTrackCommand& command, CommandDescription& description);
void run(const ImportTrackCommand& command, CommandContext& context);

/// The script that completes in a shell.
struct CompletionCommand {
    std::string shell;   // "bash", "zsh", "fish"
    std::string output;  // empty: standard output
};
void describe(CompletionCommand& command, CommandDescription& description);
void run(const CompletionCommand& command, CommandContext& context);

/// Acceleration structures against each other. Texts as they were typed.
struct CompareCommand {
    InputOptions input;  // path empty: `scene`
    CacheOptions cache;
    std::string scene;                  // one of the laboratory's
    std::string triangles;              // kernels with commas between; empty: structures
    int rounds = 5;                     // of triangles
    std::string growth;                 // instead of one frame: "spheres", "mesh"
    std::int64_t largest = 1'000'000;   // of `growth`
    std::string accelerators = "all";   // names with commas between
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

/// Headings of the help.
enum class Group { make, look, film, keep, tools };

/// The program that runs a command: bin/carom becomes libexec/carom/carom-film or carom-lab.
enum class Program { carom, film, lab };

template <class T>
struct CommandRow {
    const char* name;
    Group group;
    Program program;
    const char* summary;  // a sentence
};

/// In the order of the help. Who adds a command reads the first lines of this file.
inline constexpr std::tuple kCommandTable{
    CommandRow<NewCommand>{"new", Group::make, Program::carom,
                           "Write a commented shot to start from."},
    CommandRow<CheckCommand>{"check", Group::make, Program::carom,
                             "Report every problem of a shot, with its line."},
    CommandRow<ImportCommand>{"import", Group::make, Program::carom,
                              "Convert a scene of the older text format to a shot."},
    CommandRow<ImportTrackCommand>{"import-track", Group::make, Program::carom,
                                   "Convert a table of motion to a keyed object."},
    CommandRow<PlanCommand>{"plan", Group::look, Program::carom,
                            "Draw the table from above, with all paths and events."},
    CommandRow<FrameCommand>{"frame", Group::look, Program::film, "Render a single frame."},
    CommandRow<ContactSheetCommand>{"contact-sheet", Group::look, Program::film,
                                    "Render frames of the whole film into one picture."},
    CommandRow<InfoCommand>{"info", Group::look, Program::carom,
                            "Print a summary of a shot, or every value of it."},
    CommandRow<ReportCommand>{"report", Group::look, Program::carom,
                              "Print what happens in a shot, in numbers."},
    CommandRow<RenderCommand>{"render", Group::film, Program::film,
                              "Simulate a shot, render its frames and write the film."},
    CommandRow<RetimeCommand>{"retime", Group::film, Program::film,
                              "Film a shot again: slower, backwards, or a part of it."},
    CommandRow<MuxCommand>{"mux", Group::film, Program::film,
                           "Write a film from frames that are already rendered."},
    CommandRow<BakeCommand>{"bake", Group::keep, Program::carom,
                            "Simulate a shot and keep its motion in a file."},
    CommandRow<ExportCommand>{"export", Group::keep, Program::carom,
                              "Write the motion as .csv or .json, the scene as .glb or .usda."},
    CommandRow<CacheCommand>{"cache", Group::keep, Program::carom,
                             "List, prune or verify the kept bakes and frames."},
    CommandRow<CompareCommand>{"compare", Group::tools, Program::lab,
                               "Measure acceleration structures or ray-triangle tests."},
    CommandRow<SchemaCommand>{"schema", Group::tools, Program::carom,
                              "Print the JSON Schema of shots, for editors."},
    CommandRow<CompletionCommand>{"completion", Group::tools, Program::carom,
                                  "Print the script that completes carom's words in a shell."},
};

template <class... T>
std::variant<T...> one_of(const std::tuple<CommandRow<T>...>&);

/// Any of the table's commands.
using Command = decltype(one_of(kCommandTable));

template <class T>
constexpr CommandRow<T> kRowOf = std::get<CommandRow<T>>(kCommandTable);

[[nodiscard]] inline Program program_of(const Command& command) {
    return std::visit([]<class T>(const T&) { return kRowOf<T>.program; }, command);
}

struct CommandLine {
    LoggingOptions logging;
    Command command;
};

}  // namespace carom::cli
