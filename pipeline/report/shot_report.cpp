#include "pipeline/report/shot_report.h"

#include <algorithm>
#include <cmath>

#include "pipeline/report/event_motion.h"
#include "sim/timeline/energy.h"

namespace carom::pipeline {

namespace {

using sim::Event;
using sim::EventKind;
using sim::Key;
using sim::Timeline;
using sim::Track;

constexpr double kSameTime = 1e-9;    // s
constexpr double kStill = 1e-6;       // m, m/s, rad/s
constexpr double kPathRate = 480;     // samples per second along a path
constexpr int kMostPathSteps = 4800;  // between two keys

std::optional<SpeedChange> speeds_of(const Track* track, double time) {
    if (track == nullptr) {
        return std::nullopt;
    }
    const Velocities v = velocities_at(*track, time);
    return SpeedChange{v.before.length(), v.after.length(), v.spin_before, v.spin_after};
}

ReportedEvent reported(const Timeline& timeline, const Event& event) {
    const Track* a = timeline.find(event.a);
    // A spot may have the name of a ball.
    const bool has_other = !event.b.empty() && event.kind != EventKind::placed;
    const Track* b = has_other ? timeline.find(event.b) : nullptr;
    return {event, speeds_of(a, event.time), speeds_of(b, event.time), cut_of(event, a, b), {}};
}

double length_between(const Track& track, const Key& from, const Key& to) {
    const double duration = to.time - from.time;
    const int steps = std::clamp(static_cast<int>(duration * kPathRate), 4, kMostPathSteps);
    Vec3 last = from.position;
    double length = 0;
    for (int i = 1; i <= steps; ++i) {
        const Vec3 next =
            i == steps ? to.position : track.sample(from.time + duration * i / steps).position;
        length += (next - last).length();
        last = next;
    }
    return length;
}

/// Updates the top speed between two keys: an object that is moved by keys is often fastest there.
void find_top_speed_between(const Track& track, const Key& from, const Key& to,
                            ReportedObject& object) {
    constexpr double kFaster =
        1.001;  // than at any key: more than the rounding errors of a free motion
    const double duration = to.time - from.time;
    const int steps = std::clamp(static_cast<int>(duration * kPathRate), 4, kMostPathSteps);
    for (int i = 1; i < steps; ++i) {
        const double time = from.time + duration * i / steps;
        const double speed = track.sample(time).velocity.length();
        if (speed > kFaster * object.top_speed + kStill) {
            object.top_speed = speed;
            object.top_time = time;
        }
    }
}

void measure_motion(const Track& track, ReportedObject& object) {
    const auto keys = track.keys();
    const double start_height = keys.front().position.z;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const Key& key = keys[i];
        for (const Vec3& velocity : {key.velocity_in, key.velocity_out}) {
            if (velocity.length() > object.top_speed) {
                object.top_speed = velocity.length();
                object.top_time = key.time;
            }
        }
        if (i + 1 < keys.size() && !track.jumps_after(i)) {
            object.path += length_between(track, key, keys[i + 1]);
            find_top_speed_between(track, key, keys[i + 1], object);
            const sim::Bounds bounds = track.position_bounds(key.time, keys[i + 1].time);
            object.rise = std::max(object.rise, bounds.high.z - start_height);
        }
    }
}

bool has_stopped(const Key& from, const Key& to) {
    return (to.position - from.position).length() <= kStill &&
           from.velocity_out.length() <= kStill && to.velocity_in.length() <= kStill;
}

bool stands(const Key& from, const Key& to) {
    return has_stopped(from, to) && from.orientation == to.orientation &&
           from.angular_velocity_out.length() <= kStill &&
           to.angular_velocity_in.length() <= kStill;
}

/// The time since which an object has been at rest, or has turned in place, at its last key; the
/// start of the track if it has done nothing else.
double stopped_at(const Track& track, bool (*has_state)(const Key&, const Key&)) {
    const auto keys = track.keys();
    std::size_t i = keys.size() - 1;
    while (i > 0 && has_state(keys[i - 1], keys[i])) {
        --i;
    }
    return keys[i].time;
}

void find_fate(const Timeline& timeline, const Track& track, ReportedObject& object) {
    const Key& last = track.keys().back();
    // After its last key an object is at rest; for example one that is moved by keys, when they
    // end.
    const bool has_ended = last.time < timeline.end_time - kSameTime;
    object.place = last.position;
    object.speed = has_ended ? 0 : last.velocity_in.length();
    const double spin = has_ended ? 0 : last.angular_velocity_in.length();
    const Fate end_state = object.speed > kStill ? Fate::moves
                           : spin > kStill       ? Fate::spins
                                                 : Fate::rests;
    const double rest_time = std::max(
        timeline.start_time, stopped_at(track, end_state == Fate::spins ? has_stopped : stands));
    object.fate = end_state;
    object.fate_time = rest_time;
    for (const Event& event : timeline.events) {
        if (event.a != object.name && event.b != object.name) {
            continue;
        }
        if (event.surface() == sim::Surface::cushion) {
            ++object.cushions;
        } else if (event.a == object.name && event.kind == EventKind::potted) {
            object.fate = Fate::potted;
            object.fate_time = event.time;
            object.pocket = event.b;
        } else if (event.a == object.name && event.kind == EventKind::off_table) {
            object.fate = Fate::off_table;
            object.fate_time = event.time;
        } else if (event.a == object.name && event.kind == EventKind::removed) {
            object.fate = Fate::removed;
            object.fate_time = event.time;
        } else if (event.a == object.name && event.kind == EventKind::placed) {
            object.fate = end_state;
            object.fate_time = std::max(event.time, rest_time);
            object.pocket.clear();
        } else if (event.a == object.name &&
                   ((event.kind == EventKind::resting && object.fate == Fate::rests) ||
                    (event.kind == EventKind::spinning && object.fate == Fate::spins))) {
            object.fate_time = event.time;
        }
    }
}

bool is_force_event(EventKind kind) {
    return kind == EventKind::force || kind == EventKind::torque || kind == EventKind::impulse ||
           kind == EventKind::velocity || kind == EventKind::strike || kind == EventKind::placed ||
           kind == EventKind::removed;
}

/// The last sample that is not later than `time`, or the first one.
const sim::EnergySample& sample_at(const Timeline& timeline, double time) {
    const auto& energy = timeline.energy;
    const auto after =
        std::upper_bound(energy.begin(), energy.end(), time + kSameTime,
                         [](double t, const sim::EnergySample& sample) { return t < sample.time; });
    return after == energy.begin() ? energy.front() : *(after - 1);
}

/// A step of 1, 2 or 5 times a power of ten that fits at most ten times into `duration`.
double round_step(double duration) {
    const double least = std::max(duration / 10, 1e-3);
    const double decade = std::pow(10, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= least * (1 - kSameTime)) {
            return step * decade;
        }
    }
    return 10 * decade;
}

