#include "pipeline/studio/fan_message.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <utility>

namespace carom::studio {

namespace {

constexpr double kTolerance = 1e-3;         // of the paths, m
constexpr double kSampleStep = 0.02;        // s, between points of a path before thinning
constexpr std::size_t kMostPoints = 2'000;  // of one path

double distance_to(const Vec3& point, const Vec3& a, const Vec3& b) {
    const Vec3 line = b - a;
    const double square = line.dot(line);
    const double along = square > 0 ? std::clamp((point - a).dot(line) / square, 0.0, 1.0) : 0;
    return (point - (a + line * along)).length();
}

struct Point {
    double time = 0;
    Vec3 place{0, 0, 0};
};

/// Marks the points that a polyline needs to stay near all of them (Douglas and Peucker 1973).
void mark_needed(std::span<const Point> points, std::vector<bool>& needed) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t farthest = first;
        double distance = kTolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d = distance_to(points[i].place, points[first].place, points[last].place);
            if (d > distance) {
                distance = d;
                farthest = i;
            }
        }
        if (farthest != first) {
            needed[farthest] = true;
            open.emplace_back(first, farthest);
            open.emplace_back(farthest, last);
        }
    }
}

/// The path of an object from a time on until it is put elsewhere; empty if it does not move.
std::vector<Point> path_of(const sim::Track& track, double from) {
    std::size_t first = 0;
    std::size_t end = 1;
    for (; end < track.keys().size(); ++end) {
        if (track.jumps_after(end - 1)) {
            if (track.keys()[end].time > from) {
                break;
            }
            first = end;
        }
    }
    const std::span<const sim::Key> keys = track.keys().subspan(first, end - first);
    const double start = std::clamp(from, keys.front().time, keys.back().time);
    const sim::Bounds bounds = track.position_bounds(start, keys.back().time);
    if ((bounds.high - bounds.low).length() < kTolerance) {
        return {};
    }
    std::vector<Point> points{{start, track.sample(start).position}};
    const double step = std::max(kSampleStep, (keys.back().time - start) / kMostPoints);
    for (const sim::Key& key : keys) {
        if (key.time <= start) {
            continue;
        }
        double time = points.back().time + step;
        while (time < key.time) {
            points.push_back({time, track.sample(time).position});
            time += step;
        }
        points.push_back({key.time, key.position});
    }
    std::vector<bool> needed(points.size(), false);
    needed.front() = needed.back() = true;
    mark_needed(points, needed);
    std::vector<Point> path;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (needed[i]) {
            path.push_back(points[i]);
        }
    }
    return path;
}

/// Whether the event is an outcome for people. Those of surfaces and of phases of motion are not.
bool is_outcome(const sim::Event& event) {
    const bool is_ground =
        sim::is_level(event.surface()) || event.surface() == sim::Surface::pocket;
    return event.kind == sim::EventKind::potted || event.kind == sim::EventKind::off_table ||
           (event.kind == sim::EventKind::impact && !is_ground);
}

using OutcomeKey = std::tuple<sim::EventKind, std::string, std::string>;

OutcomeKey key_of(const sim::Event& event) {
    // A ball that is potted is potted, whichever pocket takes it. The order of names in an impact
    // does not matter.
    if (event.kind != sim::EventKind::impact) {
        return {event.kind, event.a, ""};
    }
    return {event.kind, std::min(event.a, event.b), std::max(event.a, event.b)};
}

struct Outcome {
    FanOutcome message;
    int last_run = -1;
};

void count(const sim::Event& event, int run, std::map<OutcomeKey, Outcome>& outcomes) {
    const auto [found, is_new] = outcomes.try_emplace(key_of(event));
    Outcome& outcome = found->second;
    FanOutcome& message = outcome.message;
    if (is_new) {
        message = {std::string(to_string(event.kind)),
                   event.a,
                   event.b,
                   phrase_of(event),
                   0,
                   event.time,
                   event.time};
    } else if (event.kind == sim::EventKind::potted && message.b != event.b) {
        message.b.clear();
        message.text = event.a + " is potted";
    }
    if (outcome.last_run != run) {  // only the first time in each run
        outcome.last_run = run;
        ++message.runs;
        message.first = std::min(message.first, event.time);
        message.last = std::max(message.last, event.time);
    }
}

}  // namespace

void add_paths(const sim::Timeline& timeline, double from, int run, std::vector<FanTrack>& tracks,
               std::vector<double>& numbers) {
    for (const sim::Track& track : timeline.tracks) {
        const std::vector<Point> path = path_of(track, from);
        if (path.empty()) {
            continue;
        }
        tracks.push_back({track.name(), run, static_cast<std::int64_t>(numbers.size()),
                          static_cast<std::int64_t>(path.size())});
        for (const Point& point : path) {
            numbers.insert(numbers.end(),
                           {point.time, point.place.x, point.place.y, point.place.z});
        }
    }
}

Numbers<FanHead> fan_message(const std::vector<sim::Timeline>& runs) {
    Numbers<FanHead> message;
    std::map<OutcomeKey, Outcome> outcomes;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        add_paths(runs[run], runs[run].start_time, static_cast<int>(run), message.head.tracks,
                  message.numbers);
        for (const sim::Event& event : runs[run].events) {
            if (is_outcome(event)) {
                count(event, static_cast<int>(run), outcomes);
            }
        }
    }
    for (auto& [key, outcome] : outcomes) {
        message.head.outcomes.push_back(std::move(outcome.message));
    }
    std::ranges::stable_sort(message.head.outcomes, {}, &FanOutcome::first);
    message.head.finished = static_cast<int>(runs.size());
    return message;
}

}  // namespace carom::studio
