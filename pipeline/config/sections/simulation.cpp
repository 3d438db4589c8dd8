#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

const MapSpec<sim::KeyReduction>& key_reduction_spec() {
    static const MapSpec<sim::KeyReduction> spec = [] {
        MapSpec<sim::KeyReduction> s(
            "key_reduction", "Largest deviation of the stored timeline from the simulated one.");
        s.key("position_error", &sim::KeyReduction::position_error, length(inside(0, 1)),
              "largest error of a position between keys");
        s.key("orientation_error", &sim::KeyReduction::orientation_error, angle(inside(0, 1)),
              "largest error of an orientation between keys");
        return s;
    }();
    return spec;
}

}  // namespace

const MapSpec<sim::WorldDescription>& simulation_spec() {
    using World = sim::WorldDescription;
    static const MapSpec<World> spec = [] {
        MapSpec<World> s("simulation", "Duration, time step and seed of the simulation.");
        s.key("duration", &World::duration, time(above_up_to(0, 3600)),
              "length of the simulated scene time");
        s.key("step", &World::step, time(between(1e-5, 0.1)),
              "longest time step between two contacts");
        s.set(
            "seed", integer64(0, (std::int64_t{1} << 53U) - 1),
            [](World& world, std::int64_t seed) { world.seed = static_cast<std::uint64_t>(seed); },
            "seed of the random gaps in the rack and of the random orientations of the balls", "0");
        s.map("key_reduction", &World::key_reduction, key_reduction_spec(),
              "accuracy of the stored timeline");
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
