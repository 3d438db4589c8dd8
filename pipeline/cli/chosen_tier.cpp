#include "pipeline/cli/chosen_tier.h"

#include <fmt/core.h>

#include "pipeline/cli/run_program.h"

namespace carom::cli {

ChosenTier::ChosenTier(const std::string& option) {
    if (option.empty()) {
        return;
    }
    const std::string_view tier = render::tier_named(option);
    if (!render::machine_has_tier(tier)) {
        throw InputError(fmt::format("--tier {}: this machine has only {} instructions", option,
                                     render::simd_tier()));
    }
    limit_.emplace(tier);
}

}  // namespace carom::cli
