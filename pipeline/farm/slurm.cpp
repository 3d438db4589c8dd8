#include "pipeline/farm/slurm.h"

#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

#include <fmt/core.h>
#include <sys/stat.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/hash.h"
#include "pipeline/farm/program.h"
#include "pipeline/farm/shell_text.h"
#include "pipeline/farm/task_environment.h"

namespace carom::farm {
namespace {

// Seconds between Slurm's wish that a task ends and its end by force: the worker puts its frame
// down meanwhile.
constexpr int kGrace = 30;

/// Of a stage's job in the queue.
std::string name_of(const Stage& stage) {
    return "carom-" + stage.name;
}

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

/// Slurm takes a backslash in the path of a log for its own, and the task could not start.
void refuse_backslash(const FarmJob& job) {
    if (job.folder.find('\\') != std::string::npos) {
        throw Error("Slurm cannot write logs to '" + job.folder +
                    "', since its path has a backslash; choose another store with --store");
    }
}

std::int64_t submit(const std::vector<std::string>& words) {
    const ProgramResult result = run_program(words, task_environment());
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

/// Tells the job's tasks from all others in the queue, also if Slurm has lost its numbers and gives
/// them to others.
std::string tag_of(const FarmJob& job) {
    return "carom-" + hash_bytes(std::as_bytes(std::span(job.folder))).to_string();
}

struct QueuedTask {
    std::string number;  // of the job
    std::string state;
};

/// Empty if Slurm does not answer.
std::optional<std::vector<QueuedTask>> tasks_of(const FarmJob& job, std::string& problem) {
    std::string names;
    for (const Stage& stage : stages()) {
        names += (names.empty() ? "" : ",") + name_of(stage);
    }
    const ProgramResult result =
        run_program({"squeue", "--noheader", "--array", "--name=" + names, "--format=%F %T %k"});
    if (result.exit_code != 0) {
        problem = complaint(result);
        return std::nullopt;
    }
    std::vector<QueuedTask> tasks;
    std::istringstream lines(result.output);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        QueuedTask task;
        std::string tag;
        words >> task.number >> task.state >> tag;
        if (tag == tag_of(job)) {
            tasks.push_back(std::move(task));
        }
    }
    return tasks;
}

void write_script(const FarmJob& job, const Stage& stage, const std::string& commands) {
    const std::string path = job.folder + "/" + stage.script;
    const std::string text = fmt::format("#!/bin/sh\n# {}\n{}", stage.purpose, commands);
    write_file_atomically(path, std::as_bytes(std::span(text)));
    ::chmod(path.c_str(), 0755);
}

}  // namespace

void write_scripts(const FarmJob& job, const std::string& carom) {
    for (const Stage& stage : stages()) {
        write_script(job, stage,
                     fmt::format("exec {} farm {} {}\n", shell_word(carom), stage.command,
                                 shell_word(job.folder)));
    }
}

void write_portable_scripts(const FarmJob& job) {
    for (const Stage& stage : stages()) {
        // Slurm runs a copy of the script.
        write_script(job, stage,
                     fmt::format("cd \"${{SLURM_SUBMIT_DIR:-$(dirname \"$0\")}}\" || exit 1\n"
                                 "exec \"${{CAROM:-carom}}\" farm {} .\n",
                                 stage.command));
    }
}

std::vector<std::string> submission(const FarmJob& job, const Stage& stage,
                                    const std::string& after, int delay) {
    std::vector<std::string> words{"sbatch",
                                   "--parsable",
                                   "--job-name=" + name_of(stage),
                                   "--requeue",
                                   "--open-mode=append",
                                   "--comment=" + tag_of(job),
                                   fmt::format("--signal=B:TERM@{}", kGrace),
                                   fmt::format("--cpus-per-task={}", job.processors),
                                   fmt::format("--mem={}M", job.memory),
                                   "--time=" + job.*stage.time};
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
    if (!after.empty()) {
        words.push_back("--dependency=afterany:" + after);
    }
    if (delay > 0) {
        words.push_back(fmt::format("--begin=now+{}seconds", delay));
    }
    words.push_back(job.folder + "/" + stage.script);
    return words;
}

SlurmJobs submit_all(const FarmJob& job) {
    refuse_backslash(job);
    SlurmJobs jobs;
    jobs.numbers.clear();
    try {
        for (const Stage& stage : stages()) {
            const std::string before =
                jobs.numbers.empty() ? "" : std::to_string(jobs.numbers.back());
            jobs.numbers.push_back(submit(submission(job, stage, before, 0)));
        }
    } catch (const Error&) {
        for (const std::int64_t number : jobs.numbers) {
            (void)run_program({"scancel", std::to_string(number)});
        }
        throw;
    }
    return jobs;
}

std::int64_t submit_last(const FarmJob& job, int delay) {
    return submit(submission(job, stages().back(), {}, delay));
}

std::optional<QueueCounts> count_tasks(const FarmJob& job, std::string& problem) {
    const std::optional<std::vector<QueuedTask>> tasks = tasks_of(job, problem);
    if (!tasks) {
        return std::nullopt;
    }
    QueueCounts counts;
    for (const QueuedTask& task : *tasks) {
        if (task.state == "PENDING" || task.state == "REQUEUED" || task.state == "REQUEUE_HOLD" ||
            task.state == "SUSPENDED") {
            ++counts.waiting;
        } else if (task.state == "RUNNING" || task.state == "CONFIGURING" ||
                   task.state == "COMPLETING" || task.state == "STOPPED") {
            ++counts.running;
        }
    }
    return counts;
}

void cancel(const FarmJob& job) {
    std::string problem;
    const std::optional<std::vector<QueuedTask>> tasks = tasks_of(job, problem);
    if (!tasks) {
        throw Error("Slurm does not answer: " + problem);
    }
    std::set<std::string> numbers;
    for (const QueuedTask& task : *tasks) {
        numbers.insert(task.number);
    }
    for (const std::string& number : numbers) {
        const ProgramResult result = run_program({"scancel", number});
        if (result.exit_code != 0) {
            throw Error("Slurm did not cancel job " + number + ": " + complaint(result));
        }
    }
}

}  // namespace carom::farm
