#include "sim/scheduler/prepared_world.h"

#include <utility>

#include "core/error.h"
#include "sim/start_overlaps.h"

namespace carom::sim {
namespace {

const WorldDescription& checked(const WorldDescription& world) {
    require_none(find_problems(world));
    return world;
}

const billiards::TableGeometry* table_of(const StaticEnvironment& environment) {
    return environment.has_cushions ? &environment.table() : nullptr;
}

}  // namespace

PreparedWorld::PreparedWorld(const WorldDescription& world) : environment(checked(world)) {
    const auto overlaps = find_start_overlaps(world, table_of(environment));
    if (!overlaps.empty()) {
        throw Error("body '" + overlaps[0].body + "' " + overlaps[0].sentence() + " at the start");
    }
    require_free_places(world, environment);
}

void require_free_places(const WorldDescription& world, const StaticEnvironment& environment) {
    require_none(find_place_problems(world, table_of(environment)));
}

void require_none(const std::vector<Diagnostic>& problems) {
    if (!problems.empty()) {
        throw Error(problems.front().sentence);
    }
}

}  // namespace carom::sim
