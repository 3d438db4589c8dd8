#include "pipeline/camera/retime.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "pipeline/camera/time_map.h"

namespace carom::pipeline {
namespace {

std::string seconds(const Rational& time) {
    return seconds_text(time.to_double());
}

Rational length_of(const CameraRig& rig) {
    return rig.video_end - rig.video_start;
}

Rational magnitude(const Rational& value) {
    return value < Rational(0) ? Rational(0) - value : value;
}

// The first film time at which a ramp shows `scene_time`, by steps and then by halving.
Rational ramp_video_time(const CameraRig& rig, const Rational& scene_time) {
    constexpr int kSteps = 4096;
    const double wanted = scene_time.to_double();
    const Rational step = length_of(rig) / Rational(kSteps);
    const auto ahead = [&](const Rational& time) {
        return scene_time_at(rig, time).to_double() - wanted;
    };
    Rational low = rig.video_start;
    for (int i = 1; i <= kSteps; ++i) {
        Rational high = rig.video_start + step * Rational(i);
        const double before = ahead(low);
        if (before == 0) {
            return low;
        }
        if (before * ahead(high) <= 0) {
            for (int halving = 0; halving < 40; ++halving) {
                const Rational middle = Rational::nearest((low.to_double() + high.to_double()) / 2);
                (before * ahead(middle) <= 0 ? high : low) = middle;
            }
            return high;
        }
        low = high;
    }
    return rig.video_end;
}

/// The share of its way on which a rig shows a scene time.
Rational way_at(const CameraRig& rig, const Rational& scene_time) {
    const TimeMap& map = rig.time_map;
    const Rational fraction =
        map.speeds.empty() ? (scene_time - map.scene_start) / (map.scene_end - map.scene_start)
                           : (ramp_video_time(rig, scene_time) - rig.video_start) / length_of(rig);
    return rig.way_start + (rig.way_end - rig.way_start) * fraction;
}

Rational clamped(const Rational& value, const SceneTimeRange& range) {
    return value < range.first ? range.first : range.last < value ? range.last : value;
}

/// The part of `rig` that shows [first, last], forwards at `speed`, starting at video time 0.
CameraRig part_of(const CameraRig& rig, const Rational& first, const Rational& last,
                  const Rational& speed) {
    CameraRig part = rig;
    part.way_start = way_at(rig, first);
    part.way_end = way_at(rig, last);
    part.time_map = {first, last};
    part.video_start = 0;
    part.video_end = (last - first) / speed;
    part.fade = 0;
    return part;
}

Rational mean_speed(const CameraRig& rig) {
    return (narrow_scene_time(rig, rig.video_end) - narrow_scene_time(rig, rig.video_start)) /
           length_of(rig);
}

/// A whole rig at its own or another speed, starting at video time 0.
CameraRig whole(const CameraRig& rig, const std::optional<Rational>& speed) {
    CameraRig result = rig;
    result.video_start = 0;
    result.video_end = length_of(rig);
    const Rational first = narrow_scene_time(rig, rig.video_start);
    const Rational last = narrow_scene_time(rig, rig.video_end);
    if (speed && first != last) {
        result.time_map = {first, last};
        result.video_end = magnitude(last - first) / *speed;
    } else {
        for (SpeedKey& key : result.time_map.speeds) {
            key.video_time = key.video_time - rig.video_start;
        }
    }
    return result;
}

/// Backwards, starting at video time 0 like the rig itself.
CameraRig backwards(const CameraRig& rig) {
    CameraRig result = rig;
    std::swap(result.way_start, result.way_end);
    result.time_map.scene_start = narrow_scene_time(rig, rig.video_end);
    result.time_map.scene_end = rig.time_map.scene_start;
    std::reverse(result.time_map.speeds.begin(), result.time_map.speeds.end());
    for (SpeedKey& key : result.time_map.speeds) {
        key.video_time = rig.video_end - key.video_time;
        key.speed = Rational(0) - key.speed;
    }
    return result;
}

void move_by(CameraRig& rig, const Rational& offset) {
    rig.video_start = rig.video_start + offset;
    rig.video_end = rig.video_end + offset;
    for (SpeedKey& key : rig.time_map.speeds) {
        key.video_time = key.video_time + offset;
    }
}

/// Puts rigs that all start at 0 one after the other, overlapping by their fades.
void lay_out(std::vector<CameraRig>& rigs) {
    Rational end = 0;
    for (CameraRig& rig : rigs) {
        move_by(rig, end - rig.fade);
        end = rig.video_end;
    }
}

/// The film's rigs in order, or the one that is asked for.
std::vector<CameraRig> chosen(std::span<const CameraRig> rigs, const std::string& name) {
    std::vector<CameraRig> result;
    std::string names;
    for (const CameraRig& rig : rigs) {
        names += (names.empty() ? "'" : ", '") + rig.name + "'";
        if (name.empty() || rig.name == name) {
            result.push_back(rig);
        }
    }
    if (result.empty()) {
        throw Error(rigs.empty() ? "no camera films the shot"
                                 : "there is no camera '" + name + "'; there are " + names);
    }
    std::stable_sort(result.begin(), result.end(), [](const CameraRig& a, const CameraRig& b) {
        return a.video_start < b.video_start;
    });
    if (!name.empty()) {
        result.front().fade = 0;
    }
    return result;
}

[[noreturn]] void throw_not_shown(const std::vector<CameraRig>& rigs, const Rational& time) {
    std::string list;
    for (const CameraRig& rig : rigs) {
        const SceneTimeRange shown = shown_scene_times(rig);
        list += (list.empty() ? "" : ", ") + ("'" + rig.name + "' ") + seconds(shown.first) +
                (shown.is_frozen() ? "" : " to " + seconds(shown.last));
    }
    throw Error("no camera shows scene time " + seconds(time) + " (" + list + ")");
}

/// The first rig in which time passes on from `time`.
const CameraRig& rig_showing(const std::vector<CameraRig>& rigs, const Rational& time) {
    for (const CameraRig& rig : rigs) {
        const SceneTimeRange shown = shown_scene_times(rig);
        if (shown.first <= time && time < shown.last) {
            return rig;
        }
    }
    throw_not_shown(rigs, time);
}

std::vector<CameraRig> parts(const std::vector<CameraRig>& rigs, const RetimeOptions& options) {
    SceneTimeRange all = shown_scene_times(rigs.front());
    for (const CameraRig& rig : rigs) {
        const SceneTimeRange shown = shown_scene_times(rig);
        all.first = shown.first < all.first ? shown.first : all.first;
        all.last = all.last < shown.last ? shown.last : all.last;
    }
    const Rational last = options.to.value_or(all.last);
    Rational time = options.from.value_or(all.first);
    if (last <= time) {
        throw Error("the stretch of scene time from " + seconds(time) + " to " + seconds(last) +
                    " does not go forward; --reverse shows one backwards");
    }
    std::vector<CameraRig> result;
    while (time < last) {
        const CameraRig& rig = rig_showing(rigs, time);
        const Rational end = shown_scene_times(rig).last;
        const Rational until = end < last ? end : last;
        result.push_back(
            part_of(rig, time, until, options.speed.value_or(magnitude(mean_speed(rig)))));
        time = until;
    }
    return result;
}

std::vector<CameraRig> all_of(const std::vector<CameraRig>& rigs, const RetimeOptions& options) {
    std::vector<CameraRig> result;
    std::vector<Rational> stretching;  // of each rig's length
    for (const CameraRig& rig : rigs) {
        result.push_back(whole(rig, options.speed));
        stretching.push_back(length_of(result.back()) / length_of(rig));
        if (result.size() > 1) {  // by the smaller, so that the fade fits into both
            const Rational& before = stretching[stretching.size() - 2];
            result.back().fade =
                rig.fade * (before < stretching.back() ? before : stretching.back());
        }
    }
    return result;
}

CameraRig ramped(const std::vector<CameraRig>& rigs, const RetimeOptions& options) {
    const Rational start = options.from.value_or(shown_scene_times(rigs.front()).first);
    const CameraRig& rig = rig_showing(rigs, start);
    CameraRig result = rig;
    result.video_start = 0;
    result.video_end = options.ramp.back().video_time;
    result.fade = 0;
    result.time_map = {start, start, options.ramp, options.gentle};
    const Rational end = narrow_scene_time(result, result.video_end);
    result.way_start = way_at(rig, start);
    result.way_end = way_at(rig, clamped(end, shown_scene_times(rig)));
    return result;
}

void check(const RetimeOptions& options) {
    if (options.speed && options.speed <= Rational(0)) {
        throw Error("the speed must be above 0; --reverse shows the film backwards");
    }
    if (options.ramp.empty()) {
        return;
    }
    if (options.speed || options.to) {
        throw Error(std::string("--ramp says itself ") +
                    (options.speed ? "how fast time passes" : "where the film ends") + "; leave " +
                    (options.speed ? "--speed" : "--to") + " out");
    }
    for (std::size_t i = 1; i < options.ramp.size(); ++i) {
        if (options.ramp[i].video_time <= options.ramp[i - 1].video_time) {
            throw Error("the times of --ramp must ascend");
        }
    }
    if (options.ramp.back().video_time <= Rational(0)) {
        throw Error("the last time of --ramp is the film's length and must be above 0 s");
    }
}

}  // namespace

std::vector<CameraRig> retimed(std::span<const CameraRig> rigs, const RetimeOptions& options) {
    check(options);
    const std::vector<CameraRig> pool = chosen(rigs, options.rig);
    std::vector<CameraRig> film;
    if (!options.ramp.empty()) {
        film = {ramped(pool, options)};
    } else {
        film = options.from || options.to ? parts(pool, options) : all_of(pool, options);
    }
    if (options.reverse) {
        // What a rig faded in over is now where the one before it is taken over.
        for (std::size_t i = 0; i < film.size(); ++i) {
            film[i] = backwards(film[i]);
            film[i].fade = i + 1 < film.size() ? film[i + 1].fade : Rational(0);
        }
        std::reverse(film.begin(), film.end());
    }
    lay_out(film);
    return film;
}

}  // namespace carom::pipeline
