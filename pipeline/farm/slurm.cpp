#include "pipeline/farm/slurm.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <set>
#include <sstream>

#include <fmt/core.h>

#include "core/error.h"
#include "core/text.h"
#include "pipeline/farm/program.h"
#include "pipeline/farm/shell_text.h"
#include "pipeline/farm/task_environment.h"

namespace carom::farm {
namespace {

// Options that say what a task of carom is; what the user says instead would break the job.
constexpr std::array<std::string_view, 11> kOwnOptions{
    "--array",  "--comment", "--dependency", "--job-name", "--output",    "--open-mode",
    "--signal", "--wrap",    "--parsable",   "--requeue",  "--no-requeue"};

/// Of a stage's job in the queue: the film first, since queues show few letters.
std::string name_of(const FarmJob& job, const Stage& stage) {
    return simple_name(std::filesystem::path(job.film).stem().string()) + "-" + stage.name;
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

/// The number at the beginning of a text; 0 if there is none.
std::int64_t number_in(std::string_view text) {
    std::int64_t number = 0;
    (void)std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

std::vector<std::string> split(const std::string& line, char separator) {
    std::vector<std::string> parts;
    std::istringstream text(line);
    for (std::string part; std::getline(text, part, separator);) {
        parts.push_back(trimmed(part));
    }
    return parts;
}

/// The stage whose jobs have this name, or nullptr.
const Stage* stage_named(const FarmJob& job, const std::string& name) {
    const auto found = std::ranges::find_if(
        stages(), [&](const Stage& stage) { return name_of(job, stage) == name; });
    return found == stages().end() ? nullptr : &*found;
}

/// `exit`: how the task's program ended, as "CODE:SIGNAL" or as a wait status (wait(2)).
TaskState state_of(const std::string& name, const std::string& exit) {
    const std::size_t colon = exit.find(':');
    const std::int64_t status = number_in(exit);
    const std::int64_t code = colon == std::string::npos ? status >> 8 : status;
    const std::int64_t signal =
        colon == std::string::npos ? status & 0x7F : number_in(exit.substr(colon + 1));
    constexpr std::int64_t kKilled = 9;
    constexpr std::int64_t kShellKilled = 128 + kKilled;
    const auto is_any = [&](std::initializer_list<std::string_view> names) {
        return std::ranges::any_of(names, [&](std::string_view one) {
            return name.starts_with(one);  // "CANCELLED by 1000"
        });
    };
    if (is_any({"PENDING", "REQUEUE", "SUSPENDED", "RESV_DEL_HOLD", "SPECIAL_EXIT"})) {
        return TaskState::waiting;
    }
    if (is_any({"COMPLETED"})) {
        return TaskState::done;
    }
    if (is_any({"TIMEOUT"}) || (is_any({"FAILED"}) && code == kOutOfTime)) {
        return TaskState::out_of_time;
    }
    if (is_any({"OUT_OF_MEMORY"}) ||
        (is_any({"FAILED"}) && (signal == kKilled || code == kShellKilled))) {
        return TaskState::out_of_memory;
    }
    if (is_any({"FAILED", "BOOT_FAIL", "NODE_FAIL", "DEADLINE"})) {
        return TaskState::failed;
    }
    if (is_any({"CANCELLED", "PREEMPTED", "REVOKED"})) {
        return TaskState::cancelled;
    }
    return TaskState::running;  // also CONFIGURING, COMPLETING, STOPPED ...
}

/// A time of Slurm: "30:00", "1:00:00", "2-00:00:00"; 0 for "infinite" and what is no time.
std::int64_t minutes_in(const std::string& text) {
    const std::size_t dash = text.find('-');
    std::int64_t minutes = dash == std::string::npos ? 0 : 24 * 60 * number_in(text);
    const std::vector<std::string> parts =
        split(dash == std::string::npos ? text : text.substr(dash + 1), ':');
    if (parts.size() == 3) {
        minutes += 60 * number_in(parts[0]) + number_in(parts[1]);
    } else if (parts.size() == 2) {
        minutes += number_in(parts[0]);
    }
    return minutes;
}

/// The round with the factors that the partition has room for.
Round within_partition(const FarmJob& job, Round round, const Stage& stage) {
    if (round.time_factor == 1 && round.memory_factor == 1) {
        return round;  // the first limits are what the user wants, or sbatch refuses them
    }
    const ProgramResult result = run_program({"sinfo", "--noheader", "--format=%P|%l|%m"});
    const PartitionLimits most = parse_partitions(result.output, job.partition);
    while (round.time_factor > 1 && most.minutes > 0 && time_of(job, round, stage) > most.minutes) {
        round.time_factor /= kLimitFactor;
    }
    while (round.memory_factor > 1 && most.megabytes > 0 &&
           memory_of(job, round) > most.megabytes) {
        round.memory_factor /= kLimitFactor;
    }
    return round;
}

/// Of the tasks of the job's newest round, also of those that the controller has forgotten. Empty
/// where Slurm keeps no accounts.
std::vector<Task> ask_accounting(const FarmJob& job) {
    const std::optional<Round> round = read_round(job);
    if (!round || round->numbers.front() == 0) {
        return {};
    }
    const ProgramResult result = run_program({"sacct", "--noheader", "--parsable2", "--allocations",
                                              "--jobs=" + std::to_string(round->numbers.front()),
                                              "--format=JobID,State,ExitCode,NodeList,JobName"});
    return result.exit_code == 0 ? parse_accounting(job, result.output) : std::vector<Task>{};
}

bool is_active(const Task& task) {
    return task.state == TaskState::waiting || task.state == TaskState::running;
}

/// The tasks of a job in the queue, and of its workers also those that the controller has
/// forgotten, as it does some minutes after their end.
std::vector<Task> with_accounting(const FarmJob& job, std::vector<Task> tasks) {
    const auto is_worker = [](const Task& task) {
        return task.stage != nullptr && task.stage->is_array;
    };
    if (std::ranges::none_of(
            tasks, [&](const Task& task) { return is_worker(task) && is_active(task); })) {
        if (const std::vector<Task> all = ask_accounting(job); !all.empty()) {
            std::erase_if(tasks, is_worker);
            tasks.insert(tasks.end(), all.begin(), all.end());
        }
    }
    return tasks;
}

}  // namespace

std::vector<Task> parse_queue(const FarmJob& job, const std::string& lines) {
    std::vector<Task> tasks;
    const std::string tag = tag_of_folder(job);
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        const std::vector<std::string> parts = split(line, '|');
        if (parts.size() == 6 && parts[5] == tag) {
            tasks.push_back({number_in(parts[0]), stage_named(job, parts[4]), parts[3],
                             state_of(parts[1], parts[2])});
        }
    }
    return tasks;
}

std::vector<Task> parse_accounting(const FarmJob& job, const std::string& lines) {
    std::vector<Task> tasks;
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        const std::vector<std::string> parts = split(line, '|');
        const Stage* stage = parts.size() == 5 ? stage_named(job, parts[4]) : nullptr;
        if (stage != nullptr) {
            tasks.push_back({number_in(parts[0]), stage,
                             parts[3] == "None assigned" ? "" : parts[3],
                             state_of(parts[1], parts[2])});
        }
    }
    return tasks;
}

PartitionLimits parse_partitions(const std::string& lines, std::string_view partition) {
    PartitionLimits limits;
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        const std::vector<std::string> parts = split(line, '|');
        const std::string wanted(partition);
        const bool is_it = parts.size() == 3 && (parts[0] == wanted || parts[0] == wanted + "*" ||
                                                 (partition.empty() && parts[0].ends_with('*')));
        if (is_it) {
            limits.minutes = std::max(limits.minutes, minutes_in(parts[1]));
            limits.megabytes = std::max(limits.megabytes, number_in(parts[2]));
        }
    }
    return limits;
}

