#include "pipeline/farm/round.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <utility>

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

std::vector<std::int64_t> integers_in(const std::string& text) {
    std::istringstream words(text);
    return {std::istream_iterator<std::int64_t>(words), {}};
}

std::string text_of(const std::vector<std::int64_t>& numbers) {
    std::string text;
    for (const std::int64_t number : numbers) {
        text += (text.empty() ? "" : " ") + std::to_string(number);
    }
    return text;
}

/// A factor of the job's limits, and how far it goes.
struct Factor {
    std::int64_t& factor;
    std::int64_t most_factor;
    std::int64_t first;  // limit
    std::int64_t most;   // of the engine; 0: any

    /// Returns whether it was raised.
    [[nodiscard]] bool raise() const {
        const std::int64_t next = std::min(most_factor, kLimitFactor * factor);
        const bool has_room = next > factor && (most == 0 || first * next <= most);
        factor = has_room ? next : factor;
        return has_room;
    }
};

/// Raises a factor because of `count` tasks. Returns what to say, if there is anything.
std::string raised(std::int64_t count, const Factor& factor, const std::string& what,
                   const std::string& unit) {
    if (count == 0) {
        return "";
    }
    const std::string ended = fmt::format("; {} ended by the {} limit of {} {}",
                                          counted(static_cast<std::uint64_t>(count), "task"), what,
                                          factor.first * factor.factor, unit);
    return factor.raise()
               ? ended + fmt::format(", the next have {} {}", factor.first * factor.factor, unit)
               : ended + ", which is raised no more";
}

/// That of the time of a stage.
std::int64_t Round::*factor_of(const Stage& stage) {
    return stage.is_array ? &Round::time_factor : &Round::film_factor;
}

Factor time_factor(Round& round, const FarmJob& job, const Stage& stage, const Limits& most) {
    return {round.*factor_of(stage), kMostTimeFactor, job.*stage.time, most.minutes};
}

}  // namespace

std::int64_t time_of(const FarmJob& job, const Round& round, const Stage& stage) {
    return round.*factor_of(stage) * job.*stage.time;
}

std::int64_t memory_of(const FarmJob& job, const Round& round) {
    return round.memory_factor * job.memory;
}

std::vector<std::string> excluded_nodes(const Round& round) {
    std::map<std::string, std::int64_t> failures;
    for (const std::string& node : round.failed) {
        ++failures[node];
    }
    std::set<std::string> seen(round.worked.begin(), round.worked.end());
    std::vector<std::pair<std::int64_t, std::string>> bad;  // by failures, the worst first
    for (const auto& failure : failures) {
        const std::string& node = failure.first;
        const bool others_work = std::ranges::any_of(
            round.worked, [&](const std::string& other) { return other != node; });
        if (failure.second >= kFailuresOfNode && others_work) {
            bad.emplace_back(-failure.second, node);
        }
        seen.insert(node);
    }
    std::ranges::sort(bad);
    bad.resize(std::min(bad.size(), std::max<std::size_t>(1, seen.size() / 3)));
    std::vector<std::string> excluded;
    excluded.reserve(bad.size());
    for (auto& [count, node] : bad) {
        excluded.push_back(std::move(node));
    }
    std::ranges::sort(excluded);
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

void note_numbers(Round& round, const std::vector<std::int64_t>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] != 0) {
            round.numbers[i] = numbers[i];
            round.not_learned.push_back(numbers[i]);
        }
    }
}

void learn(Round& round, const FarmJob& job, const std::vector<Task>& tasks,
           const std::string& problem, const Limits& most) {
    const std::vector<std::string> known = excluded_nodes(round);
    std::set<std::int64_t> awaited(round.not_learned.begin(), round.not_learned.end());
    std::vector<Task> ended;
    std::ranges::copy_if(tasks, std::back_inserter(ended), [&](const Task& task) {
        return !task.node.empty() && !is_active(task) && awaited.contains(task.job);
    });
    learn_nodes(round, ended);
    const auto count = [&](TaskState state, const Stage* stage) {
        return std::ranges::count_if(ended, [&](const Task& task) {
            return task.state == state && (stage == nullptr || task.stage == stage);
        });
    };
    round.reason = problem;
    for (const Stage& stage : stages()) {
        round.reason += raised(count(TaskState::out_of_time, &stage),
                               time_factor(round, job, stage, most), "time", "min");
    }
    round.reason += raised(count(TaskState::out_of_memory, nullptr),
                           {round.memory_factor, kMostMemoryFactor, job.memory, most.megabytes},
                           "memory", "MB");
    for (const std::string& node : excluded_nodes(round)) {
        if (std::ranges::find(known, node) == known.end()) {
            round.reason += fmt::format(
                "; node {} is left out, since {} failed on it", node,
                counted(static_cast<std::uint64_t>(std::ranges::count(round.failed, node)),
                        "task"));
        }
    }
    std::erase_if(round.not_learned, [&](std::int64_t number) {
        return std::ranges::none_of(
            tasks, [&](const Task& task) { return task.job == number && is_active(task); });
    });
}

bool learn_film_time(Round& round, const FarmJob& job, const Limits& most) {
    const std::int64_t before = round.film_factor;
    round.reason = "the film was not written" +
                   raised(1, time_factor(round, job, stages().back(), most), "time", "min");
    std::erase(round.not_learned, round.numbers.back());
    return round.film_factor > before;
}

Round next_round(Round last, const Progress& now) {
    const bool is_better = now.missing < last.begin.missing || now.samples > last.begin.samples;
    last.idle = is_better ? 0 : last.idle + 1;
    ++last.number;
    last.film_attempts = 0;
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
        .add("film_attempts", round.film_attempts)
        .add("not_learned", text_of(round.not_learned))
        .add("time_factor", round.time_factor)
        .add("film_time_factor", round.film_factor)
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
    round.film_attempts = record->integer("film_attempts");
    round.not_learned = integers_in(record->text("not_learned"));
    round.time_factor = record->integer("time_factor");
    round.film_factor = std::max<std::int64_t>(1, record->integer("film_time_factor"));
    round.memory_factor = record->integer("memory_factor");
    round.failed = names_in(record->text("failed_on"));
    round.worked = names_in(record->text("worked_on"));
    round.reason = record->text("reason");
    return round;
}

}  // namespace carom::farm
