// farm_simulation: how a farm of 10 to 10,000 workers renders a film, as markdown tables. Each row
// is the mean of several runs with different random numbers; the same options print the same bytes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
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
        &FarmResult::finished,     &FarmResult::last_first_claim,
        &FarmResult::tasks,        &FarmResult::worker_seconds,
        &FarmResult::wait_seconds, &FarmResult::lists,
        &FarmResult::heads,        &FarmResult::gets,
        &FarmResult::puts,         &FarmResult::peak_reads,
        &FarmResult::peak_writes,  &FarmResult::peak_bytes,
        &FarmResult::peak_claims,  &FarmResult::slowest_request,
        &FarmResult::vain_claims,  &FarmResult::frames_again,
        &FarmResult::lost_tasks,   &FarmResult::unfinished};

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
    settings.store.writes_per_second = 0;
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

/// What a row is about.
struct Row {
    const Options& options;
    const FarmSettings& farm;
    const std::vector<double>& seconds;
    FarmResult result;
};

struct Column {
    const char* title;
    std::function<std::string(const Row&)> cell;
};

void print_line(const std::vector<std::string>& cells) {
    fmt::print("| {} |\n", fmt::join(cells, " | "));
}

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

/// How much later the frames are done than in the undisturbed farm.
std::string delay(const Row& row) {
    if (row.result.unfinished > 0) {
        return "";
    }
    const FarmResult ideal = mean_of_runs(undisturbed(row.farm), row.seconds, 1);
    return percent(std::max(0.0, row.result.finished / ideal.finished - 1));
}

double work_of(const std::vector<double>& seconds) {
    return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

/// Of the table about a store of this kind.
std::vector<Column> columns_of(StoreKind kind) {
    const auto per_second = [](double FarmResult::*value) {
        return [value](const Row& row) { return amount(row.result.*value); };
    };
    const auto total = per_second;
    std::vector<Column> columns = {
        {"workers", [](const Row& row) { return amount(row.farm.workers); }},
        {"budget", [](const Row& row) { return duration(row.farm.budget); }},
        {"frames done", [](const Row& row) { return finish(row.result); }},
        {"later by", delay},
        {"tasks", total(&FarmResult::tasks)},
        {"CPU h held",
         [](const Row& row) {
             return fmt::format("{:.1f}", row.result.worker_seconds * row.options.cpus / 3600);
         }},
        {"useful",
         [](const Row& row) { return percent(work_of(row.seconds) / row.result.worker_seconds); }},
    };
    const auto add = [&columns](std::vector<Column> more) {
        columns.insert(columns.end(), more.begin(), more.end());
    };
    if (kind == StoreKind::files) {
        add({{"requests/s", per_second(&FarmResult::peak_reads)}});
    } else {
        add({{"waiting",
              [](const Row& row) {
                  return percent(row.result.wait_seconds / row.result.worker_seconds);
              }},
             {"reads/s", per_second(&FarmResult::peak_reads)},
             {"writes/s", per_second(&FarmResult::peak_writes)},
             {"lists", total(&FarmResult::lists)},
             {"heads", total(&FarmResult::heads)},
             {"gets", total(&FarmResult::gets)},
             {"puts", total(&FarmResult::puts)},
             {"in vain", total(&FarmResult::vain_claims)}});
    }
    add({{"MB/s", [](const Row& row) { return amount(row.result.peak_bytes / 1e6); }},
         {"claims/s", per_second(&FarmResult::peak_claims)},
         {"slowest request",
          [](const Row& row) { return request_time(row.result.slowest_request); }},
         {"again", [](const Row& row) { return fmt::format("{:.1f}", row.result.frames_again); }}});
    return columns;
}

void print_head(const std::vector<Column>& columns) {
    std::vector<std::string> titles;
    for (const Column& column : columns) {
        titles.emplace_back(column.title);
    }
    print_line(titles);
    fmt::print("|");
    for (std::size_t i = 0; i < columns.size(); ++i) {
        fmt::print("---:|");
    }
    fmt::print("\n");
}

void print_row(const Options& options, const FarmSettings& farm, const std::vector<double>& seconds,
               const std::vector<Column>& columns) {
    const Row row{options, farm, seconds, mean_of_runs(farm, seconds, options.runs)};
    std::vector<std::string> cells;
    for (const Column& column : columns) {
        cells.push_back(column.cell(row));
    }
    print_line(cells);
}

void print_farm(const Options& options, const std::vector<FrameTimes>& measured) {
    const int frames = static_cast<int>(options.film_seconds * options.frames_per_second);
    std::vector<double> seconds = film_seconds(measured, options.quality, frames);
    for (double& frame : seconds) {
        frame /= options.cpus;
    }
    const std::vector<Column> columns = columns_of(options.farm.kind);
    print_head(columns);
    for (const int workers : options.workers) {
        for (const double budget : options.budgets) {
            FarmSettings farm = options.farm;
            farm.workers = workers;
            farm.budget = 60 * budget;
            farm.give_up_after = 3600 * options.give_up_hours;
            farm.time_limit = 60 * options.time_limit;
            farm.lost_nodes_per_hour = options.lost_percent / 100;
            farm.slow_nodes = options.slow_percent / 100;
            print_row(options, farm, seconds, columns);
        }
    }
    const double bytes = 2 * frames * options.farm.frame_bytes;  // to verify and to encode them
    const double read = bytes / options.farm.store.client_bytes_per_second;
    const double work = work_of(seconds) * options.cpus;
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
    app.add_option("--store", farm.kind,
                   "files: a network file system; objects: an object store, with a latency of "
                   "0.1 s and 85 MB/s for each worker unless told")
        ->transform(CLI::CheckedTransformer(std::map<std::string, StoreKind>{
            {"files", StoreKind::files}, {"objects", StoreKind::objects}}));
    app.add_option("--latency", farm.store.latency, "s")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--store-requests", farm.store.requests_per_second,
                   "per second; 0 = any; of objects: only those that read")
        ->capture_default_str();
    app.add_option("--store-writes", farm.store.writes_per_second,
                   "of objects: requests that write, per second; 0 = any")
        ->capture_default_str();
    app.add_option("--store-bytes", farm.store.bytes_per_second, "per second; 0 = any")
        ->capture_default_str();
    app.add_option("--client-bytes", farm.store.client_bytes_per_second,
                   "per second, of the network of a worker")
        ->capture_default_str();
    app.add_option("--load-requests", farm.load_requests, "files that a task reads first")
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

void use_unless_given(const CLI::App& app, const char* option, double value, double& place) {
    if (app.count(option) == 0) {
        place = value;
    }
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app("Simulates a farm that renders a film.");
    describe_film(app, options);
    describe_farm(app, options);
    describe_store(app, options);
    CLI11_PARSE(app, argc, argv);
    if (options.farm.kind == StoreKind::objects) {
        use_unless_given(app, "--latency", 0.1, options.farm.store.latency);
        use_unless_given(app, "--client-bytes", 85e6, options.farm.store.client_bytes_per_second);
    }
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
