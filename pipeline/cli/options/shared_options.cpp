#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

void add_input(CommandDescription& description, InputOptions& input) {
    description
        .argument("SHOT|BAKE", input.path,
                  "The shot, or a bake, which is a shot that is already simulated.")
        .offers(Offer::files, {"yaml", "yml", "bake"});
}

void add_changes(CommandDescription& description, InputOptions& input) {
    description
        .option("--set", &input.overrides, "KEY=VALUE",
                "Change a value of the shot, named by its path: --set render.samples=64. The "
                "option may be repeated.")
        .offers(Offer::keys);
    description
        .option("--quality", &input.quality, "NAME",
                "Use a preset, which keeps the shape of the picture: draft, preview or final.")
        .offers(Offer::presets);
    description
        .option("--root", &input.root, "FOLDER",
                "Refuse a shot that names files outside of this folder, with links followed. "
                "carom's own tables, looks and rigs are allowed.")
        .offers(Offer::folders)
        .must_be_folder = true;
}

void add_camera_file(CommandDescription& description, InputOptions& input) {
    description
        .option("--camera", &input.camera_file, "FILE",
                "Film with the 'cameras' of this file instead of the shot's. It may also change "
                "'render', 'output', 'lights' and 'materials'.")
        .offers(Offer::files, {"yaml", "yml"});
}

void add_cache(CommandDescription& description, CacheOptions& cache) {
    description
        .option("--cache", &cache.folder, "FOLDER",
                "Keep bakes and finished frames here. The default is $CAROM_CACHE, else "
                "$XDG_CACHE_HOME/carom, else ~/.cache/carom.")
        .offers(Offer::folders);
}

void add_cache_size(CommandDescription& description, CacheOptions& cache) {
    description.option("--cache-size", &cache.size, "SIZE",
                       "Limit the size of the cache: 500 MB, 20 GB or none. Files that were not "
                       "used for the longest time are removed first. The default is "
                       "$CAROM_CACHE_SIZE, else 20 GB.");
}

void add_frames(CommandDescription& description, std::string& frames) {
    description.option("--frames", &frames, "RANGE",
                       "Use only these frames, counted from 0: 0-47, every second one 0-47x2, or "
                       "several ranges 0-9,20.");
}

void add_dry_run(CommandDescription& description, bool& dry_run) {
    description.flag("--dry-run", dry_run,
                     "Only print which frames exist and which would be rendered.");
}

void add_threads(CommandDescription& description, int& threads) {
    description
        .option("--threads", &threads, "N",
                "Render with so many threads. 0, the default, is one per processor.")
        .between(0, 1024);
}

void add_output(CommandDescription& description, std::string& output, const char* help) {
    description.option("-o,--output", &output, "FILE", help).offers(Offer::files);
}

void add_drawing(CommandDescription& description, DrawingOptions& drawing) {
    description
        .option("--page", &drawing.page, "NAME",
                "Draw for this background: auto (the default: as the browser prefers), light or "
                "dark.")
        .one_of({"auto", "light", "dark"});
    description
        .option("--width", &drawing.width, "N", "The width of a .png in pixels (default 2000).")
        .between(100, 16000);
}

}  // namespace carom::cli
