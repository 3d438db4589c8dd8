#include "pipeline/camera/time_map.h"

#include <algorithm>

#include "core/error.h"

namespace carom::pipeline {
namespace {

double to_double(const WideRational& value) {
    return value.to_double();
}
double to_double(double value) {
    return value;
}

template <class Number>
Number number(const Rational& value);
template <>
WideRational number(const Rational& value) {
    return value;
}
template <>
double number(const Rational& value) {
    return value.to_double();
}

template <class Number>
Number whole(std::int64_t value) {
    return number<Number>(Rational(value));
}

// The fraction of a change of speed that has happened at the fraction x of its duration, ...
template <class Number>
Number change_fraction(const Number& x, bool is_smooth) {
    return is_smooth ? x * x * (whole<Number>(3) - whole<Number>(2) * x) : x;
}

// ... and its integral from 0 to x, which is 1/2 at x = 1.
template <class Number>
Number integrated_fraction(const Number& x, bool is_smooth) {
    const Number half = number<Number>(Rational(1, 2));
    return is_smooth ? x * x * x * (whole<Number>(1) - half * x) : half * x * x;
}

// Seconds of scene time from the first key to `time`.
template <class Number>
Number elapsed(const TimeMap& map, const Number& time) {
    const auto at = [&](std::size_t i) { return number<Number>(map.speeds[i].video_time); };
    const auto speed = [&](std::size_t i) { return number<Number>(map.speeds[i].speed); };
    Number sum = whole<Number>(0);
    if (to_double(time - at(0)) <= 0) {
        return speed(0) * (time - at(0));
    }
    for (std::size_t i = 0; i + 1 < map.speeds.size(); ++i) {
        const Number length = at(i + 1) - at(i);
        const Number change = speed(i + 1) - speed(i);
        if (to_double(time - at(i + 1)) < 0) {
            const Number x = (time - at(i)) / length;
            return sum + length * (speed(i) * x + change * integrated_fraction(x, map.is_smooth));
        }
        sum = sum + length * (speed(i) + number<Number>(Rational(1, 2)) * change);
    }
    const std::size_t last = map.speeds.size() - 1;
    return sum + speed(last) * (time - at(last));
}

WideRational linear_speed(const CameraRig& rig) {
    return (WideRational(rig.time_map.scene_end) - WideRational(rig.time_map.scene_start)) /
           (WideRational(rig.video_end) - WideRational(rig.video_start));
}

WideRational ramp_speed(const TimeMap& map, const WideRational& time) {
    const auto& keys = map.speeds;
    const auto next = std::find_if(keys.begin(), keys.end(), [&](const SpeedKey& key) {
        return (WideRational(key.video_time) - time).sign() > 0;
    });
    if (next == keys.begin()) {
        return keys.front().speed;
    }
    const SpeedKey& before = *(next - 1);
    if (next == keys.end()) {
        return before.speed;
    }
    const WideRational x = (time - WideRational(before.video_time)) /
                           (WideRational(next->video_time) - WideRational(before.video_time));
    return WideRational(before.speed) + (WideRational(next->speed) - WideRational(before.speed)) *
                                            change_fraction(x, map.is_smooth);
}

}  // namespace

WideRational scene_time_at(const CameraRig& rig, const WideRational& video_time) {
    const TimeMap& map = rig.time_map;
    if (map.speeds.empty()) {
        return WideRational(map.scene_start) +
               (video_time - WideRational(rig.video_start)) * linear_speed(rig);
    }
    try {
        return WideRational(map.scene_start) + elapsed(map, video_time) -
               elapsed(map, WideRational(rig.video_start));
    } catch (const Error&) {  // the exact fraction has too many digits
        return Rational::nearest(map.scene_start.to_double() +
                                 elapsed(map, video_time.to_double()) -
                                 elapsed(map, rig.video_start.to_double()));
    }
}

WideRational speed_at(const CameraRig& rig, const WideRational& video_time) {
    if (rig.time_map.speeds.empty()) {
        return linear_speed(rig);
    }
    try {
        return ramp_speed(rig.time_map, video_time);
    } catch (const Error&) {
        // A central difference is accurate enough.
        constexpr double kStep = 1e-6;
        const double time = video_time.to_double();
        return Rational::nearest(
            (elapsed(rig.time_map, time + kStep) - elapsed(rig.time_map, time - kStep)) /
            (2 * kStep));
    }
}

Rational narrow_scene_time(const CameraRig& rig, const Rational& video_time) {
    const WideRational time = scene_time_at(rig, video_time);
    try {
        return time.narrow();
    } catch (const Error&) {
        return Rational::nearest(time.to_double());
    }
}

SceneTimeRange shown_scene_times(const CameraRig& rig) {
    const Rational start = narrow_scene_time(rig, rig.video_start);
    SceneTimeRange shown{start, start};
    const auto include = [&](const Rational& video_time) {
        const Rational time = narrow_scene_time(rig, video_time);
        shown.first = time < shown.first ? time : shown.first;
        shown.last = shown.last < time ? time : shown.last;
    };
    include(rig.video_end);
    for (const SpeedKey& key : rig.time_map.speeds) {
        if (rig.video_start < key.video_time && key.video_time < rig.video_end) {
            include(key.video_time);
        }
    }
    return shown;
}

}  // namespace carom::pipeline
