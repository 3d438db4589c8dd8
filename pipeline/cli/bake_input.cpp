#include "pipeline/cli/bake_input.h"

#include "pipeline/check/motion_check.h"
#include "pipeline/cli/bake_reason.h"
#include "pipeline/cli/job_talk.h"

namespace carom::cli {

namespace {

sim::Bake bake_of_shot(const ShotInput& input, const std::string& path, const CacheOptions& cache,
                       CommandContext& context) {
    const BakeReason reason(input.shot, path, cache.folder);
    auto origin = pipeline::BakeOrigin::made;
    std::vector<pipeline::SimulationWarning> warnings;
    sim::Bake bake =
        pipeline::bake_or_reuse(input.shot, cache.folder, talk_about_job(context.console),
                                context.stop, &origin, &warnings);
    context.console.end_progress();
    std::vector<pipeline::Problem> problems;
    problems.reserve(warnings.size());
    for (const pipeline::SimulationWarning& warning : warnings) {
        problems.push_back(
            pipeline::simulation_problem(warning.sentence, warning.event, input.source.get()));
    }
    report_problems(problems, context.console);
    context.console.info(reason.text(origin));
    reason.remember();
    return bake;
}

/// A camera that makes no picture stops only those who want its picture; they say so themselves.
void report_cameras(const ShotInput& input, const sim::Timeline& timeline, Console& console) {
    std::vector<pipeline::Problem> problems = pipeline::camera_problems(
        input.shot, input.has_own_cameras ? input.source.get() : nullptr, timeline);
    for (pipeline::Problem& problem : problems) {
        problem.severity = pipeline::Severity::warning;
    }
    report_problems(problems, console);
}

}  // namespace

sim::Bake bake_of(ShotInput& input, const InputOptions& options, const CacheOptions& cache,
                  CommandContext& context) {
    sim::Bake bake;
    if (input.bake) {
        pipeline::add_keyed_motions(*input.bake, input.shot);  // --set may have changed them
        bake = std::move(*input.bake);
    } else {
        bake = bake_of_shot(input, options.path, cache, context);
    }
    report_cameras(input, bake.timeline, context.console);
    return bake;
}

}  // namespace carom::cli