std::string problem_of_option(const std::string& option) {
    if (!option.starts_with('-') || option == "-" || option == "--") {
        return "'" + option + "' is no option; write a value in the same word, as in --qos=high";
    }
    const std::string name = option.substr(0, option.find('='));
    for (const std::string_view own : kOwnOptions) {
        if (name == own) {
            return "'" + name + "' is an option that carom itself gives to sbatch";
        }
    }
    return "";
}

namespace {

/// Where the job wants to run, and how soon.
void add_wishes(std::vector<std::string>& words, const FarmJob& job, const Round& round) {
    if (!job.partition.empty()) {
        words.push_back("--partition=" + job.partition);
    }
    if (!job.account.empty()) {
        words.push_back("--account=" + job.account);
    }
    if (job.priority != 0) {
        words.push_back(fmt::format("--nice={}", -job.priority));
    }
    if (const std::vector<std::string> nodes = excluded_nodes(round); !nodes.empty()) {
        words.push_back("--exclude=" + join(nodes, ","));
    }
}

}  // namespace

std::vector<std::string> submission(const FarmJob& job, const Round& round, const Stage& stage,
                                    const Begin& begin) {
    std::vector<std::string> words{"sbatch",
                                   "--parsable",
                                   "--job-name=" + name_of(job, stage),
                                   "--requeue",
                                   "--open-mode=append",
                                   "--comment=" + tag_of_folder(job),
                                   fmt::format("--signal=B:TERM@{}", kGrace),
                                   fmt::format("--cpus-per-task={}", job.processors),
                                   fmt::format("--mem={}M", memory_of(job, round)),
                                   fmt::format("--time={}", time_of(job, round, stage))};
    const std::string logs = pattern_of(job.folder) + "/logs/" + stage.name;
    if (stage.is_array) {
        words.push_back(fmt::format(
            "--array=0-{}{}", job.workers - 1,
            job.tasks_at_once > 0 ? fmt::format("%{}", job.tasks_at_once) : std::string()));
        words.push_back("--output=" + logs + "-%A_%a.log");
    } else {
        words.push_back("--output=" + logs + "-%j.log");
    }
    add_wishes(words, job, round);
    std::string after;
    for (const std::int64_t number : begin.after) {
        after += (after.empty() ? "--dependency=afterany:" : ":") + std::to_string(number);
    }
    if (!after.empty()) {
        words.push_back(after);
    }
    if (begin.delay > 0) {
        words.push_back(fmt::format("--begin=now+{}seconds", begin.delay));
    }
    words.insert(words.end(), job.engine_options.begin(), job.engine_options.end());
    words.push_back(job.folder + "/" + stage.script);
    return words;
}

