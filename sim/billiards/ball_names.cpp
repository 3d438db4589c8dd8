#include "sim/billiards/ball_names.h"

#include <algorithm>

namespace carom::sim::billiards {

std::optional<int> pool_number(std::string_view name) {
    const auto* const found = std::find(kPoolBalls.begin() + 1, kPoolBalls.end(), name);
    return found == kPoolBalls.end() ? std::nullopt
                                     : std::optional(static_cast<int>(found - kPoolBalls.begin()));
}

std::optional<int> snooker_value(std::string_view name) {
    if (name == "red" || name.starts_with("red_")) {
        return 1;
    }
    constexpr std::array<std::string_view, 6> kColours{"yellow", "green", "brown",
                                                       "blue",   "pink",  "black"};
    const auto* const found = std::find(kColours.begin(), kColours.end(), name);
    return found == kColours.end() ? std::nullopt
                                   : std::optional(static_cast<int>(found - kColours.begin()) + 2);
}

}  // namespace carom::sim::billiards
