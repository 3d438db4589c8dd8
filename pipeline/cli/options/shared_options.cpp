#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

std::string example(const char* lines) {
    return std::string("Example:\n") + lines;
}

void add_input(CLI::App& app, InputOptions& input, const char* name, const char* what) {
    app.add_option(name, input.path, what)->required()->option_text(" ");
    add_changes(app, input);
}

void add_changes(CLI::App& app, InputOptions& input) {
    app.add_option("--set", input.overrides,
                   "change a value of the shot, by its path: --set render.samples=64; may be "
                   "repeated")
        ->option_text("KEY=VALUE")
        ->allow_extra_args(false);
    app.add_option("--quality", input.quality,
                   "a preset, which keeps the picture's shape: draft, preview or final")
        ->option_text("NAME");
    app.add_option("--root", input.root,
                   "refuse a shot that names files outside of this folder, links followed (carom's "
                   "own tables, looks and rigs may be named)")
        ->option_text("FOLDER")
        ->check(CLI::ExistingDirectory);
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

}  // namespace carom::cli
