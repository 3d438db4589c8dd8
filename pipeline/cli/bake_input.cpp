#include "pipeline/cli/bake_input.h"

#include "pipeline/cli/bake_reason.h"
#include "pipeline/cli/job_talk.h"

namespace carom::cli {

sim::Bake bake_of(const pipeline::Shot& shot, const std::string& path, const CacheOptions& cache,
                  CommandContext& context) {
    const BakeReason reason(shot, path, cache.folder);
    bool baked = false;
    sim::Bake bake = pipeline::bake_or_reuse(shot, cache.folder, talk_about_job(context.console),
                                             context.stop, &baked);
    context.console.end_progress();
    context.console.info(reason.text(baked));
    reason.remember();
    return bake;
}

}  // namespace carom::cli
