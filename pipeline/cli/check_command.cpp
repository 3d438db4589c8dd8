#include <algorithm>
#include <cstdint>
#include <iterator>

#include <fmt/core.h>

#include "pipeline/check/motion_check.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/job/film_job.h"
#include "pipeline/video/video_format.h"
#include "sim/bake.h"

namespace carom::cli {

namespace {

using pipeline::Problem;

/// The limit of a simulation that only checks a shot, in steps as bake_within counts them, so that
/// a check gives the same result on any machine. This many steps take a few seconds.
constexpr std::uint64_t kMaxSteps = 15'000'000;

/// Simulates the shot without writing to the cache, since a check writes no files. Empty if it
/// takes more than kMaxSteps.
std::optional<sim::Bake> simulate(const pipeline::Shot& shot, const std::stop_token& stop) {
    WorkContext context;
    context.stop = stop;
    std::optional<sim::Timeline> timeline = sim::bake_within(kMaxSteps, shot.world, context);
    if (!timeline) {
        return std::nullopt;
    }
    sim::Bake bake;
    bake.timeline = std::move(*timeline);
    pipeline::add_keyed_motions(bake, shot);
    return bake;
}

/// The input's bake, or the cached bake, or a simulation.
std::optional<sim::Bake> obtain_bake(ShotInput& input, const CacheOptions& cache,
                                     CommandContext& context) {
    if (input.bake) {
        pipeline::add_keyed_motions(*input.bake, input.shot);
        return std::move(input.bake);
    }
    std::optional<sim::Bake> cached = pipeline::find_cached_bake(input.shot, cache.folder, {});
    return cached ? std::move(cached) : simulate(input.shot, context.stop);
}

void check_motion(ShotInput& input, const CheckCommand& command, CommandContext& context,
                  std::vector<Problem>& problems) {
    const std::optional<sim::Bake> bake = obtain_bake(input, command.cache, context);
    if (!bake) {
        context.console.info(
            fmt::format("the motion was not checked, because simulating it takes more than {} "
                        "million steps; to check it, run 'carom bake' first",
                        kMaxSteps / 1'000'000));
        return;
    }
    const auto add = [&](std::vector<Problem> found) {
        std::move(found.begin(), found.end(), std::back_inserter(problems));
    };
    add(pipeline::simulation_problems(bake->timeline, input.source.get()));
    add(pipeline::cloth_problems(input.shot, input.source.get(), bake->timeline));
    add(pipeline::annotation_problems(input.shot, input.source.get(), bake->timeline));
    add(pipeline::camera_problems(input.shot, input.source.get(), bake->timeline));
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

std::string json_of(const std::vector<Problem>& problems) {
    std::string text = "[";
    for (const Problem& problem : problems) {
        text += (text.size() > 1 ? ",\n" : "\n") + members_of(problem).object();
    }
    return text + (problems.empty() ? "]\n" : "\n]\n");
}

}  // namespace

void run(const CheckCommand& command, CommandContext& context) {
    CheckedInput checked = load_shot_input(command.input);
    std::vector<Problem>& problems = checked.problems;
    if (checked.input) {
        check_film_file(*checked.input, problems);
        if (!command.quick && !pipeline::has_errors(problems)) {
            check_motion(*checked.input, command, context, problems);
        }
    }
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
