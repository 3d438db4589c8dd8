#include "pipeline/cli/bake_input.h"

#include "pipeline/cli/job_talk.h"

namespace carom::cli {

sim::Bake bake_of(const pipeline::Shot& shot, const CacheOptions& cache, CommandContext& context) {
    bool baked = false;
    sim::Bake bake = pipeline::bake_or_reuse(shot, cache.folder, talk_about_job(context.console),
                                             context.stop, &baked);
    context.console.end_progress();
    context.console.info(baked ? "simulated the shot"
                               : "the physics is unchanged: using the bake that was kept");
    return bake;
}

}  // namespace carom::cli
