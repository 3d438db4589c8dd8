#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/core.h>

#include "pipeline/check/motion_check.h"
#include "pipeline/cli/quick_bake.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/video/video_format.h"

namespace carom::cli {

namespace {

using pipeline::Problem;

void check_motion(ShotInput& input, const CheckCommand& command, CommandContext& context,
                  std::vector<Problem>& problems) {
    const std::optional<sim::Bake> bake = quick_bake(input, command.cache.folder, context);
    if (!bake) {
        context.console.info(
            fmt::format("the motion was not checked, because simulating it takes more than {} "
                        "million steps; to check it, run 'carom bake' first",
                        kMostQuickSteps / 1'000'000));
        return;
    }
    const auto add = [&](std::vector<Problem> found) {
        std::move(found.begin(), found.end(), std::back_inserter(problems));
    };
    add(pipeline::simulation_problems(bake->timeline, input.source.get()));
    add(pipeline::stick_problems(input.shot, input.source.get(), bake->timeline));
    // A moment that never comes is an error of commands that film it.
    std::vector<Problem> moments =
        pipeline::resolve_moments(input.shot, input.source, bake->timeline);
    for (Problem& problem : moments) {
        problem.severity = pipeline::Severity::warning;
    }
    add(std::move(moments));
    add(pipeline::cloth_problems(input.shot, input.source.get(), bake->timeline));
    if (!pipeline::has_open_moments(input.shot)) {
        add(pipeline::camera_problems(input.shot, input.source.get(), bake->timeline));
        add(pipeline::sound_problems(input.shot, input.source.get(), bake->timeline));
        WorkContext mixing;
        mixing.stop = context.stop;
        add(pipeline::loudness_problems(input.shot, input.source.get(), bake->timeline, mixing));
    }
    add(pipeline::annotation_problems(input.shot, input.source.get(), bake->timeline));
}

/// Checks the size for the film that `carom render` writes by default. It is a warning, because
/// images and other codecs may support the size.
void check_film_file(const ShotInput& input, std::vector<Problem>& problems) {
    const pipeline::Shot& shot = input.shot;
    const std::string problem = pipeline::check_film_size(
        {shot.render.width, shot.render.height, shot.timing.fps}, shot.output,
        shot.name + pipeline::default_extension(shot.output));
    if (!problem.empty()) {
        problems.push_back(
            input.source->problem_at({"render", "size"}, pipeline::Severity::warning, problem));
    }
}

std::vector<Problem> problems_of_shot(const CheckCommand& command, CommandContext& context) {
    CheckedInput checked = load_shot_input(command.input);
    std::vector<Problem>& problems = checked.problems;
    if (checked.input) {
        check_film_file(*checked.input, problems);
        if (!command.quick && !pipeline::has_errors(problems)) {
            check_motion(*checked.input, command, context, problems);
        }
    }
    return std::move(problems);
}

/// Those of the film's own file and of its shots.
std::vector<Problem> problems_of_sequence(const CheckCommand& command, CommandContext& context) {
    pipeline::SequenceResult loaded = load_sequence_input(command.input);
    if (!loaded.sequence || command.quick) {
        return std::move(loaded.problems);
    }
    for (pipeline::SequencePart& part : loaded.sequence->parts) {
        if (auto* shot = std::get_if<pipeline::ShotPart>(&part.content)) {
            ShotInput input = input_of(*shot);
            check_motion(input, command, context, loaded.problems);
        }
    }
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
    const std::vector<Problem> problems = pipeline::is_sequence_file(command.input.path)
                                              ? problems_of_sequence(command, context)
                                              : problems_of_shot(command, context);
    if (command.json) {
        print_text(json_of(problems));
    } else {
        report_problems(problems, context.console);
    }
    const std::string& path = command.input.path;
    if (pipeline::has_errors(problems)) {
        throw InputError("'" + path + "' has " + count_text(problems));
    }
    context.console.info("'" + path + "' has no errors" +
                         (problems.empty() ? "" : ", but " + count_text(problems)));
}

}  // namespace carom::cli
