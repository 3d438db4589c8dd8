#include "sim/bake.h"

#include <limits>
#include <utility>

#include "sim/scheduler/prepared_world.h"
#include "sim/scheduler/scheduler.h"

namespace carom::sim {

std::optional<Timeline> bake_within(std::uint64_t max_steps, const WorldDescription& world,
                                    const WorkContext& context) {
    const PreparedWorld prepared(world);
    Scheduler scheduler(world, prepared.environment, Record::all);
    if (!scheduler.run(context, max_steps)) {
        return std::nullopt;
    }
    return scheduler.take_timeline();
}

Timeline bake(const WorldDescription& world, const WorkContext& context) {
    return std::move(*bake_within(std::numeric_limits<std::uint64_t>::max(), world, context));
}

}  // namespace carom::sim
