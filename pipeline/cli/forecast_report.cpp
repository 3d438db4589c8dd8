#include "pipeline/cli/forecast_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/job/memory_forecast.h"
#include "pipeline/store/cache_maintenance.h"

namespace carom::cli {
namespace {

/// The stated uncertainty, in steps of 5 %. Measured forecasts deviate by up to a fifth more often
/// than their samples alone tell (docs/developers/forecast.md), since machines are not always
/// equally fast.
int percent(double error) {
    constexpr double kLeast = 0.2;
    constexpr double kMost = 0.95;
    return 5 * static_cast<int>(std::ceil(20 * std::clamp(error, kLeast, kMost)));
}

}  // namespace

std::string forecast_text(const pipeline::FilmForecast& forecast, int threads) {
    std::string text = fmt::format(
        "about {} of processor time (give or take {} %), {} on {} {}; {} of memory, {} in the "
        "cache",
        duration_text(forecast.cpu_seconds()), percent(forecast.error),
        duration_text(forecast.elapsed_seconds(1, threads)), threads,
        threads == 1 ? "processor" : "processors", pipeline::memory_text(forecast.memory_bytes),
        pipeline::size_text(forecast.store_bytes));
    if (forecast.film_bytes > 0) {
        text += ", a film of " + pipeline::size_text(forecast.film_bytes);
    }
    return text;
}

void report_forecast(const pipeline::FilmForecast& forecast, int threads, Console& console) {
    const auto bytes = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
    JsonMembers members;
    members.add("frames", forecast.frames)
        .add("pictures", forecast.pictures)
        .add("cpu_seconds", forecast.cpu_seconds())
        .add("elapsed_seconds", forecast.elapsed_seconds(1, threads))
        .add("threads", threads)
        .add("seconds_per_picture", forecast.seconds_per_picture)
        .add("preparation_seconds", forecast.preparation_seconds)
        .add("encoding_seconds", forecast.encoding_seconds)
        .add("error", forecast.error)
        .add("memory_bytes", bytes(forecast.memory_bytes))
        .add("store_bytes", bytes(forecast.store_bytes))
        .add("film_bytes", bytes(forecast.film_bytes))
        .add("probe_seconds", forecast.probe_seconds);
    console.event("forecast", members, "carom: " + forecast_text(forecast, threads) + "\n", false);
}

}  // namespace carom::cli
