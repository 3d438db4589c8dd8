#include "pipeline/job/film_forecast.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

#include "core/cpu_time.h"
#include "core/error.h"
#include "pipeline/job/cpu_limit.h"
#include "pipeline/job/far_light.h"
#include "pipeline/job/film_probe.h"
#include "pipeline/job/film_sound.h"
#include "pipeline/job/forecast_sizes.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/job/memory_forecast.h"
#include "pipeline/job/shot_sound.h"
#include "pipeline/store/frame_store.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {
namespace {

/// The missing pictures of the plan, ascending.
std::vector<std::size_t> missing_pictures(const FilmPlan& plan,
                                          const std::vector<std::int64_t>& missing_frames,
                                          const FrameStore& store) {
    std::vector<bool> is_candidate(plan.pictures.size());
    for (std::size_t i = 0; i < plan.frames.size(); ++i) {
        if (std::binary_search(missing_frames.begin(), missing_frames.end(), plan.frames[i])) {
            is_candidate[plan.picture_of[i]] = true;
            if (const FilmPlan::Blend* blend = plan.blend_of(i)) {
                is_candidate[blend->picture] = true;
            }
        }
    }
    std::vector<std::size_t> pictures;
    for (std::size_t i = 0; i < plan.pictures.size(); ++i) {
        if (is_candidate[i] && !store.is_intact(plan.pictures[i].key)) {
            pictures.push_back(i);
        }
    }
    return pictures;
}

/// Mean and squared standard error.
struct Estimate {
    double mean = 0;
    double variance = 0;
};

/// Of the seconds per picture of a camera, from its sites.
Estimate estimate(const std::vector<double>& seconds) {
    Estimate result;
    const auto count = static_cast<double>(seconds.size());
    for (const double value : seconds) {
        result.mean += value / count;
    }
    for (const double value : seconds) {
        result.variance += (value - result.mean) * (value - result.mean) / count;
    }
    // A single place of the film says nothing about the others; they differ by a quarter or so.
    constexpr double kOnePlace = 0.25;
    result.variance = count > 1 ? result.variance / (count - 1)
                                : kOnePlace * kOnePlace * result.mean * result.mean;
    return result;
}

void add_times(const FilmProbe& probe, FilmForecast& forecast) {
    std::vector<std::vector<double>> by_camera(probe.cameras().size());
    std::vector<double> all;
    double serial = 0;
    for (const SiteMeasurement& site : probe.sites()) {
        const double seconds = site.frames.front().frame_seconds();
        by_camera[site.site.camera].push_back(seconds);
        all.push_back(seconds);
        serial += site.frames.front().preparation_seconds();
    }
    double total = 0;
    double variance = 0;
    for (std::size_t i = 0; i < by_camera.size(); ++i) {
        // A camera that could not be measured in time is taken for an average one.
        const Estimate of_one = estimate(by_camera[i].empty() ? all : by_camera[i]);
        const auto pictures = static_cast<double>(probe.cameras()[i].pictures.size());
        total += pictures * of_one.mean;
        variance += pictures * pictures * of_one.variance;
    }
    const auto pictures = static_cast<double>(forecast.pictures);
    forecast.seconds_per_picture = total / pictures;
    forecast.serial_per_picture = serial / static_cast<double>(all.size());
    forecast.error = 2 * std::sqrt(variance) / total;
}

}  // namespace

double FilmForecast::elapsed_seconds(int workers, int threads) const {
    const auto processes = static_cast<double>(std::max(1, workers));
    const auto at_once = static_cast<double>(std::max(1, threads));
    const double picture =
        serial_per_picture + (seconds_per_picture - serial_per_picture) / at_once;
    const double rendering = std::ceil(static_cast<double>(pictures) / processes) * picture;
    const double before = preparation_seconds;
    return workers > 1 ? before + rendering + encoding_seconds / at_once
                       : std::max(before + rendering, cpu_seconds() / at_once);
}

int thread_count(int threads) {
    return threads > 0 ? threads
                       : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

FilmForecast forecast_film(const Shot& shot, const sim::Bake& bake,
                           const std::vector<std::int64_t>& missing, const FilmJobOptions& options,
                           const std::stop_token& stop, const ForecastSettings& settings) {
    FilmForecast forecast;
    forecast.memory_bytes = forecast_memory(shot, options.output, options.keeps_sums);
    const FilmSource source(shot, bake.timeline);
    const FilmPlan plan = plan_film(source, job_frames(shot, options), stop);
    forecast.frames = std::ssize(plan.frames);
    const std::vector<std::size_t> pictures = missing_pictures(plan, missing, open_store(options));
    forecast.pictures = std::ssize(pictures);
    if (pictures.empty()) {
        return forecast;
    }
    const double begin = process_cpu_seconds();
    constexpr double kForBlocks = 0.93;  // of the time; the rest is for measuring files
    const double seconds = kForBlocks * settings.cpu_limit;
    CpuLimit limit(seconds, stop);
    render::ThreadArena arena(options.threads);
    const FrameStore store = open_store(options);
    arena.execute([&] {
        const render::PreparedScene scene(
            shot.scene, shot.render,
            render::structure_maker(options.structures, shot.render.acceleration),
            quick_far_light(shot.scene, &store, {{}, limit.token()}));
        forecast.preparation_seconds = process_cpu_seconds() - begin;
        FilmProbe probe(source, plan, pictures);
        probe.measure(scene, has_sequences(shot, options.output),
                      {settings.cpu_at_least, seconds - forecast.preparation_seconds},
                      limit.token());
        if (stop.stop_requested()) {
            throw Stopped();
        }
        if (probe.sites().empty()) {
            throw Error(
                "the film cannot be forecast: its scene alone takes longer to prepare than "
                "the forecast may take");
        }
        add_times(probe, forecast);
        add_sizes(source, plan, probe, options.output, forecast);
        if (forecast.film_bytes > 0) {
            forecast.film_bytes += static_cast<std::uint64_t>(sound_bytes(
                job_sound(options, shot, source.timeline(), stop), shot.output, options.output,
                {frame_count(shot.cameras, shot.timing), shot.timing.fps}, plan.frames));
        }
    });
    forecast.probe_seconds = process_cpu_seconds() - begin;
    return forecast;
}

}  // namespace carom::pipeline
