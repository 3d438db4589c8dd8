#include "pipeline/cli/bake_input.h"

#include "pipeline/check/motion_check.h"
#include "pipeline/cli/bake_reason.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/picture/lit_annotations.h"
#include "pipeline/store/cache_folder.h"

namespace carom::cli {

namespace {

sim::Bake obtain_bake_of_shot(const ShotInput& input, const std::string& path,
                              const CacheOptions& cache, CommandContext& context) {
    const std::string folder =
        cache.no_store ? pipeline::readable_cache_folder(cache.folder) : cache.folder;
    const BakeReason reason(input.shot, path, folder);
    const auto bake = cache.no_store ? pipeline::bake_without_store : pipeline::bake_or_reuse;
    pipeline::BakedShot baked =
        bake(input.shot, folder, make_console_observer(context.console), context.stop);
    context.console.end_progress();
    context.console.info(reason.text(baked.origin));
    if (!cache.no_store) {
        reason.save_record();
    }
    return std::move(baked.bake);
}

/// Camera problems are warnings here. Commands that render the frames in question report them as
/// errors.
void report_cameras(const ShotInput& input, const sim::Timeline& timeline, Console& console) {
    std::vector<pipeline::Problem> problems = pipeline::camera_problems(
        input.shot, input.has_own_cameras ? input.source.get() : nullptr, timeline);
    for (pipeline::Problem& problem : problems) {
        problem.severity = pipeline::Severity::warning;
    }
    report_problems(problems, console);
}

void give_moments(ShotInput& input, const InputOptions& options, const sim::Timeline& timeline,
                  Console& console) {
    const std::vector<pipeline::Problem> problems =
        pipeline::resolve_moments(input.shot, input.source, timeline);
    report_problems(problems, console);
    if (pipeline::has_errors(problems)) {
        throw InputError("'" + options.path + "' has " + count_text(problems));
    }
}

}  // namespace

void know_motion(ShotInput& input, const InputOptions& options, const CacheOptions& cache,
                 CommandContext& context) {
    if (!input.bake) {
        input.bake = obtain_bake_of_shot(input, options.path, cache, context);
    }
    give_moments(input, options, input.bake->timeline, context.console);
    pipeline::add_lit_annotations(input.shot, input.bake->timeline);
}

sim::Bake obtain_bake(ShotInput& input, const InputOptions& options, const CacheOptions& cache,
                      CommandContext& context) {
    sim::Bake bake;
    if (input.bake) {
        pipeline::add_keyed_motions(*input.bake, input.shot);  // --set may have changed them
        bake = std::move(*input.bake);
    } else {
        bake = obtain_bake_of_shot(input, options.path, cache, context);
    }
    report_problems(pipeline::simulation_problems(bake.timeline, input.source.get()),
                    context.console);
    report_problems(pipeline::stick_problems(input.shot, input.source.get(), bake.timeline),
                    context.console);
    give_moments(input, options, bake.timeline, context.console);
    pipeline::add_lit_annotations(input.shot, bake.timeline);
    report_cameras(input, bake.timeline, context.console);
    return bake;
}

sim::Timeline read_timeline_of_bake(const std::string& path, Console& console) {
    sim::Timeline timeline = read_bake_input(path).timeline;
    report_problems(pipeline::simulation_problems(timeline, nullptr), console);
    return timeline;
}

}  // namespace carom::cli
