// The environment variables that tasks get from whoever submits them. Slurm keeps them in its state
// and hands them to all nodes, so secrets in other variables stay where they are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom::farm {

/// Whether tasks get the variable: those that programs are found by, those that carom and Slurm
/// read, and those that `more` names, separated by spaces.
[[nodiscard]] bool is_for_tasks(std::string_view name, std::string_view more = {});

/// The variables of this process that tasks get, as NAME=VALUE. CAROM_FARM_VARIABLES names more.
[[nodiscard]] std::vector<std::string> task_environment();

}  // namespace carom::farm
