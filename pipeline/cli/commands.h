// What the command line asked for: one struct per command, filled by command_line.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace carom::cli {

/// How a command talks.
struct TalkOptions {
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

struct MuxCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
    std::string frames;
};

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

struct BakeCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
};

struct FrameCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
    std::optional<std::int64_t> frame;
    std::string at;  // video time, "1.25s"; empty: `frame` counts, and without it frame 0
    int threads = 0;
};

/// What a shot comes to.
struct InfoCommand {
    InputOptions input;
    std::string output;     // empty: standard output
    bool resolved = false;  // the whole shot, every value with where it came from
};

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

struct CheckCommand {
    InputOptions input;
    CacheOptions cache;
    bool json = false;
    bool quick = false;  // nothing that needs a simulation
};

struct ExportCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;
    std::string events;          // a second table; empty: none
    std::optional<double> rate;  // Hz; none: the keys
};

struct ReportCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;  // empty: standard output, or with `plot` none
    bool json = false;
    std::string plot;  // a drawing, .svg or .png; empty: none
    DrawingOptions drawing;
};

struct PlanCommand {
    InputOptions input;
    CacheOptions cache;
    std::string output;  // empty: the shot's name and .svg in the current folder
    DrawingOptions drawing;
};

/// A starter for a new shot.
struct NewCommand {
    std::string shot;  // the file to write
    std::string template_name = "break";
    bool force = false;  // also over a file that is there
};

/// The JSON Schema of shots.
struct SchemaCommand {
    std::string output;  // empty: standard output
};

struct ImportCommand {
    std::string scene;   // of the older text format
    std::string output;  // empty: the scene's name and .yaml in the current folder
    double unit = 0.01;  // m
    std::string up = "y";
    double force_time = 0.05;  // s
};

/// A keyed object from a table.
struct ImportTrackCommand {
    std::string table;
    std::string output;  // empty: the table's name and .yaml in the current folder
    std::string object;  // of a table with several
    std::string name;    // of the shot's object; empty: the motion alone
    std::string error;   // "0.01 mm"
    bool linear = false;
};

/// Words for a shell.
struct CompletionCommand {
    std::string shell;   // "bash", "zsh", "fish"
    std::string output;  // empty: standard output
};

/// The manual page.
struct ManualCommand {
    std::string output;  // empty: standard output
};

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

using Command =
    std::variant<RenderCommand, RetimeCommand, BakeCommand, FrameCommand, CheckCommand,
                 ExportCommand, ReportCommand, ImportCommand, MuxCommand, CacheCommand,
                 ContactSheetCommand, InfoCommand, PlanCommand, NewCommand, SchemaCommand,
                 ImportTrackCommand, CompletionCommand, ManualCommand, CompareCommand>;

struct CommandLine {
    TalkOptions talk;
    Command command;
};

}  // namespace carom::cli
