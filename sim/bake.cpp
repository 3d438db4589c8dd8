#include "sim/bake.h"

#include "sim/scheduler/scheduler.h"
#include "sim/timeline/error.h"

namespace carom::sim {

BakeResult bake(const WorldDescription& world, const WorkContext& context) {
    const std::vector<WorldProblem> problems = find_problems(world);
    if (!problems.empty())
        throw Error(problems.front().sentence);
    Scheduler scheduler(world);
    scheduler.run(context);
    BakeResult result;
    result.timeline = scheduler.take_timeline();
    result.warned_events = scheduler.warned_events();
    result.warnings = scheduler.take_warnings();
    return result;
}

}  // namespace carom::sim
