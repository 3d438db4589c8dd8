#include "sim/bake.h"

#include <limits>

#include "core/error.h"
#include "sim/scheduler/scheduler.h"

namespace carom::sim {

std::optional<BakeResult> bake_within(std::uint64_t most_steps, const WorldDescription& world,
                                      const WorkContext& context) {
    const std::vector<WorldProblem> problems = find_problems(world);
    if (!problems.empty()) {
        throw Error(problems.front().sentence);
    }
    Scheduler scheduler(world);
    if (!scheduler.run(context, most_steps)) {
        return std::nullopt;
    }
    BakeResult result;
    result.timeline = scheduler.take_timeline();
    result.warned_events = scheduler.warned_events();
    result.warnings = scheduler.take_warnings();
    return result;
}

BakeResult bake(const WorldDescription& world, const WorkContext& context) {
    return std::move(*bake_within(std::numeric_limits<std::uint64_t>::max(), world, context));
}

}  // namespace carom::sim
