#include "pipeline/sound/scene_clock.h"

#include <algorithm>
#include <optional>

#include "pipeline/camera/time_map.h"

namespace carom::pipeline {
namespace {

/// The part of a change of speed that has happened at the fraction x of its duration ...
double changed(double x, bool is_smooth) {
    return is_smooth ? x * x * (3 - 2 * x) : x;
}

/// ... and its integral from 0 to x.
double integral(double x, bool is_smooth) {
    return is_smooth ? x * x * x * (1 - 0.5 * x) : 0.5 * x * x;
}

/// The video time at which the speed of a change is 0, if it passes through 0.
std::optional<double> turning_point(const SceneClock::Change& change) {
    const double last = change.speed + change.change;
    if (!(change.speed * last < 0)) {
        return std::nullopt;
    }
    double low = 0;
    double high = 1;
    const double wanted = -change.speed / change.change;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (changed(middle, change.is_smooth) < wanted ? low : high) = middle;
    }
    return change.start + change.length * 0.5 * (low + high);
}

double scene_of(const CameraRig& rig, const Rational& video_time) {
    return scene_time_at(rig, WideRational(video_time)).to_double();
}

/// A map with a constant speed, from a video time on.
SceneClock::Change constant(const CameraRig& rig, const Rational& start) {
    return {start.to_double(),
            1,
            scene_of(rig, start),
            speed_at(rig, WideRational(start)).to_double(),
            0,
            false};
}

}  // namespace

double SceneClock::scene_time(double video_time) const {
    const double x = (video_time - change_.start) / change_.length;
    return change_.scene +
           change_.length * (change_.speed * x + change_.change * integral(x, change_.is_smooth));
}

double SceneClock::speed(double video_time) const {
    const double x = std::clamp((video_time - change_.start) / change_.length, 0.0, 1.0);
    return change_.speed + change_.change * changed(x, change_.is_smooth);
}

std::vector<SceneClock> scene_clocks(const CameraRig& rig) {
    std::vector<SceneClock> clocks;
    const double start = rig.video_start.to_double();
    const double end = rig.video_end.to_double();
    const auto add = [&](double from, double to, const SceneClock::Change& change) {
        const double first = std::max(from, start);
        const double last = std::min(to, end);
        if (first < last) {
            clocks.emplace_back(first, last, change);
        }
    };
    const std::vector<SpeedKey>& keys = rig.time_map.speeds;
    if (keys.empty()) {
        add(start, end, constant(rig, rig.video_start));
        return clocks;
    }
    add(start, keys.front().video_time.to_double(), constant(rig, rig.video_start));
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const double from = keys[i].video_time.to_double();
        const double to = keys[i + 1].video_time.to_double();
        const double speed = keys[i].speed.to_double();
        const SceneClock::Change change{from,
                                        to - from,
                                        scene_of(rig, keys[i].video_time),
                                        speed,
                                        keys[i + 1].speed.to_double() - speed,
                                        rig.time_map.is_smooth};
        const std::optional<double> turn = turning_point(change);
        add(from, turn.value_or(to), change);
        if (turn) {
            add(*turn, to, change);
        }
    }
    const double last = keys.back().video_time.to_double();
    const SceneClock::Change after{
        last, 1, scene_of(rig, keys.back().video_time), keys.back().speed.to_double(), 0, false};
    add(last, end, after);
    return clocks;
}

}  // namespace carom::pipeline
