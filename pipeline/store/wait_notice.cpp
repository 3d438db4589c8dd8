#include "pipeline/store/wait_notice.h"

#include <fmt/core.h>

namespace carom::pipeline {

std::optional<std::string> WaitNotice::due(Clock::time_point now) {
    constexpr std::chrono::seconds kFirst{30};
    constexpr std::chrono::seconds kInMinutes{120};
    if (!since_) {
        since_ = now;
        next_ = kFirst;
    }
    const auto waited = std::chrono::floor<std::chrono::seconds>(now - *since_);
    if (waited < next_) {
        return std::nullopt;
    }
    next_ = 2 * waited;
    return waited < kInMinutes ? fmt::format("{} s", waited.count())
                               : fmt::format("{} min", waited.count() / 60);
}

}  // namespace carom::pipeline
