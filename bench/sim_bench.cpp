// Complete bakes. Each checks its result, so that a fast wrong answer does not pass.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include "core/splitmix.h"
#include "sim/aim/find_aims.h"
#include "sim/bake.h"
#include "sim/billiards/rack.h"
#include "sim/trials.h"

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

/// Break number `number`: its own gaps in the rack and its own place of the cue ball.
WorldDescription break_of(billiards::RackKind kind, double duration, int number) {
    WorldDescription world;
    world.duration = duration;
    world.table = billiards::standard_table(billiards::TableKind::pool, "9 ft");
    world.bodies.push_back(ball("cue", {-0.75, 0.01 * number, kRadius}));
    const auto seed = static_cast<std::uint64_t>(number);
    for (const auto& placed : billiards::rack(kind, *world.table, kRadius, {3e-5, seed})) {
        world.bodies.push_back(ball(placed.name, placed.position));
    }
    Strike strike;
    strike.ball_speed = 11;
    strike.toward = "one";
    strike.tip = {0, 0.3};
    ForceEvent event;
    event.object = "cue";
    event.time = 0.5;
    event.action = strike;
    world.events.push_back(event);
    return world;
}

/// `count` balls on a table with 0.2 m^2 of cloth per ball (16 on one of 9 ft) with cushions, with
/// random velocities.
WorldDescription crowd(int count, double duration, bool has_pockets) {
    WorldDescription world;
    world.duration = duration;
    world.table = billiards::standard_table(billiards::TableKind::pool, "9 ft");
    world.table->kind = billiards::TableKind::custom;
    world.table->width = std::sqrt(0.1 * count);
    world.table->length = 2 * world.table->width;
    if (!has_pockets) {
        world.table->corner_pocket.reset();
        world.table->side_pocket.reset();
    }
    const int rows = static_cast<int>(std::sqrt(count / 2.0));
    const int columns = (count + rows - 1) / rows;
    const Vec2 step(world.table->length / columns, world.table->width / rows);
    SplitMix64 random(1);
    const auto uniform = [&random] { return random.between(-1, 1); };
    for (int i = 0; i < count; ++i) {
        const double x = (i / rows + 0.5) * step.x - world.table->length / 2;
        const double y = (i % rows + 0.5) * step.y - world.table->width / 2;
        world.bodies.push_back(ball(fmt::format("ball{}", i), {x, y, kRadius}));
        Vec3& velocity = world.bodies.back().velocity;
        velocity.x = 4 * uniform();
        velocity.y = 4 * uniform();
    }
    return world;
}

