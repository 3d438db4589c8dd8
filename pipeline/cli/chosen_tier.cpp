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

std::string tier_to_mux(const std::string& option, Console& console,
                        const std::function<std::string()>& stored) {
    if (!option.empty()) {
        return std::string(render::tier_named(option));
    }
    std::string tier = stored();
    if (tier != render::simd_tier()) {
        console.info("the frames were rendered with " + tier + " instructions");
    }
    return tier;
}

}  // namespace carom::cli
