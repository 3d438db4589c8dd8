// Whole bakes. Each one checks its result, so that a fast wrong answer does not pass.
#include <benchmark/benchmark.h>

#include "sim/bake.h"
#include "sim/billiards/rack.h"

namespace {

using namespace carom;
using namespace carom::sim;

constexpr double kRadius = 0.028575;

Body ball(const std::string& name, const Vec3& place) {
    Body body;
    body.name = name;
    body.shape = Sphere{kRadius};
    body.pose.position = place;
    return body;
}

WorldDescription break_of(billiards::RackKind kind, double duration) {
    WorldDescription world;
    world.duration = duration;
    world.table = billiards::standard_table(billiards::TableKind::pool, "9 ft");
    world.bodies.push_back(ball("cue", {-0.75, 0.12, kRadius}));
    for (const auto& placed : billiards::rack(kind, *world.table, kRadius, {3e-5, 7}))
        world.bodies.push_back(ball(placed.name, placed.position));
    Strike strike;
    strike.speed = 9.2;
    strike.toward = "one";
    strike.tip = {0, 0.3};
    ForceEvent event;
    event.object = "cue";
    event.time = 0.5;
    event.action = strike;
    world.events.push_back(event);
    return world;
}

void break_shot(benchmark::State& state, billiards::RackKind kind) {
    const WorldDescription world = break_of(kind, 10);
    for (auto _ : state) {
        const BakeResult result = bake(world);
        if (!result.warnings.empty() || result.timeline.events.size() < 50)
            state.SkipWithError("the break went wrong");
        benchmark::DoNotOptimize(result);
    }
    state.counters["per_1000_simulated_s"] =
        benchmark::Counter(10e-3 * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

}  // namespace

BENCHMARK_CAPTURE(break_shot, nine_ball, billiards::RackKind::nine_ball)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(break_shot, fifteen_ball, billiards::RackKind::fifteen_ball)
    ->Unit(benchmark::kMillisecond);
