#include "pipeline/farm/slurm.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include <fmt/core.h>
#include <sys/stat.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "pipeline/farm/program.h"

namespace carom::farm {
namespace {

// Seconds between Slurm's wish that a task ends and its end by force: the worker puts its frame
// down meanwhile.
constexpr int kGrace = 30;

// Beyond the budget, after which a worker only finishes its frame.
constexpr double kLastFrame = 1200;

/// A path in a pattern of Slurm, where % begins a replacement.
std::string pattern_of(const std::string& path) {
    std::string pattern;
    for (const char c : path) {
        pattern += c == '%' ? "%%" : std::string(1, c);
    }
    return pattern;
}

std::string trimmed(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \n\r\t");
    return end == std::string::npos ? "" : text.substr(0, end + 1);
}

/// The last line of what a program of Slurm complained of, without the program's name.
std::string complaint(const ProgramResult& result) {
    const std::string text = trimmed(result.errors);
    std::string line = text.substr(text.find_last_of('\n') + 1);
    for (const char* kind : {": fatal: ", ": error: "}) {
        if (const std::size_t at = line.find(kind); at != std::string::npos) {
            line = line.substr(at + std::string_view(kind).size());
        }
    }
    return line;
}

std::int64_t submit(const std::vector<std::string>& words) {
    const ProgramResult result = run_program(words);
    if (result.exit_code != 0) {
        throw Error("Slurm did not take the job: " + complaint(result));
    }
    // "12" or, with several clusters, "12;name".
    std::int64_t number = 0;
    const char* text = result.output.data();
    const auto [end, error] = std::from_chars(text, text + result.output.size(), number);
    if (error != std::errc() || number <= 0) {
        throw Error("sbatch printed no number of a job: " + trimmed(result.output));
    }
    return number;
}

std::string comma_separated(const std::vector<std::int64_t>& numbers) {
    std::string text;
    for (const std::int64_t number : numbers) {
        text += (text.empty() ? "" : ",") + std::to_string(number);
    }
    return text;
}

std::string time_limit(const FarmJob& job) {
    const double minutes = std::ceil((job.budget + kLastFrame) / 60);
    return job.time.empty() ? fmt::format("{:.0f}", minutes) : job.time;
}

}  // namespace

const std::vector<Stage>& stages() {
    static const std::vector<Stage> all{{"frames", "worker.sh", true}, {"film", "film.sh", false}};
    return all;
}

std::string shell_word(const std::string& text) {
    std::string word = "'";
    for (const char c : text) {
        word += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return word + "'";
}

void write_scripts(const FarmJob& job, const std::string& carom) {
    for (const Stage& stage : stages()) {
        const std::string path = job.folder + "/" + stage.script;
        const std::string text = fmt::format(
            "#!/bin/sh\n# {}\nexec {} farm {} {}\n",
            stage.is_array ? "Renders frames until its time is over or all are there."
                           : "Writes the film if all frames are there, else asks for the missing.",
            shell_word(carom), stage.is_array ? "work" : "finish", shell_word(job.folder));
        write_file_atomically(path, std::as_bytes(std::span(text)));
        ::chmod(path.c_str(), 0755);
    }
}

std::vector<std::string> submission(const FarmJob& job, const Stage& stage,
                                    std::optional<std::int64_t> after, int delay) {
    std::vector<std::string> words{"sbatch",
                                   "--parsable",
                                   "--job-name=carom-" + stage.name,
                                   "--requeue",
                                   "--open-mode=append",
                                   fmt::format("--signal=B:TERM@{}", kGrace),
                                   fmt::format("--cpus-per-task={}", job.processors),
                                   fmt::format("--mem={}M", job.memory),
                                   "--time=" + time_limit(job)};
    const std::string logs = pattern_of(job.folder) + "/logs/" + stage.name;
    if (stage.is_array) {
        words.push_back(fmt::format(
            "--array=0-{}{}", job.workers - 1,
            job.tasks_at_once > 0 ? fmt::format("%{}", job.tasks_at_once) : std::string()));
        words.push_back("--output=" + logs + "-%A_%a.log");
    } else {
        words.push_back("--output=" + logs + "-%j.log");
    }
    if (!job.partition.empty()) {
        words.push_back("--partition=" + job.partition);
    }
    if (!job.account.empty()) {
        words.push_back("--account=" + job.account);
    }
    if (after) {
        words.push_back(fmt::format("--dependency=afterany:{}", *after));
    }
    if (delay > 0) {
        words.push_back(fmt::format("--begin=now+{}seconds", delay));
    }
    words.push_back(job.folder + "/" + stage.script);
    return words;
}

SlurmJobs submit_all(const FarmJob& job) {
    SlurmJobs jobs;
    jobs.frames = submit(submission(job, stages()[0], {}, 0));
    try {
        jobs.film = submit(submission(job, stages()[1], jobs.frames, 0));
    } catch (const Error&) {
        (void)run_program({"scancel", std::to_string(jobs.frames)});
        throw;
    }
    return jobs;
}

std::int64_t submit_film(const FarmJob& job, int delay) {
    return submit(submission(job, stages()[1], {}, delay));
}

std::optional<QueueCounts> count_tasks(const std::vector<std::int64_t>& jobs,
                                       std::string& problem) {
    const ProgramResult result = run_program(
        {"squeue", "--noheader", "--array", "--jobs=" + comma_separated(jobs), "--format=%T"});
    // Slurm forgets jobs some minutes after their end.
    if (result.exit_code != 0 && result.errors.find("Invalid job id") != std::string::npos) {
        return QueueCounts{};
    }
    if (result.exit_code != 0) {
        problem = complaint(result);
        return std::nullopt;
    }
    QueueCounts counts;
    std::istringstream lines(result.output);
    for (std::string state; std::getline(lines, state);) {
        if (state == "PENDING" || state == "REQUEUED" || state == "REQUEUE_HOLD" ||
            state == "SUSPENDED") {
            ++counts.waiting;
        } else if (state == "RUNNING" || state == "CONFIGURING" || state == "COMPLETING" ||
                   state == "STOPPED") {
            ++counts.running;
        }
    }
    return counts;
}

void cancel(const std::vector<std::int64_t>& jobs) {
    for (const std::int64_t number : jobs) {
        const ProgramResult result = run_program({"scancel", std::to_string(number)});
        if (result.exit_code != 0 && result.errors.find("Invalid job id") == std::string::npos &&
            result.errors.find("already completing or completed") == std::string::npos) {
            throw Error("Slurm did not cancel job " + std::to_string(number) + ": " +
                        complaint(result));
        }
    }
}

}  // namespace carom::farm