/// "after the strike on cue"
std::string moment_after(const Event& event) {
    if (event.kind == EventKind::placed) {
        return "after " + event.a + " was put down";
    }
    if (event.kind == EventKind::removed) {
        return "after " + event.a + " was taken off";
    }
    return "after the " + std::string(to_string(event.kind)) + " on " + event.a;
}

std::vector<ReportedEnergy> energies_of(const Timeline& timeline) {
    std::vector<ReportedEnergy> marks;
    if (timeline.energy.empty()) {
        return marks;
    }
    const double step = round_step(timeline.end_time - timeline.start_time);
    for (int i = 1; timeline.start_time + i * step < timeline.end_time - kSameTime; ++i) {
        sim::EnergySample sample = sample_at(timeline, timeline.start_time + i * step);
        sample.time = timeline.start_time + i * step;  // energy is constant until the next sample
        marks.push_back({"", sample});
    }
    for (const Event& event : timeline.events) {
        if (is_force_event(event.kind)) {
            marks.push_back(
                {moment_after(event), sample_at(timeline, std::max(event.time, event.end_time))});
        }
    }
    std::stable_sort(marks.begin(), marks.end(), [](const auto& one, const auto& other) {
        return one.sample.time < other.sample.time;
    });
    marks.insert(marks.begin(), {"start", timeline.energy.front()});
    marks.push_back({"end", timeline.energy.back()});
    return marks;
}

}  // namespace

ReportedObject report_of(const Timeline& timeline, const Track& track) {
    ReportedObject object;
    object.name = track.name();
    measure_motion(track, object);
    find_fate(timeline, track, object);
    return object;
}

ShotReport report_of(const Timeline& timeline) {
    ShotReport report;
    report.start_time = timeline.start_time;
    report.end_time = timeline.end_time;
    for (const Event& event : timeline.events) {
        report.events.push_back(reported(timeline, event));
    }
    for (const Track& track : timeline.tracks) {
        report.objects.push_back(report_of(timeline, track));
    }
    report.all_events = report.events.size();
    report.all_objects = report.objects.size();
    report.energy = energies_of(timeline);
    report.energy_samples = timeline.energy;
    report.largest_energy_rise = sim::largest_energy_rise(timeline);
    return report;
}

}  // namespace carom::pipeline
