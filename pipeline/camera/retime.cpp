#include "pipeline/camera/retime.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "pipeline/camera/changing_value.h"
#include "pipeline/camera/time_map.h"

namespace carom::pipeline {
namespace {

std::string seconds(const Rational& time) {
    return seconds_text(time.to_double());
}

Rational duration_of(const CameraRig& rig) {
    return rig.video_end - rig.video_start;
}

Rational magnitude(const Rational& value) {
    return value < Rational(0) ? Rational(0) - value : value;
}

// The first film time at which a ramp shows `scene_time`, by a scan in steps and then by bisection.
Rational find_ramp_video_time(const CameraRig& rig, const Rational& scene_time) {
    constexpr int kSteps = 4096;
    const double target = scene_time.to_double();
    const Rational step = duration_of(rig) / Rational(kSteps);
    const auto excess = [&](const Rational& time) {
        return scene_time_at(rig, time).to_double() - target;
    };
    Rational low = rig.video_start;
    for (int i = 1; i <= kSteps; ++i) {
        Rational high = rig.video_start + step * Rational(i);
        const double before = excess(low);
        if (before == 0) {
            return low;
        }
        if (before * excess(high) <= 0) {
            for (int bisection = 0; bisection < 40; ++bisection) {
                const Rational middle = Rational::nearest((low.to_double() + high.to_double()) / 2);
                (before * excess(middle) <= 0 ? high : low) = middle;
            }
            return high;
        }
        low = high;
    }
    return rig.video_end;
}

/// The fraction of its path at which a rig shows a scene time.
Rational path_fraction_at(const CameraRig& rig, const Rational& scene_time) {
    const TimeMap& map = rig.time_map;
    const Rational fraction =
        map.speeds.empty()
            ? (scene_time - map.scene_start) / (map.scene_end - map.scene_start)
            : (find_ramp_video_time(rig, scene_time) - rig.video_start) / duration_of(rig);
    return rig.path_start + (rig.path_end - rig.path_start) * fraction;
}

Rational clamped(const Rational& value, const SceneTimeRange& range) {
    return value < range.first ? range.first : range.last < value ? range.last : value;
}

/// The part of `rig` that shows [first, last], forwards at `speed`, starting at video time 0.
CameraRig part_of(const CameraRig& rig, const Rational& first, const Rational& last,
                  const Rational& speed) {
    CameraRig part = rig;
    part.path_start = path_fraction_at(rig, first);
    part.path_end = path_fraction_at(rig, last);
    part.time_map = {first, last};
    part.video_start = 0;
    part.video_end = (last - first) / speed;
    part.fade = 0;
    return part;
}

Rational mean_speed(const CameraRig& rig) {
    return (narrow_scene_time(rig, rig.video_end) - narrow_scene_time(rig, rig.video_start)) /
           duration_of(rig);
}

/// A whole rig at its own or another speed, starting at video time 0.
CameraRig retime_whole(const CameraRig& rig, const std::optional<Rational>& speed) {
    CameraRig result = rig;
    result.video_start = 0;
    result.video_end = duration_of(rig);
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

/// A rig that starts at video time 0, reversed in time; the result also starts at 0.
CameraRig reverse_rig(const CameraRig& rig) {
    CameraRig result = rig;
    std::swap(result.path_start, result.path_end);
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

/// Arranges rigs that all start at 0 one after the other, overlapping by their fades.
void arrange_in_sequence(std::vector<CameraRig>& rigs) {
    Rational end = 0;
    for (CameraRig& rig : rigs) {
        move_by(rig, end - rig.fade);
        end = rig.video_end;
    }
}

/// The film's rigs in order, or only the one with that name.
std::vector<CameraRig> select_rigs(std::span<const CameraRig> rigs, const std::string& name) {
    std::vector<CameraRig> result;
    std::string names;
    for (const CameraRig& rig : rigs) {
        names += (names.empty() ? "'" : ", '") + rig.name + "'";
        if (name.empty() || rig.name == name) {
            result.push_back(rig);
            result.back().written = written_interval(rig);
        }
    }
    if (result.empty()) {
        throw Error(rigs.empty() ? "no camera films the shot"
                                 : "there is no camera '" + name + "'; the cameras are " + names);
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

/// The first rig that shows an interval of scene time after `time`.
const CameraRig& rig_showing(const std::vector<CameraRig>& rigs, const Rational& time) {
    for (const CameraRig& rig : rigs) {
        const SceneTimeRange shown = shown_scene_times(rig);
        if (shown.first <= time && time < shown.last) {
            return rig;
        }
    }
    throw_not_shown(rigs, time);
}

std::vector<CameraRig> retime_interval(const std::vector<CameraRig>& rigs,
                                       const RetimeOptions& options) {
    SceneTimeRange all = shown_scene_times(rigs.front());
    for (const CameraRig& rig : rigs) {
        const SceneTimeRange shown = shown_scene_times(rig);
        all.first = shown.first < all.first ? shown.first : all.first;
        all.last = all.last < shown.last ? shown.last : all.last;
    }
    const Rational last = options.to.value_or(all.last);
    Rational time = options.from.value_or(all.first);
    if (last <= time) {
        throw Error("the interval of scene time ends at " + seconds(last) +
                    ", which is not after its start at " + seconds(time) +
                    "; to show an interval backwards, use --reverse");
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

std::vector<CameraRig> retime_all(const std::vector<CameraRig>& rigs,
                                  const RetimeOptions& options) {
    std::vector<CameraRig> result;
    std::vector<Rational> factors;  // of each rig's duration
    for (const CameraRig& rig : rigs) {
        result.push_back(retime_whole(rig, options.speed));
        factors.push_back(duration_of(result.back()) / duration_of(rig));
        if (result.size() > 1) {  // by the smaller factor, so that the fade fits into both rigs
            const Rational& before = factors[factors.size() - 2];
            result.back().fade = rig.fade * (before < factors.back() ? before : factors.back());
        }
    }
    return result;
}

CameraRig retime_by_ramp(const std::vector<CameraRig>& rigs, const RetimeOptions& options) {
    const Rational start = options.from.value_or(shown_scene_times(rigs.front()).first);
    const CameraRig& rig = rig_showing(rigs, start);
    CameraRig result = rig;
    result.video_start = 0;
    result.video_end = options.ramp.back().video_time;
    result.fade = 0;
    result.time_map = {start, start, options.ramp, options.is_smooth};
    const Rational end = narrow_scene_time(result, result.video_end);
    result.path_start = path_fraction_at(rig, start);
    result.path_end = path_fraction_at(rig, clamped(end, shown_scene_times(rig)));
    return result;
}

void check_options(const RetimeOptions& options) {
    if (options.speed && options.speed <= Rational(0)) {
        throw Error("the speed must be above 0; to show the film backwards, use --reverse");
    }
    if (options.ramp.empty()) {
        return;
    }
    if (options.speed || options.to) {
        throw Error(std::string("--ramp already sets ") +
                    (options.speed ? "the speed" : "the end of the film") + "; leave out " +
                    (options.speed ? "--speed" : "--to"));
    }
    for (std::size_t i = 1; i < options.ramp.size(); ++i) {
        if (options.ramp[i].video_time <= options.ramp[i - 1].video_time) {
            throw Error("the times of --ramp must be in increasing order");
        }
    }
    if (options.ramp.back().video_time <= Rational(0)) {
        throw Error("the last time of --ramp is the film's length and must be above 0 s");
    }
}

}  // namespace

std::vector<CameraRig> retime_rigs(std::span<const CameraRig> rigs, const RetimeOptions& options) {
    check_options(options);
    const std::vector<CameraRig> pool = select_rigs(rigs, options.rig);
    std::vector<CameraRig> film;
    if (!options.ramp.empty()) {
        film = {retime_by_ramp(pool, options)};
    } else {
        film =
            options.from || options.to ? retime_interval(pool, options) : retime_all(pool, options);
    }
    if (options.reverse) {
        // The fade at the start of a rig becomes the fade of the rig that was before it.
        for (std::size_t i = 0; i < film.size(); ++i) {
            film[i] = reverse_rig(film[i]);
            film[i].fade = i + 1 < film.size() ? film[i + 1].fade : Rational(0);
        }
        std::reverse(film.begin(), film.end());
    }
    arrange_in_sequence(film);
    return film;
}

}  // namespace carom::pipeline
