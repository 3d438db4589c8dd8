// How claims on frames live and die (claims.h).
#pragma once

#include <chrono>

namespace carom::pipeline {

struct ClaimTimes {
    std::chrono::milliseconds beat{5000};         // between two counts
    std::chrono::milliseconds dead_after{30000};  // without a new count; several times `beat`
    /// Whether finished claims stay when the process ends, for machines that see results late.
    /// Somebody has to remove them (Claims::forget).
    bool keeps_finished = false;
};

/// A beat of a sixth of `dead_after`.
[[nodiscard]] inline ClaimTimes claim_times(std::chrono::milliseconds dead_after) {
    return {dead_after / 6, dead_after};
}

}  // namespace carom::pipeline
