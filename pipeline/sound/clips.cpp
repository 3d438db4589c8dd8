#include "pipeline/sound/clips.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/elementary.h"
#include "pipeline/camera/progress.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/view_axes.h"
#include "pipeline/sound/scene_clock.h"

namespace carom::pipeline {
namespace {

sound::ClipSettings settings_of(const CameraSound& film, const CameraSound& camera) {
    const auto value = [&](auto member, auto standard) {
        return (camera.*member).value_or((film.*member).value_or(standard));
    };
    const sound::ClipSettings standard;
    sound::ClipSettings settings;
    settings.gain = film.gain.value_or(0) + camera.gain.value_or(0);
    settings.pitch = value(&CameraSound::pitch, standard.pitch);
    settings.lowest = value(&CameraSound::lowest, standard.lowest);
    settings.mirrors_reverse = value(&CameraSound::mirrors_reverse, standard.mirrors_reverse);
    settings.has_delay = value(&CameraSound::has_delay, standard.has_delay);
    settings.stereo = value(&CameraSound::stereo, standard.stereo);
    settings.width = value(&CameraSound::width, standard.width);
    settings.ratio = value(&CameraSound::ratio, standard.ratio);
    for (std::size_t i = 0; i < settings.mix.size(); ++i) {
        settings.mix[i] = camera.mix[i].value_or(film.mix[i].value_or(0));
    }
    return settings;
}

sound::Listener fixed_listener(const ListenerPlace& place, double half_width) {
    const Vec3 ahead = place.facing.normalized();
    const Vec3 right = ahead.cross(Vec3(0, 0, 1)).normalized();
    return {place.at, right, ahead, right.cross(ahead), half_width};
}

/// Of the camera's picture, rad.
double half_width(const render::CameraState& camera, double aspect) {
    return arctangent2(tangent(0.5 * camera.vertical_fov) * aspect, 1);
}

/// The scene time at times of the film. At the ends of a stretch it is the same as in the stretches
/// beside it, to the last bit: an impact there belongs to one of them.
struct SceneTime {
    SceneClock clock;
    double offset;  // from the film's time to the rig's video time

    double operator()(double film_time) const {
        for (const SceneClock::End& end : {clock.from(), clock.to()}) {
            if (film_time == end.video_time - offset) {
                return end.scene_time;
            }
        }
        return clock.scene_time(film_time + offset);
    }
};

/// As progress_at (camera/exposure.h), but rounded: exact fractions took a fifth of the time of a
/// film's sound.
Progress progress_near(const CameraRig& rig, double video_time) {
    const double start = rig.video_start.to_double();
    const double from = rig.path_start.to_double();
    const double done = from + (rig.path_end.to_double() - from) * (video_time - start) /
                                   (rig.video_end.to_double() - start);
    return {done, 1 - done};
}

/// What a clip's functions need. It is copied into them.
struct Camera {
    const CameraRig& rig;
    const sim::Timeline& timeline;
    SceneClock clock;
    double offset;  // from the film's time to the rig's video time
    double aspect;
    std::optional<ListenerPlace> place;

    [[nodiscard]] sound::Listener listener(double film_time) const {
        const double video_time =
            std::clamp(film_time + offset, rig.video_start.to_double(), rig.video_end.to_double());
        const RigInstant instant{progress_near(rig, video_time), clock.scene_time(video_time)};
        const render::CameraState camera = camera_state(rig, instant, timeline);
        const double width = half_width(camera, aspect);
        if (place) {
            return fixed_listener(*place, width);
        }
        const ViewAxes axes = view_axes(camera);
        return {camera.position, axes.right, axes.ahead, axes.up, width};
    }
};

/// A rise from 0 to 1 between two times by equal power: its square and that of the fall that
/// begins and ends with it add up to 1. Without an interval it is 1.
struct Rise {
    double from = 0;
    double to = 0;

    [[nodiscard]] double at(double time) const { return from < to ? sine(angle_at(time)) : 1; }
    [[nodiscard]] double fall_at(double time) const {
        return from < to ? cosine(angle_at(time)) : 1;
    }

  private:
    [[nodiscard]] double angle_at(double time) const {
        return 0.5 * std::numbers::pi * std::clamp((time - from) / (to - from), 0.0, 1.0);
    }
};

/// The fade of the camera that takes over from the rig; empty if none does by fading.
Rise fade_after(std::span<const CameraRig> rigs, const CameraRig& rig) {
    const Rational none;
    for (const CameraRig& next : rigs) {
        const bool takes_over = rig.video_start < next.video_start && none < next.fade &&
                                next.video_start < rig.video_end;
        if (takes_over) {
            return {next.video_start.to_double(), (next.video_start + next.fade).to_double()};
        }
    }
    return {};
}

}  // namespace

std::vector<sound::Clip> clips_of(std::span<const CameraRig> rigs, const sim::Timeline& timeline,
                                  const SoundSettings& settings, double aspect,
                                  const ShownPart& part) {
    std::vector<sound::Clip> clips;
    const double offset = part.from - part.start;
    const double end = part.start + (part.to - part.from);
    const Rise part_in{part.start, part.start + part.fade_in};
    const Rise part_out{end - part.fade_out, end};
    for (const CameraRig& rig : rigs) {
        const double start = rig.video_start.to_double();
        const Rise fade_in{start, (rig.video_start + rig.fade).to_double()};
        const Rise fade_out = fade_after(rigs, rig);
        const auto& own_place = rig.sound.listener;
        const auto& place = own_place ? own_place : settings.cameras.listener;
        for (const SceneClock& clock : scene_clocks(rig)) {
            const double from = std::max({clock.from().video_time, part.from, offset});
            const double to = std::min({clock.to().video_time, part.to, part.film_end + offset});
            if (!(from < to)) {
                continue;
            }
            const Camera camera{rig,    timeline,
                                clock,  offset,
                                aspect, place && !place->is_camera ? place : std::nullopt};
            sound::Clip clip;
            clip.from = from - offset;
            clip.to = to - offset;
            clip.camera = rig.name;
            clip.scene_time = SceneTime{clock, offset};
            clip.speed = [clock, offset](double t) { return clock.speed(t + offset); };
            clip.listener = [camera](double t) { return camera.listener(t); };
            clip.weight = [=](double t) {
                return fade_in.at(t + offset) * fade_out.fall_at(t + offset) * part_in.at(t) *
                       part_out.fall_at(t);
            };
            clip.settings = settings_of(settings.cameras, rig.sound);
            clips.push_back(std::move(clip));
        }
    }
    std::ranges::stable_sort(clips, {}, &sound::Clip::from);
    return clips;
}

}  // namespace carom::pipeline