std::int64_t Slurm::submit(const FarmJob& job, const Round& round, const Stage& stage,
                           const Begin& begin) const {
    refuse_backslash(job);
    const ProgramResult result = run_program(
        submission(job, within_partition(job, round, stage), stage, begin), task_environment());
    if (result.exit_code != 0) {
        throw Error("Slurm did not take the job: " + complaint(result));
    }
    const std::int64_t number = number_in(result.output);  // "12" or, with clusters, "12;name"
    if (number <= 0) {
        throw Error("sbatch printed no number of a job: " + trimmed(result.output));
    }
    return number;
}

std::vector<Answer> Slurm::ask(const std::vector<FarmJob>& jobs) const {
    std::set<std::string> names;
    for (const FarmJob& job : jobs) {
        for (const Stage& stage : stages()) {
            names.insert(name_of(job, stage));
        }
    }
    const ProgramResult result = run_program(
        {"squeue", "--noheader", "--array", "--states=all",
         "--name=" + join(std::vector<std::string>(names.begin(), names.end()), ","),
         "--Format=ArrayJobID:20|,State:20|,exit_code:20|,NodeList:200|,Name:100|,Comment:100"});
    std::vector<Answer> answers;
    for (const FarmJob& job : jobs) {
        answers.push_back(result.exit_code == 0
                              ? Answer{with_accounting(job, parse_queue(job, result.output)), ""}
                              : Answer{{}, "Slurm does not answer: " + complaint(result)});
    }
    return answers;
}

void Slurm::cancel(const FarmJob& job, Which which) const {
    const Answer answer = ask(job);
    if (!answer.tasks) {
        throw Error(answer.problem);
    }
    std::set<std::int64_t> numbers;
    for (const Task& task : *answer.tasks) {
        const bool is_meant = which == Which::all || task.state == TaskState::waiting;
        const bool is_worker = task.stage != nullptr && task.stage->is_array;
        if (is_active(task) && is_meant && (which != Which::waiting_workers || is_worker)) {
            numbers.insert(task.job);
        }
    }
    for (const std::int64_t number : numbers) {
        std::vector<std::string> words{"scancel", std::to_string(number)};
        if (which != Which::all) {
            words.emplace_back("--state=PENDING");
        }
        const ProgramResult result = run_program(words);
        if (result.exit_code != 0) {
            throw Error(fmt::format("Slurm did not cancel job {}: {}", number, complaint(result)));
        }
    }
}

std::string Slurm::tag(const FarmJob& job) const {
    return tag_of_folder(job);
}

}  // namespace carom::farm
