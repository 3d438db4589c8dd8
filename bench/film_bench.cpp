// What frames of a film cost: film_bench SHOT SECOND... [--samples N] [--avx2]. It simulates the
// shot, prepares the scene, and renders the frames at these seconds of the film with 640x360
// pixels, N even samples (64) and four bounces, on one thread, without the planes that a denoiser
// needs. For each frame it prints a line: the second, the CPU seconds of rendering alone, and
// millions of rays per CPU second. bench/films compares two versions of carom with it.
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <hwy/targets.h>

#include "core/cpu_time.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "render/frame/frame.h"
#include "render/threads/thread_arena.h"
#include "sim/bake.h"

namespace {

using namespace carom;

/// The planes that a denoiser needs are a cost of their own, which earlier versions do not have.
template <class Settings>
void without_features(Settings& settings) {
    if constexpr (requires { settings.for_denoiser; }) {
        settings.for_denoiser = false;
    }
}

pipeline::Shot load(const std::string& path, int samples) {
    pipeline::LoadResult loaded = pipeline::load_shot(path);
    if (!loaded.shot) {
        throw std::runtime_error("'" + path + "' has errors; see carom check");
    }
    render::RenderSettings& settings = loaded.shot->render;
    settings.width = 640;
    settings.height = 360;
    settings.integrator = render::IntegratorKind::path;
    settings.samples = samples;
    settings.noise = 0;
    settings.max_bounces = 4;
    without_features(settings);
    return std::move(*loaded.shot);
}

void render_frames(const pipeline::Shot& shot, const std::vector<double>& seconds) {
    sim::Bake bake;
    bake.timeline = sim::bake(shot.world);
    pipeline::add_keyed_motions(bake, shot);
    const pipeline::FilmSource source(shot, bake.timeline);
    const render::PreparedScene scene(shot.scene, shot.render);
    render::ThreadArena arena(1);
    for (const double second : seconds) {
        const auto frame =
            static_cast<std::int64_t>(std::llround(second * shot.timing.fps.to_double()));
        const pipeline::FrameInputs inputs = source.inputs(frame);
        const double begin = process_cpu_seconds();
        const render::Film film = arena.execute(
            [&] { return render::render_frame(scene, inputs.tracks, inputs.frame, shot.render); });
        const double cpu = process_cpu_seconds() - begin;
        const auto& count = film.statistics;
        const auto rays =
            static_cast<double>(count.camera_rays + count.scattered_rays + count.shadow_rays);
        std::printf("%g %.3f %.2f\n", second, cpu, rays / cpu / 1e6);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int count, char** words) {
    CLI::App options{"What frames of a film cost."};
    std::string path;
    std::vector<double> seconds;
    int samples = 64;
    options.add_option("shot", path, "The shot.")->required();
    options.add_option("seconds", seconds, "Times in the film, in seconds.")->required();
    options.add_option("--samples", samples, "Samples of each pixel.")->capture_default_str();
    bool is_narrow = false;
    options.add_flag("--avx2", is_narrow, "Vectors of at most eight numbers.");
    CLI11_PARSE(options, count, words);
    if (is_narrow) {
        hwy::DisableTargets(HWY_AVX3 | HWY_AVX3_DL);
    }
    try {
        render_frames(load(path, samples), seconds);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "film_bench: %s\n", error.what());
        return 1;
    }
}
