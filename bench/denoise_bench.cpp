// CPU seconds of the denoiser for pictures of usual sizes.
#include <benchmark/benchmark.h>

#include "render/denoise/denoise.h"
#include "render/threads/thread_arena.h"
#include "tests/render/denoise/noisy_picture.h"

namespace carom::render {
namespace {

void denoise_picture(benchmark::State& state) {
    const int width = static_cast<int>(state.range(0));
    const int height = static_cast<int>(state.range(1));
    test::NoisyPicture picture = test::discs(width, height, 1);
    if (state.range(2) != 0) {  // light that is seen directly
        picture.set_feature(7, [](int x, int y) { return x % 9 < 3 && y % 7 < 3 ? 4.0f : 0.0f; });
    }
    ThreadArena arena(1);
    for (auto _ : state) {
        benchmark::DoNotOptimize(arena.execute([&] { return denoise(picture.input()); }));
    }
    state.counters["CPU s per megapixel"] =
        benchmark::Counter(1e-6 * width * height * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK(denoise_picture)
    ->ArgNames({"width", "height", "light"})
    ->Args({640, 360, 0})
    ->Args({640, 360, 1})
    ->Args({1920, 1080, 1})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace carom::render
