// The cost of looking up a texture's colour: one point at a time, and in vector lanes, of AVX2 or
// as wide as the machine has. The argument is the width of a pixel, um.
#include <array>
#include <string>

#include <benchmark/benchmark.h>

#include "tests/render/texture/every_texture.h"
#include "tests/render/texture/texture_lanes.h"
#include "tests/render/texture/texture_values.h"

namespace carom::render {
namespace {

constexpr std::size_t kPoints = 4096;

struct Lookups {
    std::vector<SurfacePoint> points;
    test::PointLists lists;
    float footprint = 0;
};

/// Points of one footprint, as neighbouring pixels have.
Lookups lookups(std::int64_t micrometres) {
    Lookups made;
    made.footprint = static_cast<float>(micrometres) * 1e-6f;
    test::TestRandom random(3);
    for (std::size_t i = 0; i < kPoints; ++i) {
        made.points.push_back(test::random_texture_point(random));
        made.lists.add(made.points.back(), made.footprint);
    }
    return made;
}

const Texture& texture_named(const std::string& name) {
    for (const test::NamedTexture& one : test::every_texture()) {
        if (one.name == name) {
            return one.texture;
        }
    }
    throw Error("no texture '" + name + "'");
}

void count_lookups(benchmark::State& state) {
    state.counters["per_lookup"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(kPoints),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void one_by_one(benchmark::State& state, const std::string& name) {
    const Texture& texture = texture_named(name);
    const Lookups asked = lookups(state.range(0));
    for (auto _ : state) {
        for (const SurfacePoint& point : asked.points) {
            benchmark::DoNotOptimize(test::colour_of(texture, point, asked.footprint));
        }
    }
    count_lookups(state);
}

void in_lanes(benchmark::State& state, const std::string& name, std::string_view target) {
    const Texture& texture = texture_named(name);
    const Lookups asked = lookups(state.range(0));
    test::TextureLanes lanes = test::best_texture_lanes();
    test::for_every_target([&](const test::TextureLanes& one) {
        if (one.target == target) {
            lanes = one;
        }
    });
    std::array<std::vector<float>, 3> colour;
    colour.fill(std::vector<float>(kPoints));
    float* const pointers[3] = {colour[0].data(), colour[1].data(), colour[2].data()};
    for (auto _ : state) {
        lanes.colours(texture.data(), asked.lists, pointers);
        benchmark::DoNotOptimize(pointers[0]);
        benchmark::ClobberMemory();
    }
    count_lookups(state);
    state.SetLabel(std::string(lanes.target));
}

#define CAROM_LOOKUPS(id, name)                                                             \
    BENCHMARK_CAPTURE(one_by_one, id, std::string(name))->Arg(100)->Arg(2000);              \
    BENCHMARK_CAPTURE(in_lanes, id, std::string(name), std::string_view("AVX2"))            \
        ->Arg(100)                                                                          \
        ->Arg(2000);                                                                        \
    BENCHMARK_CAPTURE(in_lanes, id##_widest, std::string(name), std::string_view("widest")) \
        ->Arg(100)                                                                          \
        ->Arg(2000)

CAROM_LOOKUPS(cloth, "cloth");
CAROM_LOOKUPS(wood, "wood");
CAROM_LOOKUPS(ball, "ball with a number");
CAROM_LOOKUPS(image, "image by uv");
CAROM_LOOKUPS(checker, "checker");

}  // namespace
}  // namespace carom::render
