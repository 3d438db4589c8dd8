#include "sim/spatial/conservative_advancement.h"

#include <algorithm>

#include "sim/numeric/tolerances.h"

namespace carom::sim {
namespace {

using Gap = std::function<double(double)>;

// A touching pair is evaluated again this much later (s), to see whether it closes or opens.
constexpr double kProbeInterval = 1e-7;
// Accuracy of the gaps (m).
constexpr double kGapError = 1e-14;
constexpr double kShortest = 1e-6;  // s

struct Instant {
    double time = 0;
    double gap = 0;
};

/// The time at which the gap closes between an open and a closed instant, by bisection.
double closing_between(const Gap& gap_at, Instant open, Instant closed) {
    for (int i = 0; i < 60; ++i) {
        const double middle = open.time + 0.5 * (closed.time - open.time);
        if (middle <= open.time || middle >= closed.time) {
            break;
        }
        const double gap = gap_at(middle);
        (gap > 0 ? open : closed) = {middle, gap};
    }
    return open.time;
}

std::optional<double> search(const Gap& gap_at, double speed, const Instant& from,
                             const Instant& to) {
    const double span = to.time - from.time;
    if (to.gap > 0 && (from.gap + to.gap > speed * span || span < kShortest)) {
        return std::nullopt;
    }
    if (span < kShortest) {
        return closing_between(gap_at, from, to);
    }
    const double time = from.time + 0.5 * span;
    const Instant middle{time, gap_at(time)};
    if (const auto found = search(gap_at, speed, from, middle)) {
        return found;
    }
    // The gap can close only after an instant at which it is open.
    return middle.gap > 0 ? search(gap_at, speed, middle, to) : std::nullopt;
}

}  // namespace

std::optional<double> first_closing(const Gap& gap_at, double speed, double now, double until) {
    if (!(until > now)) {
        return std::nullopt;
    }
    Instant from{now, gap_at(now)};
    if (from.gap <= kClosedBySearch) {
        if (gap_at(now + kProbeInterval) < from.gap - kGapError) {
            return now;
        }
        // Opening: an existing overlap has to vanish before a new impact.
        double step = kProbeInterval;
        while (from.gap <= 0) {
            const Instant next{from.time + step, gap_at(from.time + step)};
            if (next.time >= until) {
                return std::nullopt;
            }
            if (next.gap < from.gap - kGapError) {
                return next.time;
            }
            from = next;
            step *= 2;
        }
    }
    return search(gap_at, speed, from, {until, gap_at(until)});
}

}  // namespace carom::sim
