#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/frames_sheet.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/sequence_films.h"
#include "pipeline/job/film_job.h"
#include "pipeline/sequence/load_sequence.h"

namespace carom::cli {

namespace {

using pipeline::Shot;

constexpr int kMaxSamples = 4;  // enough for a small picture

/// Sets the size of the pictures, with the shot's aspect ratio.
void set_picture_width(Shot& shot, int width) {
    const double proportion =
        static_cast<double>(shot.render.height) / static_cast<double>(shot.render.width);
    shot.render.width = width;
    shot.render.height = std::max(1, static_cast<int>(std::lround(width * proportion)));
}

std::string facts_of(const Shot& shot, std::int64_t frames) {
    return fmt::format("{} frames, {:.6g} per second", frames, shot.timing.fps.to_double());
}

}  // namespace

void run(const ContactSheetCommand& command, CommandContext& context) {
    if (is_sequence(command.input)) {
        return write_sequence_sheet(command, context);
    }
    InputOptions options = command.input;
    if (options.quality.empty()) {
        options.quality = "draft";
    }
    const std::string path = output_or_default(command.output, options.path, "_sheet.png");
    check_sheet_path(path, "a contact sheet");
    check_output_folder(path);
    ShotInput input = read_film_input(options, FileReading::usual, context);
    Shot& shot = input.shot;
    set_picture_width(shot, command.width);
    if (command.input.quality.empty()) {
        shot.render.samples = std::min(shot.render.samples, kMaxSamples);
    }
    shot.render.aovs.clear();
    const std::int64_t all = film_frames(shot);
    pipeline::FilmJobOptions job = job_options(command.cache, {}, {});
    job.threads = command.threads;
    job.structures = context.structures;
    job.frames = spread_frames(command.count, all);
    const std::vector<std::int64_t> frames = job.frames.frames(all);
    require_store(job);
    const sim::Bake bake = obtain_bake(input, options, command.cache, context);
    warn_of_no_store(command.cache, context.console);
    if (!job.no_store) {  // all pictures are rendered in one job, and then read from the store
        (void)pipeline::make_film(shot, bake, job,
                                  make_console_observer(context.console, std::ssize(frames)),
                                  context.stop);
        context.console.end_progress();
    }
    write_frames_sheet(shot, bake, job,
                       {frames, facts_of(shot, all), command.columns, command.width, path},
                       context);
}

}  // namespace carom::cli
