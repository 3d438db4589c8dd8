#include "pipeline/farm/engine.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "core/hash.h"
#include "pipeline/farm/slurm.h"

namespace carom::farm {
namespace {

/// Of jobs whose tasks are started by hand, or by something that carom does not talk to.
class NoEngine : public Engine {
  public:
    [[nodiscard]] std::int64_t submit(const FarmJob& job, const Round& /*round*/,
                                      const Stage& /*stage*/,
                                      const Begin& /*begin*/) const override {
        throw Error("the tasks of this job are started outside carom (" + job.engine +
                    "); start them again as '" + job.folder + "/README.md' says");
    }
    [[nodiscard]] std::vector<Answer> ask(const std::vector<FarmJob>& jobs) const override {
        return std::vector<Answer>(jobs.size());
    }
    void cancel(const FarmJob& /*job*/, Which /*which*/) const override {}
    [[nodiscard]] std::string tag(const FarmJob& job) const override { return tag_of_folder(job); }
};

}  // namespace

std::chrono::seconds usable_time(std::chrono::minutes limit) {
    constexpr std::chrono::seconds kEarly{60 + kGrace + 5};
    return std::max(std::chrono::seconds(limit) / 2, limit - kEarly);
}

bool is_active(const Task& task) {
    return task.state == TaskState::waiting || task.state == TaskState::running;
}

Limits Engine::limits(const FarmJob& /*job*/) const {
    return {};
}

std::int64_t Answer::count(TaskState state) const {
    return tasks ? std::ranges::count(*tasks, state, &Task::state) : 0;
}

bool Answer::is_queued() const {
    return tasks && std::ranges::any_of(*tasks, is_active);
}

const Engine& engine_of(const FarmJob& job) {
    static const Slurm slurm;
    static const NoEngine none;
    return has_queue(job) ? static_cast<const Engine&>(slurm) : none;
}

bool has_queue(const FarmJob& job) {
    return job.engine == "slurm";
}

std::map<std::string, Answer> ask_engines(const std::vector<FarmJob>& jobs) {
    std::map<const Engine*, std::vector<FarmJob>> asked;
    for (const FarmJob& job : jobs) {
        asked[&engine_of(job)].push_back(job);
    }
    std::map<std::string, Answer> by_folder;
    for (const auto& [engine, own] : asked) {
        std::vector<Answer> answers = engine->ask(own);
        for (std::size_t i = 0; i < own.size(); ++i) {
            by_folder[own[i].folder] = std::move(answers[i]);
        }
    }
    return by_folder;
}

std::string tag_of_folder(const FarmJob& job) {
    return "carom-" + hash_bytes(std::as_bytes(std::span(job.folder))).to_string();
}

std::vector<std::int64_t> submit_stages(const FarmJob& job, const Round& round,
                                        const std::vector<std::int64_t>& others) {
    const Engine& engine = engine_of(job);
    std::vector<std::int64_t> numbers;
    try {
        for (const Stage& stage : stages()) {
            // The workers need not wait for those that run already; the film does.
            Begin begin;
            if (!numbers.empty()) {
                begin.after = others;
                begin.after.push_back(numbers.back());
            }
            numbers.push_back(engine.submit(job, round, stage, begin));
        }
    } catch (const Error& error) {
        const std::string problem = error.what();
        try {
            engine.cancel(job, Which::waiting);
        } catch (const Error& other) {
            throw Error(problem + "; " + other.what());
        }
        throw Error(problem);
    }
    return numbers;
}

}  // namespace carom::farm
