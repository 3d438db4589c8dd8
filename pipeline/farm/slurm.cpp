#include "pipeline/farm/slurm.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "core/text.h"
#include "pipeline/farm/program.h"
#include "pipeline/farm/shell_text.h"
#include "pipeline/farm/task_environment.h"

namespace carom::farm {
namespace {

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
    const auto is_any = [&](std::initializer_list<std::string_view> names) {
        return std::ranges::any_of(names, [&](std::string_view one) {
            return name.starts_with(one);  // "CANCELLED by 1000"
        });
    };
    if (is_any({"PENDING", "REQUEUE", "RESV_DEL_HOLD", "SPECIAL_EXIT", "EXPEDITING"})) {
        return TaskState::waiting;
    }
    if (is_any({"RUNNING", "SUSPENDED", "CONFIGURING", "COMPLETING", "POWER_UP_NODE", "RESIZING",
                "SIGNALING", "STAGE_OUT", "STOPPED", "UPDATE_DB"})) {
        return TaskState::running;
    }
    if (is_any({"COMPLETED"})) {
        return TaskState::done;
    }
    if (is_any({"TIMEOUT"}) || (is_any({"FAILED"}) && code == kOutOfTime)) {
        return TaskState::out_of_time;
    }
    if (is_any({"OUT_OF_MEMORY"}) ||
        (is_any({"FAILED"}) && (signal == kKilled || code == kOutOfMemory))) {
        return TaskState::out_of_memory;
    }
    const bool is_own_fault = is_any({"FAILED"}) && code != kWrongInput && code != kStopped;
    if (is_own_fault || is_any({"BOOT_FAIL", "NODE_FAIL", "LAUNCH_FAILED", "RECONFIG_FAIL"})) {
        return TaskState::failed;
    }
    return TaskState::cancelled;  // also DEADLINE, PREEMPTED, REVOKED, and what is not known
}

/// The minutes of a time as Slurm prints it: 30 for "30:00", 60 for "1:00:00", 2880 for
/// "2-00:00:00". 0 for "infinite", and for a text that is not a time.
std::int64_t minutes_in(const std::string& text) {
    const std::size_t dash = text.find('-');
    constexpr std::int64_t kMinutesOfDay = 1440;
    std::int64_t minutes = dash == std::string::npos ? 0 : kMinutesOfDay * number_in(text);
    const std::vector<std::string> parts =
        split(dash == std::string::npos ? text : text.substr(dash + 1), ':');
    if (parts.size() == 3) {
        minutes += 60 * number_in(parts[0]) + number_in(parts[1]);
    } else if (parts.size() == 2) {
        minutes += number_in(parts[0]);
    }
    return minutes;
}

/// The jobs in the queue of whose tasks the accounts may know more than the controller, which
/// forgets tasks some minutes after their end. None while workers are active, and if nothing is
/// known of the round.
std::vector<std::int64_t> numbers_for_accounting(const FarmJob& job,
                                                 const std::vector<Task>& tasks) {
    if (std::ranges::any_of(tasks, [](const Task& task) {
            return task.stage != nullptr && task.stage->is_array && is_active(task);
        })) {
        return {};
    }
    try {
        const Round round = read_round(job).value_or(Round{});
        std::vector<std::int64_t> numbers = round.not_learned;
        numbers.insert(numbers.end(), round.numbers.begin(), round.numbers.end());
        std::erase(numbers, 0);
        return numbers;
    } catch (const Error&) {
        return {};
    }
}

/// What the accounts have of these jobs in the queue; empty where Slurm keeps none.
std::string ask_accounting(const std::set<std::string>& numbers) {
    if (numbers.empty()) {
        return "";
    }
    const ProgramResult result = run_program(
        {"sacct", "--noheader", "--parsable2", "--allocations",
         "--jobs=" + join(std::vector<std::string>(numbers.begin(), numbers.end()), ","),
         "--format=JobID,State,ExitCode,NodeList,JobName"});
    return result.exit_code == 0 ? result.output : "";
}

/// The partitions that a submission means if the job names none.
std::string partitions_of(const FarmJob& job) {
    const char* variable = std::getenv("SBATCH_PARTITION");
    return job.partition.empty() && variable != nullptr ? variable : job.partition;
}

}  // namespace

std::vector<Task> parse_queue(const FarmJob& job, const std::string& lines) {
    std::vector<Task> tasks;
    const std::string tag = Slurm().tag(job);
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        const std::vector<std::string> parts = split(line, '|');
        if (parts.size() == 7 && parts[5] == tag) {
            const TaskState state = state_of(parts[1], parts[2]);
            tasks.push_back({number_in(parts[0]), stage_named(job, parts[4]), parts[3], state,
                             state == TaskState::waiting ? parts[6] : ""});
        }
    }
    return tasks;
}

std::vector<Task> parse_accounting(const FarmJob& job, const std::vector<std::int64_t>& numbers,
                                   const std::string& lines) {
    std::vector<Task> tasks;
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        const std::vector<std::string> parts = split(line, '|');
        const Stage* stage = parts.size() == 5 ? stage_named(job, parts[4]) : nullptr;
        const std::int64_t number = number_in(line);
        if (stage != nullptr && std::ranges::find(numbers, number) != numbers.end()) {
            tasks.push_back({number, stage, parts[3] == "None assigned" ? "" : parts[3],
                             state_of(parts[1], parts[2]), ""});
        }
    }
    return tasks;
}

