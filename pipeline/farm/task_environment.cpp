#include "pipeline/farm/task_environment.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <unistd.h>

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace carom::farm {
namespace {

constexpr const char* kMore = "CAROM_FARM_VARIABLES";

// For the system's programs and libraries, and the file with the tickets for the store; then
// carom's own. CAROM names the program in the scripts of an exported job.
constexpr std::string_view kNames =
    "PATH LD_LIBRARY_PATH HOME USER LOGNAME SHELL LANG TZ TMPDIR XDG_CACHE_HOME KRB5CCNAME "
    "CAROM CAROM_CACHE CAROM_CACHE_SIZE CAROM_CONFIGS CAROM_FARM_VARIABLES CAROM_LAB CAROM_LIMITS "
    "OCIO";

// Of the language, and Slurm's: its options, and those variables that it passes on in any case.
constexpr std::array<std::string_view, 3> kBeginnings{"LC_", "SBATCH_", "SLURM_"};

bool is_word_of(std::string_view name, std::string_view words) {
    const std::string padded = " " + std::string(words) + " ";
    return !name.empty() && padded.find(" " + std::string(name) + " ") != std::string::npos;
}

}  // namespace

bool is_for_tasks(std::string_view name, std::string_view more) {
    return is_word_of(name, kNames) || is_word_of(name, more) ||
           std::ranges::any_of(kBeginnings, [&](std::string_view beginning) {
               return name.starts_with(beginning);
           });
}

std::vector<std::string> task_environment() {
    const char* more = std::getenv(kMore);
    std::vector<std::string> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text = *variable;
        if (is_for_tasks(text.substr(0, text.find('=')), more == nullptr ? "" : more)) {
            variables.emplace_back(text);
        }
    }
    return variables;
}

}  // namespace carom::farm
