// farm_simulation: how a farm of 10 to 10,000 workers renders a film, as markdown tables. Each row
// is the mean of several runs with different random numbers; the same options print the same bytes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/format.h>

#include "bench/farm_frame_times.h"
#include "bench/farm_model.h"

namespace carom::bench {
namespace {

struct Options {
    std::string times = "bench/farm_frame_times.csv";
    std::string quality = "final";
    double film_seconds = 10;
    double frames_per_second = 24;
    double cpus = 1;               // of a worker
    double encode_seconds = 0.30;  // CPU s to read and encode a frame in the last job
    std::vector<int> workers = {10, 100, 1000, 10000};
    std::vector<double> budgets = {10};  // min
    double time_limit = 0;               // min
    double lost_percent = 0;
    double slow_percent = 0;
    double give_up_hours = 12;
    int runs = 3;
    bool prints_cost = false;
    FarmSettings farm;
};

/// Sums of several runs, and the mean of each value.
class MeanResult {
  public:
    void add(const FarmResult& run) {
        ++count_;
        for (double FarmResult::*value : kValues) {
            sum_.*value += run.*value;
        }
    }
    [[nodiscard]] FarmResult mean() const {
        FarmResult mean = sum_;
        for (double FarmResult::*value : kValues) {
            mean.*value /= count_;
        }
        return mean;
    }

  private:
    static constexpr double FarmResult::*kValues[] = {
        &FarmResult::finished,       &FarmResult::last_first_claim, &FarmResult::tasks,
        &FarmResult::worker_seconds, &FarmResult::requests,         &FarmResult::peak_requests,
        &FarmResult::peak_bytes,     &FarmResult::peak_claims,      &FarmResult::slowest_request,
        &FarmResult::frames_again,   &FarmResult::lost_tasks,       &FarmResult::unfinished};

    FarmResult sum_;
    int count_ = 0;
};

FarmResult mean_of_runs(FarmSettings settings, const std::vector<double>& seconds, int runs) {
    MeanResult results;
    for (int run = 1; run <= runs; ++run) {
        settings.seed = static_cast<std::uint64_t>(run);
        results.add(simulate_farm(settings, seconds));
    }
    return results.mean();
}

/// The same farm without slow and lost nodes, ends of budgets and limits of the store.
FarmSettings undisturbed(FarmSettings settings) {
    settings.budget = std::numeric_limits<double>::infinity();
    settings.time_limit = 0;
    settings.lost_nodes_per_hour = 0;
    settings.slow_nodes = 0;
    settings.store.requests_per_second = 0;
    settings.store.bytes_per_second = 0;
    return settings;
}

std::string duration(double seconds) {
    if (seconds < 120) {
        return fmt::format("{:.0f} s", seconds);
    }
    return seconds < 36000 ? fmt::format("{:.1f} min", seconds / 60)
                           : fmt::format("{:.1f} h", seconds / 3600);
}

std::string request_time(double seconds) {
    return seconds < 1 ? fmt::format("{:.0f} ms", 1000 * seconds) : duration(seconds);
}

std::string finish(const FarmResult& result) {
    return result.unfinished > 0 ? fmt::format("never: {:.0f} left", result.unfinished)
                                 : duration(result.finished);
}

/// Three significant digits.
std::string amount(double value) {
    if (value >= 999.5e3) {
        return fmt::format("{:.3g} million", value / 1e6);
    }
    if (value < 999.5) {
        return fmt::format("{:.0f}", value);
    }
    const int digits = value < 9995 ? 10 : value < 99950 ? 100 : 1000;
    const int rounded = static_cast<int>(std::lround(value / digits)) * digits;
    return fmt::format("{},{:03}", rounded / 1000, rounded % 1000);
}

constexpr std::array kColumns = {"workers", "budget",     "frames done",     "later by",
                                 "tasks",   "CPU h held", "useful",          "requests/s",
                                 "MB/s",    "claims/s",   "slowest request", "again"};

void print_line(const std::vector<std::string>& cells) {
    fmt::print("| {} |\n", fmt::join(cells, " | "));
}

void print_head() {
    print_line({kColumns.begin(), kColumns.end()});
    fmt::print("|");
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
        fmt::print("---:|");
    }
    fmt::print("\n");
}

/// How much later the frames are done than in the undisturbed farm.
std::string delay(const FarmResult& result, const FarmSettings& farm,
                  const std::vector<double>& seconds) {
    if (result.unfinished > 0) {
        return "";
    }
    const FarmResult ideal = mean_of_runs(undisturbed(farm), seconds, 1);
    return fmt::format("{:.0f} %", std::max(0.0, 100 * (result.finished / ideal.finished - 1)));
}

void print_row(const Options& options, const FarmSettings& farm,
               const std::vector<double>& seconds) {
    const FarmResult result = mean_of_runs(farm, seconds, options.runs);
    const double work = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    print_line(
        {amount(farm.workers), duration(farm.budget), finish(result), delay(result, farm, seconds),
         amount(result.tasks), fmt::format("{:.1f}", result.worker_seconds * options.cpus / 3600),
         fmt::format("{:.0f} %", 100 * work / result.worker_seconds), amount(result.peak_requests),
         amount(result.peak_bytes / 1e6), amount(result.peak_claims),
         request_time(result.slowest_request), fmt::format("{:.1f}", result.frames_again)});
}

void print_farm(const Options& options, const std::vector<FrameTimes>& measured) {
    const int frames = static_cast<int>(options.film_seconds * options.frames_per_second);
    std::vector<double> seconds = film_seconds(measured, options.quality, frames);
    for (double& frame : seconds) {
        frame /= options.cpus;
    }
    print_head();
    for (const int workers : options.workers) {
        for (const double budget : options.budgets) {
            FarmSettings farm = options.farm;
            farm.workers = workers;
            farm.budget = 60 * budget;
            farm.give_up_after = 3600 * options.give_up_hours;
            farm.time_limit = 60 * options.time_limit;
            farm.lost_nodes_per_hour = options.lost_percent / 100;
            farm.slow_nodes = options.slow_percent / 100;
            print_row(options, farm, seconds);
        }
    }
    const double bytes = 2 * frames * options.farm.frame_bytes;  // to verify and to encode them
    const double read = bytes / options.farm.store.client_bytes_per_second;
    const double work = std::accumulate(seconds.begin(), seconds.end(), 0.0) * options.cpus;
    fmt::print(
        "\n{} frames of {:.3g} CPU s on average, {:.1f} CPU hours. The last job reads {:.1f} GB, "
        "at "
        "least {}, and encodes for {} of CPU time.\n",
        frames, work / frames, work / 3600, bytes / 1e9, duration(read),
        duration(frames * options.encode_seconds));
}

void print_cost(const Options& options, const std::vector<FrameTimes>& measured) {
    fmt::print(
        "| quality | CPU s of a frame: mean | least | most | CPU hours per minute of film |\n");
    fmt::print("|---|---:|---:|---:|---:|\n");
    for (const char* quality : {"draft", "preview", "final"}) {
        const auto seconds = film_seconds(measured, quality, kFramesOfFile);
        const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
        const double mean = std::accumulate(seconds.begin(), seconds.end(), 0.0) / kFramesOfFile;
        fmt::print("| {} | {:.3g} | {:.3g} | {:.3g} | {:.3g} |\n", quality, mean, *least, *most,
                   mean * 60 * options.frames_per_second / 3600);
    }
}

void describe_film(CLI::App& app, Options& options) {
    app.add_option("--times", options.times, "measured times of frames, CSV")
        ->capture_default_str();
    app.add_option("--quality", options.quality, "draft, preview or final")
        ->capture_default_str()
        ->check(CLI::IsMember({"draft", "preview", "final"}));
    app.add_option("--film", options.film_seconds, "length of the film, s")
        ->capture_default_str()
        ->check(CLI::Range(1.0, 3600.0));
    app.add_option("--fps", options.frames_per_second)->capture_default_str();
    app.add_option("--frame-bytes", options.farm.frame_bytes)->capture_default_str();
    app.add_option("--encode", options.encode_seconds, "CPU s a frame in the last job")
        ->capture_default_str();
    app.add_flag("--cost", options.prints_cost, "print the cost of a minute of film, and no farm");
}

void describe_farm(CLI::App& app, Options& options) {
    app.add_option("--workers", options.workers, "list")
        ->capture_default_str()
        ->delimiter(',')
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--budget", options.budgets, "list, min")
        ->capture_default_str()
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    app.add_option("--cpus", options.cpus, "of a worker")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--time-limit", options.time_limit,
                   "min after which a task is stopped and hands its frame over; 0 = never")
        ->capture_default_str();
    app.add_option("--nodes-lost-per-hour", options.lost_percent, "%")->capture_default_str();
    app.add_option("--slow-nodes", options.slow_percent, "%")->capture_default_str();
    app.add_option("--slow-factor", options.farm.slow_factor)->capture_default_str();
    app.add_option("--runs", options.runs, "with different random numbers")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    app.add_option("--starts-per-second", options.farm.starts_per_second, "of tasks")
        ->capture_default_str();
    app.add_option("--next-task", options.farm.next_task_delay, "s from a task to the next")
        ->capture_default_str();
    app.add_option("--requeue", options.farm.requeue_delay, "s until a lost task starts again")
        ->capture_default_str();
    app.add_option("--give-up", options.give_up_hours, "h after which a run ends without a film")
        ->capture_default_str();
}

