#include "pipeline/cli/film_commands.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <span>
#include <vector>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/camera/shown_frame.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/forecast_report.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/cli/moment_text.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/sequence_films.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/cli/time_text.h"
#include "pipeline/job/film_forecast.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_status.h"
#include "pipeline/job/frame_graphics.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/job/viewed_frame.h"
#include "pipeline/sequence/load_sequence.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/picture_kind.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/view_transform.h"
#include "render/integrator/distributed_ray_counts.h"

namespace carom::cli {

namespace {

using pipeline::FilmJobOptions;
using pipeline::Shot;

/// Prints how far camera paths along objects deviate from the motion of these objects.
void report_fitted_paths(const Shot& shot, const sim::Timeline& timeline, Console& console) {
    std::vector<pipeline::FittedPath> fitted;
    (void)pipeline::with_fitted_paths(shot.cameras, timeline, &fitted);
    for (const pipeline::FittedPath& path : fitted) {
        console.info(
            fmt::format("camera '{}': the {} along '{}' is a Bezier curve of degree {}, which "
                        "deviates from the motion of '{}' by at most {:.2g} mm",
                        path.rig, path.is_target ? "target" : "position", path.object, path.degree,
                        path.object, path.error * 1000));
    }
}

/// The first frame that shows the moment.
std::int64_t frame_at_moment(const std::string& text, const ShotInput& input) {
    const double time = time_of_moment("--at", text, input);
    const auto frame = pipeline::first_frame_showing(time, input.shot.cameras, input.shot.timing);
    if (!frame) {
        throw InputError("--at " + text + ": the film does not show that moment, which comes at " +
                         seconds_text(time) + " of scene time");
    }
    return *frame;
}

std::int64_t chosen_frame(const FrameCommand& command, const ShotInput& input) {
    const Shot& shot = input.shot;
    if (is_moment_text(command.at)) {
        return frame_at_moment(command.at, input);
    }
    const std::int64_t count = film_frames(shot);
    std::int64_t frame = command.frame.value_or(0);
    std::string given = fmt::format("frame {}", frame);
    if (!command.at.empty()) {
        frame = frame_shown_at(parse_seconds(command.at), shot.timing.fps);
        given = "--at " + command.at;
    }
    if (frame < 0 || frame >= count) {
        throw InputError(
            fmt::format("{} is outside the film, which has the frames 0 to {}", given, count - 1));
    }
    return frame;
}

/// The number of lights that shadow rays are traced to, which excludes environments of one colour.
std::size_t sampled_lights(const Shot& shot) {
    return static_cast<std::size_t>(
        std::count_if(shot.scene.lights.begin(), shot.scene.lights.end(), [](const auto& light) {
            const auto* environment = std::get_if<render::EnvironmentLight>(&light.light);
            return environment == nullptr || !environment->image.empty() || environment->sky;
        }));
}

/// "81 frames, 12 of them". If there are more pictures than frames, because each frame of a
/// cross-fade is mixed from two, the rendered pictures are counted.
std::string counts_text(const pipeline::FilmJobResult& result) {
    const std::string frames = fmt::format("{} frames", result.frames);
    const std::string made_of = result.pictures > result.frames
                                    ? fmt::format(" made of {} pictures", result.pictures)
                                    : std::string();
    return fmt::format("{}{}, {} of them", frames, made_of, result.rendered);
}

/// Prints the rays of the distributed integrator by kind, for the frames that were rendered now.
void report_rays(const Shot& shot, const render::RenderStatistics& count, Console& console) {
    if (shot.render.integrator != render::IntegratorKind::distributed || count.camera_rays == 0) {
        return;
    }
    const std::size_t lights = sampled_lights(shot);
    std::string text;
    for (const std::string& line : render::describe_rays(count, shot.render, lights)) {
        text += "carom: " + line + "\n";
    }
    const render::RayFormulas formulas = render::ray_formulas(count, shot.render, lights);
    JsonMembers members;
    const auto add = [&members](const char* name, std::uint64_t rays) {
        members.add(name, static_cast<std::int64_t>(rays));
    };
    add("camera", count.camera_rays);
    add("reflection", count.reflection_rays);
    add("refraction", count.refraction_rays);
    add("shadow", count.shadow_rays);
    add("needless_shadow", count.needless_shadow_rays);
    members.add("if_all_reflect_and_refract", formulas.full).add("classic", formulas.classic);
    console.event("rays", members, text, false);
}

/// Prints the output of --dry-run: ranges of frames in order.
void print_status(const pipeline::FilmStatus& status) {
    std::string text;
    if (!status.stored.empty()) {
        text += "stored: " + pipeline::frames_text(status.stored) + "\n";
    }
    if (!status.missing.empty()) {
        text += "to render: " + pipeline::frames_text(status.missing) + "\n";
    }
    if (!status.damaged.empty()) {
        text += "of these, stored but damaged: " + pipeline::frames_text(status.damaged) + "\n";
    }
    text += fmt::format("{} frames, {} stored, {} to render", status.frames.size(),
                        status.stored.size(), status.missing.size());
    if (status.pictures != std::ssize(status.missing)) {
        text += fmt::format(" as {} pictures", status.pictures);
    }
    print_text(text + "\n");
}

void check_picture_path(const std::string& path) {
    if (!pipeline::is_picture_path(path)) {
        throw InputError("cannot write a picture to '" + path + "'; the formats are " +
                         pipeline::list_pictures());
    }
}

std::string numbered_extension(std::int64_t frame) {
    std::string digits = fmt::format("{}", frame);
    digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
    return "." + digits + ".png";
}

}  // namespace

void run(const RenderCommand& command, CommandContext& context) {
    if (is_sequence(command.input)) {
        return render_sequence(command, context);
    }
    const auto begin = std::chrono::steady_clock::now();
    ShotInput input = read_film_input(command.input, FileReading::usual, context);
    const bool makes_film = command.chunk.empty() || !command.output.empty();
    const std::string path = makes_film ? film_path(command.output, command.input, input.shot) : "";
    film_shot(std::move(input), path, command, begin, context);
}

void film_shot(ShotInput input, const std::string& path, const RenderCommand& command,
               std::chrono::steady_clock::time_point begin, CommandContext& context) {
    const bool makes_film = !path.empty();
    if (!command.chunk.empty() && makes_film && !pipeline::is_image_sequence(path)) {
        throw InputError("cannot write the film '" + path +
                         "' from one chunk; omit -o and run 'carom mux' when all chunks are "
                         "rendered, or write pictures (shot.####.exr)");
    }
    if (makes_film) {
        check_film(input, path, context.console);
    } else if (command.cache.no_store && !command.dry_run) {
        throw InputError(
            "with --no-store the frames of a chunk would be lost; write pictures "
            "(-o shot.####.exr)");
    }
    FilmJobOptions options = job_options(command.cache, command.frames, command.chunk);
    options.output = path;
    options.threads = command.threads;
    options.structures = context.structures;
    const std::int64_t frames =
        count_job_frames(input.shot, options, command.frames, context.console);
    if (frames == 0) {
        context.console.info("chunk " + command.chunk + " has no frames");
        return;
    }
    require_store(options);
    const sim::Bake bake = obtain_bake(input, command.input, command.cache, context);
    report_fitted_paths(input.shot, bake.timeline, context.console);
    if (command.dry_run) {
        const pipeline::FilmStatus status =
            pipeline::film_status(input.shot, bake, options, context.stop);
        print_status(status);
        if (!status.missing.empty() && context.console.prints_info()) {
            report_forecast(
                pipeline::forecast_film(input.shot, bake, status.missing, options, context.stop),
                pipeline::thread_count(options.threads), context.console);
        }
        return;
    }
    warn_of_no_store(command.cache, context.console);
    const pipeline::FilmJobResult result = pipeline::make_film(
        input.shot, bake, options, make_console_observer(context.console, frames), context.stop);
    context.console.end_progress();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    context.console.info(counts_text(result) + " rendered now, in " +
                         duration_text(elapsed.count()));
    report_rays(input.shot, result.counts, context.console);
    if (makes_film) {
        print_path(path);
    }
}

void run(const MuxCommand& command, CommandContext& context) {
    if (is_sequence(command.input)) {
        return mux_sequence(command, context);
    }
    ShotInput input = read_checked_input(command.input, FileReading::usual, context);
    const std::string path = film_path(command.output, command.input, input.shot);
    check_film(input, path, context.console);
    FilmJobOptions options = job_options(command.cache, command.frames, {});
    options.output = path;
    options.so_far = command.so_far;
    const std::int64_t frames =
        count_job_frames(input.shot, options, command.frames, context.console);
    const sim::Bake bake = obtain_bake(input, command.input, command.cache, context);
    const pipeline::FilmJobResult result = pipeline::mux_film(
        input.shot, bake, options, make_console_observer(context.console, frames), context.stop);
    context.console.end_progress();
    context.console.info(
        command.so_far && result.pictures < result.frames
            ? fmt::format("{} frames, of {} different pictures", result.frames, result.pictures)
            : fmt::format("{} frames", result.frames));
    print_path(path);
}

void run(const FrameCommand& command, CommandContext& context) {
    if (is_sequence(command.input)) {
        return write_sequence_frame(command, context);
    }
    ShotInput input = read_film_input(command.input, FileReading::usual, context);
    if (is_moment_text(command.at)) {
        know_motion(input, command.input, command.cache, context);
    }
    const std::int64_t frame = chosen_frame(command, input);
    const std::string path =
        output_or_default(command.output, command.input.path, numbered_extension(frame));
    check_picture_path(path);
    check_output_folder(path);
    const pipeline::DisplayView view(input.shot.output);

    FilmJobOptions options = job_options(command.cache, {}, {});
    options.threads = command.threads;
    options.structures = context.structures;
    require_store(options);
    const sim::Bake bake = obtain_bake(input, command.input, command.cache, context);
    warn_of_no_store(command.cache, context.console);
    pipeline::FrameGraphics graphics(input.shot, bake.timeline, command.threads);
    graphics.prepare();  // may fail, so before rendering
    const render::Film film = pipeline::make_frame(
        input.shot, bake, frame, options, make_console_observer(context.console, 1), context.stop);
    context.console.end_progress();
    report_rays(input.shot, film.statistics, context.console);
    const std::vector<pipeline::PlannedFrame> layers = pipeline::plan_mixed_frame(
        frame, pipeline::with_fitted_paths(input.shot.cameras, bake.timeline), input.shot.timing,
        bake.timeline);
    pipeline::write_picture(
        film, view, pipeline::viewed_frame(layers), path,
        pipeline::exported_frame_metadata(input.shot, bake.timeline, frame, film),
        [&](std::span<std::uint8_t> rgb, int width, int height) {
            graphics.draw(layers, rgb, width, height);
        },
        pipeline::exr_standard_attributes(input.shot, layers.front()));
    print_path(path);
}

}  // namespace carom::cli
