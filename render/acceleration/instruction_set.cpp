#include "render/acceleration/instruction_set.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <fmt/core.h>
#include <hwy/highway.h>

#include "core/error.h"

namespace carom::render {
namespace {

struct InstructionSet {
    std::string_view name;
    std::int64_t target;  // Highway's; a better one has a lower bit
};

// g++ compiles the lowest target as SCALAR, clang as EMU128.
constexpr std::int64_t kLowest = (HWY_TARGETS & HWY_SCALAR) != 0 ? HWY_SCALAR : HWY_EMU128;
constexpr std::array<InstructionSet, 5> kSets{{{"scalar", kLowest},
                                               {"ssse3", HWY_SSSE3},
                                               {"sse4", HWY_SSE4},
                                               {"avx2", HWY_AVX2},
                                               {"avx512", HWY_AVX3}}};

void limit_to(std::string_view name) {
    const auto* const set = std::ranges::find(kSets, name, &InstructionSet::name);
    if (set == kSets.end()) {
        throw Error(
            fmt::format("CAROM_SIMD is '{}' in the environment, and only scalar, ssse3, "
                        "sse4, avx2 and avx512 are known",
                        name));
    }
    if (set->target != kLowest && (hwy::SupportedTargets() & set->target) == 0) {
        throw Error(fmt::format(
            "CAROM_SIMD is '{}' in the environment, and this processor lacks these instructions",
            name));
    }
    hwy::DisableTargets(set->target - 1);
}

}  // namespace

void limit_instructions() {
    static const bool is_read = [] {
        const char* const name = std::getenv("CAROM_SIMD");
        if (name != nullptr && *name != 0) {
            limit_to(name);
        }
        return true;
    }();
    static_cast<void>(is_read);
}

}  // namespace carom::render
