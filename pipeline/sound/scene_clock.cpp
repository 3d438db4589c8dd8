#include "pipeline/sound/scene_clock.h"

#include <algorithm>
#include <optional>
#include <utility>

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

namespace {

/// Collects the stretches between `start` and `end` of the rig.
class Stretches {
  public:
    Stretches(const CameraRig& rig, const SceneClock::End& start, const SceneClock::End& end)
        : rig_(rig), start_(start), end_(end) {}

    /// A change of speed that begins and ends at these times.
    void add(const Rational& from, const Rational& to, const SceneClock::Change& change) {
        const SceneClock::End first = end_at(rig_, from);
        const SceneClock::End last = end_at(rig_, to);
        if (const std::optional<double> turn = turning_point(change)) {
            const SceneClock::End middle{*turn, SceneClock(first, last, change).scene_time(*turn)};
            add(first, middle, change);
            add(middle, last, change);
        } else {
            add(first, last, change);
        }
    }

    static SceneClock::End end_at(const CameraRig& rig, const Rational& time) {
        return {time.to_double(), scene_of(rig, time)};
    }

    std::vector<SceneClock> clocks;

  private:
    void add(SceneClock::End from, SceneClock::End to, const SceneClock::Change& change) {
        from = from.video_time < start_.video_time ? start_ : from;
        to = end_.video_time < to.video_time ? end_ : to;
        if (from.video_time < to.video_time) {
            clocks.emplace_back(from, to, change);
        }
    }

    const CameraRig& rig_;
    SceneClock::End start_;
    SceneClock::End end_;
};

}  // namespace

std::vector<SceneClock> scene_clocks(const CameraRig& rig) {
    Stretches stretches(rig, Stretches::end_at(rig, rig.video_start),
                        Stretches::end_at(rig, rig.video_end));
    const std::vector<SpeedKey>& keys = rig.time_map.speeds;
    const Rational first = keys.empty() ? rig.video_end : keys.front().video_time;
    stretches.add(rig.video_start, first, constant(rig, rig.video_start));
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const double from = keys[i].video_time.to_double();
        const double speed = keys[i].speed.to_double();
        stretches.add(
            keys[i].video_time, keys[i + 1].video_time,
            {from, keys[i + 1].video_time.to_double() - from, scene_of(rig, keys[i].video_time),
             speed, keys[i + 1].speed.to_double() - speed, rig.time_map.is_smooth});
    }
    if (!keys.empty()) {
        stretches.add(keys.back().video_time, rig.video_end, constant(rig, keys.back().video_time));
    }
    return std::move(stretches.clocks);
}

}  // namespace carom::pipeline
