// carom cache push and pull for one film.
#include <set>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/cache_copies.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/job_frames.h"

namespace carom::cli {

void run_for_shot(const CacheCommand& command, CommandContext& context) {
    ShotInput input = read_film_input(command.input, FileReading::none, context);
    const pipeline::FilmJobOptions options = job_options(command.cache, command.frames, {});
    (void)count_job_frames(input.shot, options, command.frames, context.console);
    // The keys of the frames follow from the motion.
    const sim::Bake bake = obtain_bake(input, command.input, command.cache, context);
    const pipeline::FilmSource source(input.shot, bake.timeline);
    const pipeline::FilmPlan plan =
        plan_film(source, job_frames(input.shot, options), context.stop);
    const std::vector<Hash128> keys = keys_of(plan, bake);
    copy_between_caches(command, std::set<Hash128>(keys.begin(), keys.end()), context);
}

}  // namespace carom::cli