void growth(benchmark::State& state, bool has_pockets) {
    const WorldDescription world = crowd(static_cast<int>(state.range(0)), 4, has_pockets);
    std::size_t impacts = 0;
    for (auto _ : state) {
        const Timeline result = bake(world);
        impacts = 0;
        bool has_left = false;
        for (const Event& event : result.events) {
            impacts += event.kind == EventKind::impact ? 1 : 0;
            has_left = has_left || (!has_pockets && event.kind == EventKind::airborne);
        }
        if (!result.warnings.empty() || has_left || impacts < world.bodies.size()) {
            state.SkipWithError("the crowd went wrong");
        }
        benchmark::DoNotOptimize(result);
    }
    state.counters["impacts_per_ball"] =
        static_cast<double>(impacts) / static_cast<double>(world.bodies.size());
    state.counters["s_per_impact"] =
        benchmark::Counter(static_cast<double>(impacts) * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The mean over twenty breaks: the time of one depends on the number of balls that are potted.
void break_shot(benchmark::State& state, billiards::RackKind kind) {
    constexpr int kBreaks = 20;
    constexpr double kDuration = 10;  // s
    std::vector<WorldDescription> worlds;
    for (int number = 1; number <= kBreaks; ++number) {
        worlds.push_back(break_of(kind, kDuration, number));
    }
    for (auto _ : state) {
        for (const WorldDescription& world : worlds) {
            const Timeline result = bake(world);
            if (result.events.size() < 50) {
                state.SkipWithError("the break went wrong");
            }
            benchmark::DoNotOptimize(result);
        }
    }
    state.counters["per_simulated_s"] =
        benchmark::Counter(kBreaks * kDuration * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// A strike that pots the ball "one" in some of the shot's variants only.
void aim_at_one(WorldDescription& world, double direction, double ball_speed) {
    world.events[0].time = 0;
    auto& strike = std::get<Strike>(world.events[0].action);
    strike.toward.reset();
    strike.direction = direction;
    strike.ball_speed = ball_speed;
}

/// Variants of one shot: up to 0.04 of its direction (rad) and speed (doubled) to both sides.
std::vector<ForceEvent> variant(const WorldDescription& world, int number) {
    std::vector<ForceEvent> events = world.events;
    auto& strike = std::get<Strike>(events[0].action);
    *strike.direction += 0.002 * (number % 41 - 20);
    *strike.ball_speed *= 1 + 0.05 * (number % 20);
    return events;
}

/// A cut shot of 12 s: the cue ball and one object ball on a table with pockets.
WorldDescription cut_shot() {
    WorldDescription world = break_of(billiards::RackKind::nine_ball, 12, 0);
    world.bodies = {ball("cue", {-0.6, 0.1, kRadius}), ball("one", {0.5, -0.2, kRadius})};
    aim_at_one(world, -0.266, 2);
    return world;
}

void check_variants(benchmark::State& state, std::size_t potted, int variants) {
    if (potted == 0 || potted == static_cast<std::size_t>(variants)) {
        state.SkipWithError("all variants are alike");
    }
    state.counters["shots_per_s"] = benchmark::Counter(
        variants * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

bool pots_one(const std::vector<Event>& events) {
    return std::any_of(events.begin(), events.end(), [](const Event& event) {
        return event.kind == EventKind::potted && event.a == "one";
    });
}

/// Variants of a nine-ball break of 10 s.
WorldDescription nine_ball_break() {
    WorldDescription world = break_of(billiards::RackKind::nine_ball, 10, 1);
    aim_at_one(world, 0, 6);
    return world;
}

/// That many variants, each baked by itself.
void shots_as_bakes(benchmark::State& state, const WorldDescription& world, int variants) {
    std::size_t potted = 0;
    for (auto _ : state) {
        potted = 0;
        for (int number = 0; number < variants; ++number) {
            WorldDescription changed = world;
            changed.events = variant(world, number);
            potted += pots_one(bake(changed).events) ? 1 : 0;
        }
    }
    check_variants(state, potted, variants);
}

/// `stops`: at the pot, or when the ball meets a cushion or stops.
void shots_as_trials(benchmark::State& state, const WorldDescription& world, int variants,
                     bool stops) {
    TrialLimits limits;
    if (stops) {
        limits.is_answered = [](const Event& event) {
            return event.a == "one" && (event.kind == EventKind::potted ||
                                        event.kind == EventKind::resting || event.b == "cushion");
        };
    }
    std::size_t potted = 0;
    for (auto _ : state) {
        potted = 0;
        const Trials trials(world);
        for (int number = 0; number < variants; ++number) {
            potted += pots_one(trials.run(variant(world, number), limits)->events) ? 1 : 0;
        }
    }
    check_variants(state, potted, variants);
}

/// The direction of a strike that shall pot the ball of a cut shot, or cut it by 30 degrees.
void aim(benchmark::State& state, const Aim& aim) {
    const WorldDescription world = cut_shot();
    for (auto _ : state) {
        const FoundAims found = find_aims(world, {{0, aim}});
        if (!found.problems.empty()) {
            state.SkipWithError("the direction was not found");
            return;
        }
        state.counters["trials"] = found.directions[0].trials;
    }
}

/// `count` boxes that rest apart from each other, and one that slides past them.
void resting_boxes(benchmark::State& state) {
    const auto box = [](const std::string& name, const Vec3& place) {
        Body body = ball(name, place);
        body.shape = Box{{0.02, 0.02, 0.02}};
        body.mass = 0.02;
        body.material = "wood";
        return body;
    };
    WorldDescription world;
    world.duration = 2;
    world.table = billiards::standard_table(billiards::TableKind::cloth, "");
    for (int i = 0; i < static_cast<int>(state.range(0)); ++i) {
        world.bodies.push_back(
            box(fmt::format("box{}", i), {0.05 * (i % 20), 0.2 + 0.05 * (i / 20), 0.010001}));
    }
    world.bodies.push_back(box("slider", {0, 0, 0.010001}));
    world.bodies.back().velocity = {3, 0, 0};
    for (auto _ : state) {
        const Timeline result = bake(world);
        if (!result.warnings.empty() || result.find("slider")->keys().back().position.x < 0.5) {
            state.SkipWithError("the box did not slide");
        }
        benchmark::DoNotOptimize(result);
    }
}

}  // namespace

BENCHMARK_CAPTURE(shots_as_bakes, cut, cut_shot(), 200)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shots_as_trials, cut_to_the_end, cut_shot(), 200, false)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shots_as_trials, cut_until_answered, cut_shot(), 200, true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shots_as_bakes, nine_ball, nine_ball_break(), 20)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shots_as_trials, nine_ball, nine_ball_break(), 20, false)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(aim, pot, PotAim{"one", ""})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(aim, cut, CutAim{"one", 0.52, Side::left})->Unit(benchmark::kMillisecond);
BENCHMARK(resting_boxes)->Arg(100)->Arg(400)->Arg(1600)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(break_shot, nine_ball, billiards::RackKind::nine_ball)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(break_shot, fifteen_ball, billiards::RackKind::fifteen_ball)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(growth, cushions, false)
    ->RangeMultiplier(4)
    ->Range(16, 1024)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(growth, cushions_and_pockets, true)
    ->RangeMultiplier(4)
    ->Range(16, 1024)
    ->Unit(benchmark::kMillisecond);
