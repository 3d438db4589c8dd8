#include "pipeline/farm/own_task.h"

#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <random>
#include <string_view>

#include <fmt/core.h>

#include "pipeline/store/claim_note.h"

namespace carom::farm {
namespace {

struct Variable {
    const char* name;
    std::int64_t first;  // number
};

constexpr std::string_view kArrayTask = "SLURM_ARRAY_TASK_ID";

// GNU parallel may run in a task of Slurm, so it comes first.
constexpr std::array<Variable, 8> kVariables{{{"CAROM_TASK", 0},
                                              {"PARALLEL_SEQ", 1},
                                              {"SLURM_ARRAY_TASK_ID", 0},
                                              {"JOB_COMPLETION_INDEX", 0},
                                              {"AWS_BATCH_JOB_ARRAY_INDEX", 0},
                                              {"PBS_ARRAY_INDEX", 0},
                                              {"LSB_JOBINDEX", 1},
                                              {"SGE_TASK_ID", 1}}};

/// Empty if the text is no number, as "undefined" of SGE outside an array.
std::optional<std::int64_t> number_in(const std::string& text) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_number = error == std::errc() && end == text.data() + text.size();
    return is_number ? std::optional(number) : std::nullopt;
}

}  // namespace

OwnTask own_task(const ReadVariable& read) {
    OwnTask task;
    // So that those without a number begin at different frames.
    task.number = std::random_device()() % 1000;
    std::string array;  // of Slurm, if the number is that of its task
    for (const Variable& variable : kVariables) {
        const std::optional<std::int64_t> number = number_in(read(variable.name));
        if (number && *number >= variable.first) {
            task.number = *number - variable.first;
            array = variable.name == kArrayTask ? read("SLURM_ARRAY_JOB_ID") : "";
            break;
        }
    }
    task.name = array.empty() ? pipeline::host_prefix() + pipeline::new_claim_process()
                              : fmt::format("{}_{}", array, task.number);
    const std::string node = read("SLURMD_NODENAME");
    task.host = node.empty() ? pipeline::this_host() : node;
    task.may_be_run_again = !read("SLURM_JOB_ID").empty();
    return task;
}

OwnTask own_task() {
    return own_task([](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value != nullptr ? value : "");
    });
}

}  // namespace carom::farm
