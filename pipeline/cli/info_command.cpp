#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include <fmt/core.h>

#include "core/free_memory.h"
#include "core/printable.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/time_map.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/quick_bake.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/explain.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/memory_forecast.h"
#include "pipeline/sequence/sequence_text.h"
#include "pipeline/video/video_format.h"

namespace carom::cli {

namespace {

using pipeline::Shot;

std::string line(const char* name, const std::string& value) {
    return fmt::format("{:<12}{}\n", name, printable(value));
}

std::string world_lines(const Shot& shot) {
    const auto& bodies = shot.world.bodies;
    const auto balls = std::count_if(bodies.begin(), bodies.end(), [](const sim::Body& body) {
        return std::holds_alternative<sim::Sphere>(body.shape);
    });
    return line("simulated", fmt::format("{:.6g} s, steps of at most {:.4g} s", shot.world.duration,
                                         shot.world.step)) +
           line("bodies", fmt::format("{} balls, {} other bodies, {} force events", balls,
                                      std::ssize(bodies) - balls, shot.world.events.size())) +
           line("visible",
                fmt::format("{} objects, {} materials, {} lights", shot.scene.objects.size(),
                            shot.scene.materials.size(), shot.scene.lights.size()));
}

/// Whether the camera needs a moment whose time is not known.
bool is_open(const Shot& shot, std::size_t camera) {
    const std::string path = fmt::format("cameras[{}].", camera);
    return std::ranges::any_of(shot.moments, [&](const pipeline::ShotMoment& moment) {
        return !moment.time && moment.key_path.starts_with(path);
    });
}

std::string camera_text(const Shot& shot, std::size_t camera) {
    const pipeline::CameraRig& rig = shot.cameras[camera];
    const std::string film =
        rig.name + fmt::format(": {:.6g} s to {:.6g} s of the film, shows ",
                               rig.video_start.to_double(), rig.video_end.to_double());
    if (is_open(shot, camera)) {
        return film + "scene times that are not known";
    }
    const pipeline::SceneTimeRange shown = pipeline::shown_scene_times(rig);
    return film +
           fmt::format("{:.6g} s to {:.6g} s", shown.first.to_double(), shown.last.to_double());
}

std::string film_lines(const Shot& shot, std::uint64_t memory) {
    const std::int64_t frames = pipeline::frame_count(shot.cameras, shot.timing);
    const double fps = shot.timing.fps.to_double();
    std::string text =
        line("film",
             fmt::format("{} frames, {:.6g} per second, {:.6g} s, ", static_cast<long long>(frames),
                         fps, static_cast<double>(frames) / fps) +
                 fmt::format("{}x{}, {} samples a pixel, ", shot.render.width, shot.render.height,
                             shot.render.samples) +
                 pipeline::default_extension(shot.output));
    text +=
        line("memory", "about " + pipeline::memory_text(memory) + " to render and encode the film");
    for (std::size_t i = 0; i < shot.cameras.size(); ++i) {
        text += line(i == 0 ? "cameras" : "", camera_text(shot, i));
    }
    return text;
}

/// The files that the shot was read from, and those that it names.
std::string file_lines(const Shot& shot, const pipeline::ShotSource& source) {
    std::string text;
    std::set<std::string> listed;
    const auto add = [&](const std::string& name) {
        if (!name.starts_with("--") && listed.insert(name).second) {
            text += line(listed.size() == 1 ? "files" : "", name);
        }
    };
    for (int i = 0; i < source.sources().size(); ++i) {
        add(source.sources().at(i).name);
    }
    for (const sim::Asset& asset : shot.assets) {
        add(asset.path);
    }
    return text;
}

void warn_if_memory_is_short(std::uint64_t needed, Console& console) {
    const std::optional<std::uint64_t> free = free_memory();
    if (free && needed > *free) {
        console.warning(fmt::format(
            "the film will need about {} of memory, but only {} are free; a faster "
            "'output.preset', a smaller picture or a sequence of pictures (shot.####.exr) needs "
            "less",
            pipeline::memory_text(needed), pipeline::memory_text(*free)));
    }
}

/// Warns, too, if there is not enough memory for the film.
std::string summary(const ShotInput& input, Console& console) {
    const std::uint64_t memory = pipeline::forecast_memory(input.shot, "");
    warn_if_memory_is_short(memory, console);
    return line("shot", input.shot.name) + film_lines(input.shot, memory) +
           world_lines(input.shot) + file_lines(input.shot, *input.source);
}

/// Gives the moments their times, as far as they are known.
void know_moments(ShotInput& input, CommandContext& context) {
    if (!pipeline::has_open_moments(input.shot)) {
        return;
    }
    const std::optional<sim::Bake> bake = quick_bake(input, "", context);
    if (!bake) {
        context.console.warning(
            "the times of moments are not known: simulating the shot takes "
            "long; run 'carom bake' first");
        return;
    }
    // With all cameras, since those that cannot be filmed are a part of the film, too.
    std::vector<pipeline::CameraRig> cameras = input.shot.cameras;
    report_problems(pipeline::resolve_known_moments(input.shot, input.source, bake->timeline),
                    context.console);
    for (pipeline::CameraRig& camera : cameras) {
        const auto known =
            std::ranges::find(input.shot.cameras, camera.name, &pipeline::CameraRig::name);
        if (known != input.shot.cameras.end()) {
            camera = std::move(*known);
        }
    }
    input.shot.cameras = std::move(cameras);
}

/// The whole shot with its origins.
std::string resolved(ShotInput& input, CommandContext& context) {
    const auto written = input.source;
    know_moments(input, context);
    const bool is_known = !pipeline::has_open_moments(input.shot);
    return pipeline::explained_yaml(is_known ? *input.source : *written, input.shot);
}

/// The film, and each of its shots as a document of its own.
std::string resolved(pipeline::Sequence sequence, CommandContext& context) {
    std::string text = pipeline::sequence_text(sequence, [&](std::size_t part) {
        return std::get<pipeline::ShotPart>(sequence.parts[part].content).path;
    });
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        if (auto* part = std::get_if<pipeline::ShotPart>(&sequence.parts[i].content)) {
            text += "---\n# " + printable(part_name(i, *part)) + "\n";
            ShotInput input = input_of(*part);
            text += resolved(input, context);
        }
    }
    return text;
}

}  // namespace

void run(const InfoCommand& command, CommandContext& context) {
    check_output_folder(command.output);
    const std::string output = command.output.empty() ? "-" : command.output;
    if (is_sequence(command.input)) {
        pipeline::Sequence sequence = read_sequence_input(command.input, context.console);
        return write_text_output(output, command.resolved ? resolved(std::move(sequence), context)
                                                          : sequence_summary(sequence));
    }
    ShotInput input = read_shot_input(command.input, context.console);
    if (input.bake) {
        report_problems(pipeline::simulation_problems(input.bake->timeline, input.source.get()),
                        context.console, true);
    }
    if (command.resolved) {
        return write_text_output(output, resolved(input, context));
    }
    know_moments(input, context);
    write_text_output(output, summary(input, context.console));
}

}  // namespace carom::cli
