#include "pipeline/cli/quick_bake.h"

#include <utility>

#include "pipeline/job/film_job.h"
#include "pipeline/store/cache_folder.h"
#include "sim/bake.h"

namespace carom::cli {

namespace {

std::optional<sim::Bake> simulate(const pipeline::Shot& shot, const std::stop_token& stop) {
    WorkContext context;
    context.stop = stop;
    std::optional<sim::Timeline> timeline = sim::bake_within(kMostQuickSteps, shot.world, context);
    if (!timeline) {
        return std::nullopt;
    }
    sim::Bake bake;
    bake.timeline = std::move(*timeline);
    pipeline::add_keyed_motions(bake, shot);
    return bake;
}

}  // namespace

std::optional<sim::Bake> quick_bake(ShotInput& input, const std::string& cache,
                                    CommandContext& context) {
    if (input.bake) {
        pipeline::add_keyed_motions(*input.bake, input.shot);
        return std::move(input.bake);
    }
    std::optional<sim::Bake> cached =
        pipeline::find_cached_bake(input.shot, pipeline::readable_cache_folder(cache), {});
    return cached ? std::move(cached) : simulate(input.shot, context.stop);
}

}  // namespace carom::cli
