#include "pipeline/cli/bake_input.h"

#include "pipeline/check/motion_check.h"
#include "pipeline/cli/bake_reason.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/picture/lit_annotations.h"
#include "pipeline/store/cache_folder.h"

namespace carom::cli {

namespace {

bool has_folder(const CacheOptions& cache) {
    try {
        return !cache.folder.empty() || !pipeline::default_cache_folder().empty();
    } catch (const pipeline::CacheUnusable&) {
        return false;
    }
}

/// Only a film needs a folder for the cache.
bool keeps_nothing(const CacheOptions& cache, Subject subject) {
    return cache.no_store || (subject != Subject::film && !has_folder(cache));
}

sim::Bake obtain_bake_of_shot(const ShotInput& input, const std::string& path,
                              const CacheOptions& cache, Subject subject, CommandContext& context) {
    const bool is_unstored = keeps_nothing(cache, subject);
    const std::string folder =
        is_unstored ? pipeline::readable_cache_folder(cache.folder) : cache.folder;
    const BakeReason reason(input.shot, path, folder);
    const auto bake = is_unstored ? pipeline::bake_without_store : pipeline::bake_or_reuse;
    pipeline::BakedShot baked =
        bake(input.shot, folder, make_console_observer(context.console), context.stop);
    context.console.end_progress();
    context.console.info(reason.text(baked.origin));
    if (!is_unstored) {
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
                  Subject subject, Console& console) {
    const std::vector<pipeline::Problem> problems =
        subject == Subject::film
            ? pipeline::resolve_moments(input.shot, input.source, timeline)
            : pipeline::resolve_known_moments(input.shot, input.source, timeline);
    report_problems(problems, console);
    if (pipeline::has_errors(problems)) {
        throw InputError("'" + options.path + "' has " + count_text(problems));
    }
}

}  // namespace

void know_motion(ShotInput& input, const InputOptions& options, const CacheOptions& cache,
                 CommandContext& context) {
    if (!input.bake) {
        input.bake = obtain_bake_of_shot(input, options.path, cache, Subject::film, context);
    }
    give_moments(input, options, input.bake->timeline, Subject::film, context.console);
    pipeline::add_lit_annotations(input.shot, input.bake->timeline);
}

sim::Bake obtain_bake(ShotInput& input, const InputOptions& options, const CacheOptions& cache,
                      CommandContext& context, Subject subject) {
    sim::Bake bake;
    if (input.bake) {
        pipeline::add_keyed_motions(*input.bake, input.shot);  // --set may have changed them
        bake = std::move(*input.bake);
    } else {
        bake = obtain_bake_of_shot(input, options.path, cache, subject, context);
    }
    report_problems(pipeline::simulation_problems(bake.timeline, input.source.get()),
                    context.console, true);
    if (subject != Subject::motion) {
        report_problems(pipeline::stick_problems(input.shot, input.source.get(), bake.timeline),
                        context.console);
    }
    give_moments(input, options, bake.timeline, subject, context.console);
    pipeline::add_lit_annotations(input.shot, bake.timeline);
    if (subject != Subject::motion) {
        report_cameras(input, bake.timeline, context.console);
    }
    return bake;
}

sim::Timeline read_timeline_of_bake(const InputOptions& input, Console& console) {
    sim::Timeline timeline = read_bake_input(input).timeline;
    report_problems(pipeline::simulation_problems(timeline, nullptr), console, true);
    return timeline;
}

}  // namespace carom::cli
