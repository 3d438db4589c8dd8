#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/chosen_tier.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/job/film_job.h"
#include "pipeline/plan/plan_colours.h"
#include "pipeline/sheet/contact_sheet.h"
#include "pipeline/video/picture_kind.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/view_transform.h"

namespace carom::cli {

namespace {

using pipeline::PlannedFrame;
using pipeline::Shot;

/// `count` of `all` frames at even distances, with the first and the last one.
pipeline::FrameRange spread_frames(std::int64_t count, std::int64_t all) {
    pipeline::FrameRange range;
    const std::int64_t steps = std::min(count, all);
    for (std::int64_t i = 0; i < steps; ++i) {
        const std::int64_t frame = steps == 1 ? 0 : (i * (all - 1) + (steps - 1) / 2) / (steps - 1);
        range.parts.push_back({frame, frame, 1});
    }
    return range;
}

constexpr int kMaxSamples = 4;  // enough for a small picture

/// Sets the size of the pictures, with the shot's aspect ratio.
void set_picture_width(Shot& shot, int width) {
    const double proportion =
        static_cast<double>(shot.render.height) / static_cast<double>(shot.render.width);
    shot.render.width = width;
    shot.render.height = std::max(1, static_cast<int>(std::lround(width * proportion)));
}

std::array<std::uint8_t, 3> colour_of(const Shot& shot, const std::string& rig) {
    const auto found = std::ranges::find(shot.cameras, rig, &pipeline::CameraRig::name);
    const std::string text =
        pipeline::rig_colour(static_cast<std::size_t>(found - shot.cameras.begin()));
    const auto channel = [&](std::size_t at) {
        return static_cast<std::uint8_t>(std::stoi(text.substr(at, 2), nullptr, 16));
    };
    return {channel(1), channel(3), channel(5)};
}

std::string line_of(const PlannedFrame& frame) {
    return fmt::format("frame {}  scene {:.3f} s  {}", frame.number, frame.scene_time, frame.rig);
}

std::string facts_of(const Shot& shot, std::int64_t frames) {
    return fmt::format("{} frames, {:.6g} per second", frames, shot.timing.fps.to_double());
}

}  // namespace

void run(const ContactSheetCommand& command, CommandContext& context) {
    InputOptions options = command.input;
    if (options.quality.empty()) {
        options.quality = "draft";
    }
    const std::string path = output_or_default(command.output, options.path, "_sheet.png");
    if (!pipeline::is_picture_path(path) || pipeline::is_linear_picture(path)) {
        throw InputError("cannot write a contact sheet to '" + path +
                         "'; the name must end in .png, .jpg, .bmp or .tga");
    }
    check_output_folder(path);
    const ChosenTier tier(command.tier);
    ShotInput input = read_film_input(options, context);
    Shot& shot = input.shot;
    set_picture_width(shot, command.width);
    if (command.input.quality.empty()) {
        shot.render.samples = std::min(shot.render.samples, kMaxSamples);
    }
    shot.render.aovs.clear();
    const std::int64_t all = film_frames(shot);
    const pipeline::DisplayView view(shot.output);
    pipeline::FilmJobOptions job = job_options(command.cache, {}, {});
    job.threads = command.threads;
    job.factory = context.factory;
    job.frames = spread_frames(command.count, all);
    const std::vector<std::int64_t> frames = job.frames.frames(all);
    const sim::Bake bake = obtain_bake(input, options, command.cache, context);
    // All pictures are rendered to the store in one job, and then read from there.
    (void)pipeline::make_film(
        shot, bake, job, make_console_observer(context.console, std::ssize(frames)), context.stop);
    context.console.end_progress();
    const std::vector<pipeline::CameraRig> rigs =
        pipeline::with_fitted_paths(shot.cameras, bake.timeline);
    std::vector<pipeline::SheetCell> cells;
    for (const std::int64_t number : frames) {
        const render::Film film = pipeline::make_frame(shot, bake, number, job, {}, context.stop);
        const PlannedFrame frame = pipeline::plan_frame(number, rigs, shot.timing, bake.timeline);
        cells.push_back({{film.width, film.height, view.to_8(film)},
                         line_of(frame),
                         colour_of(shot, frame.rig)});
    }
    const pipeline::DisplayPicture sheet =
        pipeline::contact_sheet(shot.name, facts_of(shot, all), cells, command.columns);
    pipeline::write_display_picture(sheet.rgb, sheet.width, sheet.height, path);
    print_path(path);
}

}  // namespace carom::cli
