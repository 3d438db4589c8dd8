#include "sim/spatial/advance.h"

#include <algorithm>

namespace carom::sim {
namespace {

constexpr int kMostSteps = 200;
// A pair in touch is looked at again this much later (s), to see whether it closes or opens.
constexpr double kGlimpse = 1e-7;

}  // namespace

std::optional<double> first_closing(const std::function<double(double)>& gap_at, double speed,
                                    double now, double until) {
    double time = now;
    double gap = gap_at(time);
    if (gap <= kAdvanceDistance) {
        const double later = gap_at(time + kGlimpse);
        if (later < gap)
            return time;
        // Opening: go on from where it is open, or closing again.
        double step = kGlimpse;
        while (gap <= kAdvanceDistance) {
            time += step;
            if (time > until)
                return std::nullopt;
            const double next = gap_at(time);
            if (next < gap)
                return time;
            gap = next;
            step *= 2;
        }
    }
    if (!(speed > 0))
        return std::nullopt;
    for (int i = 0; i < kMostSteps; ++i) {
        if (gap <= kAdvanceDistance)
            return time;
        time += std::max(gap / speed, 1e-12);
        if (time > until)
            return std::nullopt;
        gap = gap_at(time);
    }
    return gap < 1e-7 ? std::optional(time) : std::nullopt;
}

}  // namespace carom::sim