std::vector<Task> joined(std::vector<Task> queue, std::vector<Task> accounts) {
    std::erase_if(accounts, is_active);
    std::set<std::int64_t> numbers;
    for (const Task& task : accounts) {
        numbers.insert(task.job);
    }
    for (const std::int64_t number : numbers) {
        const auto is_ended = [&](const Task& task) {
            return task.job == number && !is_active(task);
        };
        if (std::ranges::count_if(accounts, is_ended) > std::ranges::count_if(queue, is_ended)) {
            std::erase_if(queue, is_ended);
            std::ranges::copy_if(accounts, std::back_inserter(queue), is_ended);
        }
    }
    return queue;
}

Limits parse_partitions(const std::string& lines, const std::string& partitions) {
    const std::vector<std::string> wanted = split(partitions, ',');
    Limits limits;
    bool has_minutes = true;  // else a partition gives any number
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        const std::vector<std::string> parts = split(line, '|');
        if (parts.size() != 3) {
            continue;
        }
        const bool is_default = parts[0].ends_with('*');
        const std::string name = is_default ? parts[0].substr(0, parts[0].size() - 1) : parts[0];
        if (wanted.empty() ? is_default : std::ranges::find(wanted, name) != wanted.end()) {
            const std::int64_t minutes = minutes_in(parts[1]);
            has_minutes = has_minutes && minutes > 0;
            limits.minutes = has_minutes ? std::max(limits.minutes, minutes) : 0;
            limits.megabytes = std::max(limits.megabytes, number_in(parts[2]));
        }
    }
    return limits;
}

namespace {

/// The nodes that the user's option leaves out; empty if it is another option.
std::string user_excludes(const std::string& option) {
    for (const std::string_view name : {"--exclude=", "-x"}) {
        if (option.starts_with(name)) {
            return option.substr(name.size());
        }
    }
    return "";
}

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
    std::vector<std::string> excluded = excluded_nodes(round);
    for (const std::string& option : job.engine_options) {
        if (const std::string nodes = user_excludes(option); !nodes.empty()) {
            excluded.push_back(nodes);
        } else {
            words.push_back(option);
        }
    }
    if (!excluded.empty()) {
        words.push_back("--exclude=" + join(excluded, ","));
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
                                   "--comment=" + Slurm().tag(job),
                                   "--chdir=" + job.folder,
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
    words.push_back(job.folder + "/" + stage.script);
    return words;
}

std::int64_t Slurm::submit(const FarmJob& job, const Round& round, const Stage& stage,
                           const Begin& begin) const {
    refuse_backslash(job);
    const ProgramResult result =
        run_program(submission(job, round, stage, begin), task_environment());
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
    const std::string format =
        "--Format=ArrayJobID:20|,State:20|,exit_code:20|,NodeList:200|,Name:100|,Comment:100|,"
        "Reason:100";
    const ProgramResult queue = run_program(
        {"squeue", "--noheader", "--array", "--states=all",
         "--name=" + join(std::vector<std::string>(names.begin(), names.end()), ","), format});
    if (queue.exit_code != 0) {
        return std::vector<Answer>(jobs.size(), {{}, "Slurm does not answer: " + complaint(queue)});
    }
    std::vector<Answer> answers;
    std::vector<std::vector<std::int64_t>> numbers;
    std::set<std::string> all_numbers;
    for (const FarmJob& job : jobs) {
        answers.push_back({parse_queue(job, queue.output), ""});
        numbers.push_back(numbers_for_accounting(job, *answers.back().tasks));
        for (const std::int64_t number : numbers.back()) {
            all_numbers.insert(std::to_string(number));
        }
    }
    const std::string accounts = ask_accounting(all_numbers);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        answers[i].tasks =
            joined(std::move(*answers[i].tasks), parse_accounting(jobs[i], numbers[i], accounts));
    }
    return answers;
}

Limits Slurm::limits(const FarmJob& job) const {
    const ProgramResult result = run_program({"sinfo", "--noheader", "--format=%P|%l|%m"});
    return parse_partitions(result.output, partitions_of(job));
}

void Slurm::cancel(const FarmJob& job, Which which) const {
    const auto meant_in = [&](const Answer& answer) {
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
        return numbers;
    };
    std::map<std::int64_t, std::string> problems;  // of jobs in the queue
    for (const std::int64_t number : meant_in(ask(job))) {
        std::vector<std::string> words{"scancel", std::to_string(number)};
        if (which != Which::all) {
            words.emplace_back("--state=PENDING");
        }
        const ProgramResult result = run_program(words);
        if (result.exit_code != 0) {
            problems[number] =
                fmt::format("Slurm did not cancel job {}: {}", number, complaint(result));
        }
    }
    if (problems.empty()) {
        return;
    }
    for (const std::int64_t number : meant_in(ask(job))) {  // else it has ended by itself
        if (const auto problem = problems.find(number); problem != problems.end()) {
            throw Error(problem->second);
        }
    }
}

std::string Slurm::tag(const FarmJob& job) const {
    return tag_of_folder(job);
}

}  // namespace carom::farm
