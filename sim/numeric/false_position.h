// The zero of a continuous function between two points of opposite signs.
#pragma once

#include <cmath>

namespace carom::sim {

/// A point of an interval and the value of the function there.
struct ValueAt {
    double at = 0;
    double value = 0;
};

/// The place between `low` and `high`, whose values have opposite signs, at which `function`
/// is at most `close` from 0: the rule of false position in its Illinois variant (Dowell and
/// Jarratt 1971), in which an end of the interval that stays for a second time counts half. The
/// place is the last one at which `function` was called; without a call it is `high`.
template <typename Function>
double false_position(ValueAt low, ValueAt high, double close, Function function) {
    const double sign = high.value >= 0 ? 1 : -1;
    ValueAt last = high;
    double last_side = 0;  // neither side has stayed yet
    for (int i = 0; i < 60 && std::abs(last.value) > close; ++i) {
        last.at = low.at + (high.at - low.at) * (low.value / (low.value - high.value));
        last.value = function(last.at);
        const double side = last.value * sign >= 0 ? 1 : -1;
        if (side > 0) {
            high = last;
            low.value *= last_side > 0 ? 0.5 : 1;
        } else {
            low = last;
            high.value *= last_side < 0 ? 0.5 : 1;
        }
        last_side = side;
    }
    return last.at;
}

}  // namespace carom::sim
