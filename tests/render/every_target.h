// Tests on every instruction set for which vector code is compiled.
#pragma once

#include <cstdint>
#include <functional>

#include <hwy/highway.h>
#include <hwy/targets.h>

namespace carom::test {

/// Calls `use` once for each instruction set of this machine, with its name ("SSE4"), while
/// HWY_DYNAMIC_DISPATCH chooses its functions.
inline void for_each_instruction_set(const std::function<void(const char* name)>& use) {
    const auto choose = [](std::int64_t targets) {
        hwy::SetSupportedTargetsForTest(targets);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    };
    const std::int64_t supported = hwy::SupportedTargets();
    for (int bit = 0; bit < 63; ++bit) {
        const std::int64_t target = std::int64_t{1} << bit;
        // The lowest target is always there, though it is not always reported.
        const bool is_lowest = target == HWY_STATIC_TARGET;
        if ((HWY_TARGETS & target) != 0 && ((supported & target) != 0 || is_lowest)) {
            choose(target);
            use(hwy::TargetName(target));
        }
    }
    choose(0);
}

}  // namespace carom::test
