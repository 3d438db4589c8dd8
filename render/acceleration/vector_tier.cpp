#include "render/acceleration/vector_tier.h"

#include <algorithm>
#include <cstdint>

#include <hwy/highway.h>

#include "core/assert.h"
#include "render/acceleration/analytic_kernels.h"

namespace carom::render {
namespace {

// Highway's targets in the order of kTierOptions. g++ calls the last one SCALAR, clang EMU128; they
// are two tiers, since their code differs.
constexpr std::int64_t kLowest = (HWY_TARGETS & HWY_SCALAR) != 0 ? HWY_SCALAR : HWY_EMU128;
constexpr std::array<std::int64_t, kTierOptions.size()> kTargets{HWY_AVX2, HWY_SSE4, HWY_SSSE3,
                                                                 kLowest};

/// The target of a tier's name; 0 if there is none.
std::int64_t target_of(std::string_view tier) {
    const auto* const found = std::ranges::find_if(
        kTargets, [&](std::int64_t target) { return tier == hwy::TargetName(target); });
    return found == kTargets.end() ? 0 : *found;
}

}  // namespace

std::string_view tier_named(std::string_view option) {
    for (std::size_t i = 0; i < kTierOptions.size(); ++i) {
        if (kTierOptions[i] == option) {
            return hwy::TargetName(kTargets[i]);
        }
    }
    return {};
}

bool machine_has_tier(std::string_view tier) {
    const std::int64_t target = target_of(tier);
    return target != 0 && (target == kLowest || (hwy::SupportedTargets() & target) != 0);
}

std::string_view simd_tier() {
    return best_kernels().tier;
}

TierLimit::TierLimit(std::string_view tier) {
    CAROM_ASSERT(machine_has_tier(tier));
    // A better target has a lower bit. Those above AVX2 give its bits and may stay.
    const std::int64_t target = target_of(tier);
    hwy::DisableTargets(target == HWY_AVX2 ? 0 : target - 1);
}

TierLimit::~TierLimit() {
    hwy::DisableTargets(0);
}

}  // namespace carom::render