void describe_store(CLI::App& app, Options& options) {
    FarmSettings& farm = options.farm;
    app.add_option("--latency", farm.store.latency, "s")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--store-requests", farm.store.requests_per_second, "per second; 0 = any")
        ->capture_default_str();
    app.add_option("--store-bytes", farm.store.bytes_per_second, "per second; 0 = any")
        ->capture_default_str();
    app.add_option("--load-bytes", farm.load_bytes, "that a task reads first")
        ->capture_default_str();
    app.add_option("--heartbeat", farm.heartbeat, "s")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--expiry", farm.expiry, "s until a claim is dead")->capture_default_str();
    app.add_option("--note", farm.note_seconds, "s between two notes of a worker about itself")
        ->capture_default_str();
    app.add_option("--poll", farm.poll, "s between two looks of a waiting worker")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--longest-poll", farm.longest_poll, "s; waits double up to this")
        ->capture_default_str();
    app.add_option(
           "--backup-after", farm.backup_after,
           "median frame times; a waiting worker renders a frame, too, that nobody began for so "
           "long; 0 = never")
        ->capture_default_str();
    app.add_option("--search", farm.search, "walk: look at each frame; list: read the folder")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, Search>{{"walk", Search::walk}, {"list", Search::list}}));
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app("Simulates a farm that renders a film.");
    describe_film(app, options);
    describe_farm(app, options);
    describe_store(app, options);
    CLI11_PARSE(app, argc, argv);
    const std::vector<FrameTimes> measured = read_frame_times(options.times);
    if (options.prints_cost) {
        print_cost(options, measured);
    } else {
        print_farm(options, measured);
    }
    return 0;
}

}  // namespace
}  // namespace carom::bench

int main(int argc, char** argv) {
    try {
        return carom::bench::run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "farm_simulation: {}\n", error.what());
        return 1;
    }
}
