#include "lab/comparison/lane_limit.h"

#include <cstdint>

#include <hwy/highway.h>

#include "core/assert.h"

namespace carom::pipeline {

namespace {

/// Highway's target with vectors of so many floats; 0 if no target has them.
std::int64_t target_of(int lanes) {
    return lanes == 4 ? HWY_SSE4 : (lanes == 8 ? HWY_AVX2 : (lanes == 16 ? HWY_AVX3 : 0));
}

}  // namespace

LaneLimit::LaneLimit(int lanes) {
    CAROM_ASSERT(machine_has(lanes));
    // A better target has a lower bit. Those above AVX3 have vectors of the same size.
    hwy::DisableTargets(lanes == 16 ? 0 : target_of(lanes) - 1);
}

LaneLimit::~LaneLimit() {
    hwy::DisableTargets(0);
}

bool LaneLimit::machine_has(int lanes) {
    // Asked once, because Highway forgets a limit when it is asked for the processor's targets.
    static const std::int64_t targets = hwy::SupportedTargets();
    return (targets & target_of(lanes)) != 0;
}

}  // namespace carom::pipeline
