#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include <fmt/core.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/cli/film_music.h"
#include "pipeline/cli/named_files.h"
#include "pipeline/cli/quick_bake.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/sequence/sequence_scene.h"
#include "pipeline/sound/film_scene.h"
#include "pipeline/video/video_format.h"

namespace carom::cli {

namespace {

using pipeline::Problem;

/// Returns the bake, unless it takes too long.
std::optional<sim::Bake> check_motion(ShotInput& input, const CheckCommand& command,
                                      CommandContext& context, std::vector<Problem>& problems) {
    std::optional<sim::Bake> bake = quick_bake(input, command.cache.folder, context);
    if (!bake) {
        context.console.info(
            fmt::format("the motion was not checked, because simulating it takes more than {} "
                        "million steps; to check it, run 'carom bake' first",
                        kMostQuickSteps / 1'000'000));
        return bake;
    }
    const auto add = [&](std::vector<Problem> found) {
        std::move(found.begin(), found.end(), std::back_inserter(problems));
    };
    add(pipeline::simulation_problems(bake->timeline, input.source.get()));
    add(pipeline::stick_problems(input.shot, input.source.get(), bake->timeline));
    std::vector<Problem> of_moments =
        pipeline::resolve_moments(input.shot, input.source, bake->timeline);
    const bool is_whole = !pipeline::has_errors(of_moments);
    add(std::move(of_moments));
    if (!is_whole) {  // what can be filmed is checked all the same
        (void)pipeline::resolve_known_moments(input.shot, input.source, bake->timeline);
    }
    add(pipeline::cloth_problems(input.shot, input.source.get(), bake->timeline));
    add(pipeline::camera_problems(input.shot, input.source.get(), bake->timeline));
    if (is_whole) {
        add(pipeline::sound_problems(input.shot, input.source.get(), bake->timeline));
    }
    add(pipeline::annotation_problems(input.shot, input.source.get(), bake->timeline));
    if (context.text_problems != nullptr && is_whole) {
        add(context.text_problems(input.shot, input.source.get(), bake->timeline));
    }
    return bake;
}

/// Also by a fixed gain.
bool asks_for_loudness(const pipeline::Shot& shot) {
    return !shot.sound.is_silent && (shot.sound.loudness || shot.sound.full_scale);
}

/// `source`: of the shot that asks for a loudness.
void check_loudness(const sound::SoundScene& film, const pipeline::OutputSettings& output,
                    const pipeline::ShotSource* source, const CommandContext& context,
                    std::vector<Problem>& problems) {
    sound::AddedSound music;
    try {
        if (output.music) {
            music = context.music(*output.music, film.frames);
        }
    } catch (const Error& error) {
        problems.push_back(
            source->problem_at({"output", "music"}, pipeline::Severity::error, error.what()));
        return;
    }
    std::vector<Problem> found =
        pipeline::loudness_problems(film, source, music, {{}, context.stop});
    std::move(found.begin(), found.end(), std::back_inserter(problems));
}

void check_loudness(const ShotInput& input, const sim::Bake& bake, const CommandContext& context,
                    std::vector<Problem>& problems) {
    const pipeline::Shot& shot = input.shot;
    if (asks_for_loudness(shot) && !pipeline::has_errors(problems)) {
        check_loudness(pipeline::film_scene(shot, bake.timeline, 0,
                                            pipeline::frame_count(shot.cameras, shot.timing)),
                       shot.output, input.source.get(), context, problems);
    }
}

/// A film of several shots has one loudness: that of the first shot that asks for one.
void check_loudness(const pipeline::Sequence& film,
                    const std::map<std::size_t, std::optional<sim::Bake>>& bakes,
                    const CommandContext& context, std::vector<Problem>& problems) {
    if (pipeline::has_errors(problems)) {
        return;
    }
    std::map<std::size_t, const sim::Timeline*> timelines;
    const pipeline::ShotPart* asks = nullptr;
    for (const auto& [i, bake] : bakes) {
        if (!bake) {
            return;
        }
        const auto& part = std::get<pipeline::ShotPart>(film.parts[i].content);
        timelines[i] = &bake->timeline;
        asks = asks == nullptr && asks_for_loudness(part.shot) ? &part : asks;
    }
    if (asks != nullptr) {
        check_loudness(pipeline::sequence_scene(film, timelines, 0, film.frames()), film.output,
                       asks->source.get(), context, problems);
    }
}

/// Checks the size for the film that `carom render` writes by default. `where` becomes a warning,
/// because images and other codecs may support the size.
void check_film_file(const pipeline::VideoFormat& format, const pipeline::OutputSettings& output,
                     Problem where, std::vector<Problem>& problems) {
    where.message =
        pipeline::check_film_size(format, output, "film" + pipeline::default_extension(output));
    where.severity = pipeline::Severity::warning;
    if (!where.message.empty()) {
        problems.push_back(std::move(where));
    }
}

FileReading reading_of(const CheckCommand& command) {
    return command.full ? FileReading::full : FileReading::usual;
}

/// Prints the light on the table of a shot without errors.
void show_table_light(const pipeline::Shot& shot, CommandContext& context) {
    if (!shot.world.table) {
        throw InputError("--lux: the shot has no table");
    }
    print_text(context.table_light(shot));
}

/// `by_header` gets a sentence about files of which only the headers were read.
std::vector<Problem> problems_of_shot(const CheckCommand& command, CommandContext& context,
                                      std::string& by_header) {
    CheckedInput checked = load_shot_input(command.input);
    by_header = check_files(checked, reading_of(command), context);
    std::vector<Problem>& problems = checked.problems;
    if (checked.input) {
        const pipeline::Shot& shot = checked.input->shot;
        check_film_file(
            {shot.render.width, shot.render.height, shot.timing.fps}, shot.output,
            checked.input->source->problem_at({"render", "size"}, pipeline::Severity::warning, ""),
            problems);
        std::ranges::move(
            pipeline::object_problems(checked.input->shot, checked.input->source.get()),
            std::back_inserter(problems));
        if (!command.quick && !pipeline::has_errors(problems)) {
            require_film_program(!checked.input->shot.annotations.empty(), context);
            if (asks_for_loudness(checked.input->shot)) {
                require_film_program(checked.input->shot.output.music.has_value(), context);
            }
            if (const auto bake = check_motion(*checked.input, command, context, problems)) {
                check_loudness(*checked.input, *bake, context, problems);
            }
        }
        if (command.lux && !pipeline::has_errors(problems)) {
            show_table_light(shot, context);
        }
    }
    return std::move(problems);
}

/// Those of the film's own file and of its shots.
std::vector<Problem> problems_of_sequence(const CheckCommand& command, CommandContext& context,
                                          std::string& by_header) {
    pipeline::SequenceResult loaded = load_sequence_input(command.input);
    by_header = check_files(loaded, reading_of(command), context);
    if (loaded.sequence) {
        const pipeline::Sequence& film = *loaded.sequence;
        check_film_file({film.width, film.height, film.fps}, film.output, loaded.output_place,
                        loaded.problems);
    }
    if (!loaded.sequence || command.quick) {
        return std::move(loaded.problems);
    }
    std::vector<pipeline::SequencePart>& parts = loaded.sequence->parts;
    const auto asks = [](const pipeline::SequencePart& part) {
        const auto* shot = std::get_if<pipeline::ShotPart>(&part.content);
        return shot != nullptr && asks_for_loudness(shot->shot);
    };
    if (std::ranges::any_of(parts, asks)) {
        require_film_program(loaded.sequence->output.music.has_value(), context);
    }
    for (const pipeline::SequencePart& part : parts) {
        if (const auto* shot = std::get_if<pipeline::ShotPart>(&part.content)) {
            require_film_program(!shot->shot.annotations.empty(), context);
        }
    }
    std::map<std::size_t, std::optional<sim::Bake>> bakes;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (auto* shot = std::get_if<pipeline::ShotPart>(&parts[i].content)) {
            ShotInput input = input_of(*shot);
            bakes[i] = check_motion(input, command, context, loaded.problems);
            take_back(std::move(input), *shot);
        }
    }
    check_loudness(*loaded.sequence, bakes, context, loaded.problems);
    return std::move(loaded.problems);
}

std::string json_of(const std::vector<Problem>& problems) {
    std::string text = "[";
    for (const Problem& problem : problems) {
        text += (text.size() > 1 ? ",\n" : "\n") + members_of(problem).object();
    }
    return text + (problems.empty() ? "]\n" : "\n]\n");
}

}  // namespace

void run(const CheckCommand& command, CommandContext& context) {
    require_film_program(command.lux, context);
    std::string by_header;
    if (command.lux && (command.json || is_sequence(command.input))) {
        throw InputError(
            "--lux prints a table for one shot: not with --json, and not for a film "
            "of several shots");
    }
    const std::vector<Problem> problems = is_sequence(command.input)
                                              ? problems_of_sequence(command, context, by_header)
                                              : problems_of_shot(command, context, by_header);
    if (command.json) {
        print_text(json_of(problems));
    } else {
        report_problems(problems, context.console, true);
    }
    if (!by_header.empty()) {
        context.console.info(by_header);
    }
    const std::string& path = command.input.path;
    if (pipeline::has_errors(problems)) {
        throw InputError("'" + path + "' has " + count_text(problems));
    }
    context.console.info("'" + path + "' has no errors" +
                         (problems.empty() ? "" : ", but " + count_text(problems)));
}

}  // namespace carom::cli
