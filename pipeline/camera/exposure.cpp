#include "pipeline/camera/exposure.h"

namespace carom::pipeline {
namespace {

// Offset of the shutter's opening from the frame's own time, in units of the exposure.
WideRational opening(ShutterPosition position) {
    switch (position) {
        case ShutterPosition::start:
            return {0, 1};
        case ShutterPosition::centre:
            return {-1, 2};
        case ShutterPosition::end:
            return {-1, 1};
    }
    return {0, 1};
}

}  // namespace

WideRational frame_time(std::int64_t number, const FilmTiming& timing) {
    return WideRational(number, 1) / WideRational(timing.fps);
}

Exposure expose(const CameraRig& rig, std::int64_t number, const FilmTiming& timing) {
    const WideRational duration(timing.shutter.exposure);
    const WideRational open = opening(timing.shutter.position) * duration;
    const WideRational close = open + duration;
    Exposure exposure;
    exposure.video_time = frame_time(number, timing);
    exposure.video_open = exposure.video_time + open;
    exposure.video_close = exposure.video_time + close;
    exposure.scene_time = scene_time_at(rig, exposure.video_time);
    if (timing.shutter.clock == ShutterClock::video) {
        exposure.scene_open = scene_time_at(rig, exposure.video_open);
        exposure.scene_close = scene_time_at(rig, exposure.video_close);
    } else {
        const WideRational direction(speed_at(rig, exposure.video_time).sign(), 1);
        exposure.scene_open = exposure.scene_time + direction * open;
        exposure.scene_close = exposure.scene_time + direction * close;
    }
    return exposure;
}

Progress progress_at(const CameraRig& rig, const WideRational& video_time) {
    const WideRational duration = WideRational(rig.video_end) - WideRational(rig.video_start);
    const WideRational fraction = (video_time - WideRational(rig.video_start)) / duration;
    const WideRational start(rig.path_start);
    const WideRational done = start + (WideRational(rig.path_end) - start) * fraction;
    return {done.to_double(), (WideRational(1, 1) - done).to_double()};
}

}  // namespace carom::pipeline
