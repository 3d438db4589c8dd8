#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

void add_input(CommandDescription& description, InputOptions& input) {
    description
        .argument(
            "SHOT|BAKE", input.path,
            "A shot, or a bake, which is a shot that is already simulated; - reads either from "
            "standard input, and files that it names are then those of the current folder.")
        .offers(Offer::files, {"yaml", "yml", "bake"});
}

void add_changes(CommandDescription& description, InputOptions& input) {
    description
        .option("--set", &input.overrides, "KEY=VALUE",
                "Change a value of the shot, given by its path: --set render.samples=64. The "
                "option may be repeated.")
        .offers(Offer::keys);
    description
        .option("--quality", &input.quality, "NAME",
                "Use a preset: draft, preview or final. It keeps the aspect ratio of the picture.")
        .offers(Offer::presets);
    description
        .option("--root", &input.root, "FOLDER",
                "Reject a shot that names files outside this folder, after symbolic links are "
                "resolved. carom's own tables, looks and rigs are allowed.")
        .offers(Offer::folders)
        .must_be_folder = true;
}

void add_camera_file(CommandDescription& description, InputOptions& input) {
    description
        .option("--camera", &input.camera_file, "FILE",
                "Use the 'cameras' of this file instead of the shot's. The file may also change "
                "'render', 'output', 'lights' and 'materials'.")
        .offers(Offer::files, {"yaml", "yml"});
}

void add_cache(CommandDescription& description, CacheOptions& cache) {
    description
        .option("--cache", &cache.folder, "FOLDER",
                "The folder for bakes, finished frames and strikes that were found. The default is "
                "$CAROM_CACHE, else $XDG_CACHE_HOME/carom, else ~/.cache/carom.")
        .offers(Offer::folders);
}

void add_no_store(CommandDescription& description, CacheOptions& cache) {
    description.flag(
        "--no-store", cache.no_store,
        "Write nothing to the cache, which may be read-only or missing: an interrupted "
        "command starts anew. Frames and bakes that the cache has are still used.");
}

void add_cache_size(CommandDescription& description, CacheOptions& cache) {
    description.option("--cache-size", &cache.size, "SIZE",
                       "The limit of the size of the cache: 500 MB, 20 GB or none. The least "
                       "recently used files are removed first. The default is $CAROM_CACHE_SIZE, "
                       "else 20 GB.");
}

void add_frames(CommandDescription& description, std::string& frames) {
    description.option("--frames", &frames, "RANGE",
                       "Use only these frames, counted from 0: a range (0-47), every second frame "
                       "of a range (0-47x2), or several ranges (0-9,20).");
}

void add_dry_run(CommandDescription& description, bool& dry_run) {
    description.flag("--dry-run", dry_run,
                     "Only print which frames are stored, which would be rendered, and a forecast: "
                     "time, memory, and the sizes of the stored frames and of the film. The "
                     "forecast takes at most 20 s of processor time; --quiet omits it.");
}

void add_tier(CommandDescription& description) {
    description.option("--tier", static_cast<std::string*>(nullptr), "NAME",
                       "Accepted from older scripts, does nothing: frames are the same with all "
                       "vector instructions.");
}

void add_page(CommandDescription& description, PageOptions& page) {
    description
        .option("--port", &page.port, "N",
                "The port of the address, 1024 to 65535. 0, the default, means any free port.")
        .between(0, 65535)
        .checked_by([](const std::string& text) {
            const bool is_system = !text.empty() && text != "0" && text.size() <= 4 &&
                                   text.find_first_not_of("0123456789") == std::string::npos &&
                                   std::stoi(text) > 0 && std::stoi(text) < 1024;
            return is_system ? "ports below 1024 belong to the system; take 1024 to 65535, or 0"
                             : std::string();
        });
    description.flag("--no-browser", page.no_browser, "Only print the address.");
    description.option("--idle", &page.idle, "TIME",
                       "End the server when for so long nothing was asked: 12h (the default), "
                       "90min.");
}

void add_threads(CommandDescription& description, int& threads) {
    description
        .option("--threads", &threads, "N",
                "Render with N threads. 0, the default, means one per processor.")
        .between(0, 1024);
}

void add_output(CommandDescription& description, std::string& output, const char* help) {
    description.option("-o,--output", &output, "FILE", help).offers(Offer::files);
}

void add_drawing(CommandDescription& description, DrawingOptions& drawing) {
    description
        .option("--page", &drawing.page, "NAME",
                "The background: auto (the default, which follows the browser's setting), light "
                "or dark.")
        .one_of({"auto", "light", "dark"});
    description
        .option("--width", &drawing.width, "N", "The width of a .png in pixels (default 2000).")
        .between(100, 16000);
}

void add_retime_words(CommandDescription& description, RetimeWords& words) {
    description.option("--speed", &words.speed, "RATIO",
                       "Seconds of the scene per second of film: 0.125 or 1/8. The default is the "
                       "speed of the original film.");
    description.option(
        "--from", &words.from, "TIME",
        "Begin at this scene time, a number or a moment such as '{contact: [cue, one], before: "
        "0.2s}'. Without --from and --to the whole film is shown.");
    description.option("--to", &words.to, "TIME", "End at this scene time, written like --from.");
    description.flag("--reverse", words.reverse, "Play backwards.");
    description.option("--ramp", &words.ramp, "T:V,...",
                       "Change the speed during the film, as a list of film times and speeds: "
                       "0s:1,1s:1/8,3s:1/8,4s:1. The last time is the length of the film.");
    description
        .option("--easing", &words.easing, "NAME",
                "How the speed changes between the times of the ramp: smooth (the default) or "
                "linear.")
        .one_of({"smooth", "linear"});
    description.option("--rig", &words.rig, "NAME", "Use only this camera of the shot.")
        .offers(Offer::cameras);
}

}  // namespace carom::cli
