#include "pipeline/farm/round.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/record.h"

namespace carom::farm {
namespace {

std::vector<std::string> names_in(const std::string& text) {
    std::istringstream words(text);
    std::vector<std::string> names;
    for (std::string name; words >> name;) {
        names.push_back(name);
    }
    return names;
}

/// Raises a factor because of `count` tasks. Returns what to say, if there is anything.
std::string raised(std::int64_t count, std::int64_t& factor, std::int64_t most,
                   const std::string& what, const std::string& unit, std::int64_t first) {
    if (count == 0) {
        return "";
    }
    const std::int64_t before = factor;
    factor = std::min(most, kLimitFactor * factor);
    const std::string ended =
        fmt::format("; {} ended by the {} limit of {} {}",
                    counted(static_cast<std::uint64_t>(count), "task"), what, first * before, unit);
    return factor > before ? ended + fmt::format(", the next have {} {}", first * factor, unit)
                           : ended + ", which is raised no more";
}

}  // namespace

std::int64_t time_of(const FarmJob& job, const Round& round, const Stage& stage) {
    return round.time_factor * job.*stage.time;
}

std::int64_t memory_of(const FarmJob& job, const Round& round) {
    return round.memory_factor * job.memory;
}

std::vector<std::string> excluded_nodes(const Round& round) {
    std::map<std::string, std::int64_t> failures;
    for (const std::string& node : round.failed) {
        ++failures[node];
    }
    std::vector<std::string> excluded;
    for (const auto& failure : failures) {
        const bool others_work = std::ranges::any_of(
            round.worked, [&](const std::string& node) { return node != failure.first; });
        if (failure.second >= kFailuresOfNode && others_work) {
            excluded.push_back(failure.first);
        }
    }
    return excluded;
}

namespace {

/// Notes on which nodes tasks went well and on which they failed.
void learn_nodes(Round& round, const std::vector<Task>& ended) {
    std::set<std::string> worked(round.worked.begin(), round.worked.end());
    std::set<std::string> now;
    for (const Task& task : ended) {
        if (task.state == TaskState::done || task.state == TaskState::out_of_time) {
            now.insert(task.node);
        }
    }
    std::erase_if(round.failed, [&](const std::string& node) { return now.contains(node); });
    for (const Task& task : ended) {
        if (task.state == TaskState::failed && !now.contains(task.node)) {
            round.failed.push_back(task.node);
        }
    }
    worked.merge(now);
    round.worked.assign(worked.begin(), worked.end());
}

}  // namespace

void learn(Round& round, const FarmJob& job, const std::vector<Task>& tasks,
           const std::string& problem) {
    const std::vector<std::string> known = excluded_nodes(round);
    std::vector<Task> ended;
    std::ranges::copy_if(tasks, std::back_inserter(ended), [&](const Task& task) {
        return !task.node.empty() &&
               std::ranges::find(round.numbers, task.job) != round.numbers.end();
    });
    learn_nodes(round, ended);
    const auto count = [&](TaskState state) {
        return std::ranges::count(ended, state, &Task::state);
    };
    round.reason = problem;
    round.reason += raised(count(TaskState::out_of_time), round.time_factor, kMostTimeFactor,
                           "time", "min", job.*stages().front().time);
    round.reason += raised(count(TaskState::out_of_memory), round.memory_factor, kMostMemoryFactor,
                           "memory", "MB", job.memory);
    for (const std::string& node : excluded_nodes(round)) {
        if (std::ranges::find(known, node) == known.end()) {
            round.reason += fmt::format(
                "; node {} is left out, since {} failed on it", node,
                counted(static_cast<std::uint64_t>(std::ranges::count(round.failed, node)),
                        "task"));
        }
    }
}

Round next_round(Round last, const Progress& now) {
    const bool is_better = now.missing < last.begin.missing || now.samples > last.begin.samples;
    last.idle = is_better ? 0 : last.idle + 1;
    ++last.number;
    last.begin = now;
    return last;
}

JsonMembers numbers_of(const Round& round) {
    JsonMembers members;
    for (std::size_t i = 0; i < round.numbers.size(); ++i) {
        members.add(stages()[i].name, round.numbers[i]);
    }
    return members;
}

void write_round(const FarmJob& job, const Round& round) {
    JsonMembers members = numbers_of(round);
    members.add("round", round.number)
        .add("missing", round.begin.missing)
        .add("samples", round.begin.samples)
        .add("idle_rounds", round.idle)
        .add("time_factor", round.time_factor)
        .add("memory_factor", round.memory_factor)
        .add("failed_on", join(round.failed, " "))
        .add("worked_on", join(round.worked, " "))
        .add("reason", round.reason);
    write_record(job.folder + "/round.json", members);
}

std::optional<Round> read_round(const FarmJob& job) {
    const std::optional<Record> record = Record::read(job.folder + "/round.json");
    if (!record) {
        return std::nullopt;
    }
    Round round;
    for (std::size_t i = 0; i < round.numbers.size(); ++i) {
        round.numbers[i] = record->integer(stages()[i].name);
    }
    round.number = record->integer("round");
    round.begin = {record->integer("missing"), record->integer("samples")};
    round.idle = record->integer("idle_rounds");
    round.time_factor = record->integer("time_factor");
    round.memory_factor = record->integer("memory_factor");
    round.failed = names_in(record->text("failed_on"));
    round.worked = names_in(record->text("worked_on"));
    round.reason = record->text("reason");
    return round;
}

}  // namespace carom::farm
