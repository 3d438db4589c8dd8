#include "sim/timeline/energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::sim {
namespace {

bool is_force_event(EventKind kind) {
    switch (kind) {
        case EventKind::force:
        case EventKind::torque:
        case EventKind::impulse:
        case EventKind::velocity:
        case EventKind::strike:
        case EventKind::placed:
        case EventKind::removed:
            return true;
        default:
            return false;
    }
}

/// True if a force event acts, or a ball is put elsewhere, between two samples. One sample is taken
/// immediately before and one immediately after the beginning of each event.
bool is_forced(const Timeline& timeline, double from, double to) {
    return std::any_of(timeline.events.begin(), timeline.events.end(), [=](const Event& event) {
        const bool is_instant = from == to && event.time == from;
        return is_force_event(event.kind) &&
               (is_instant || (event.time < to && event.end_time > from));
    });
}

/// Calls `visit` with each rise of the total energy, less the work of bodies moved by keys, above
/// its lowest value since the last force event, and with the largest kinetic energy or work since
/// then, J: what a body that creeps puts in is far more than it moves with.
template <typename Visit>
void visit_rises(const Timeline& timeline, Visit visit) {
    double lowest = std::numeric_limits<double>::infinity();
    double exchanged = 0;
    double work_before = 0;
    for (std::size_t i = 0; i < timeline.energy.size(); ++i) {
        const EnergySample& sample = timeline.energy[i];
        const double own = sample.total() - sample.work;
        if (i > 0 && is_forced(timeline, timeline.energy[i - 1].time, sample.time)) {
            lowest = own;
            exchanged = 0;
            work_before = sample.work;
        }
        exchanged = std::max({exchanged, sample.kinetic, std::abs(sample.work - work_before)});
        if (own > lowest && exchanged > 0) {
            visit(own - lowest, exchanged);
        }
        lowest = std::min(lowest, own);
    }
}

}  // namespace

double largest_energy_rise(const Timeline& timeline) {
    double largest = 0;
    visit_rises(timeline, [&](double rise, double exchanged) {
        largest = std::max(largest, rise / exchanged);
    });
    return largest;
}

double largest_energy_gain(const Timeline& timeline) {
    double largest = 0;
    visit_rises(timeline, [&](double rise, double) { largest = std::max(largest, rise); });
    return largest;
}

}  // namespace carom::sim
