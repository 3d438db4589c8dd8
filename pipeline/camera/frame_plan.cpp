#include "pipeline/camera/frame_plan.h"

#include <algorithm>
#include <utility>

#include "pipeline/camera/exposure.h"
#include "pipeline/camera/rig_state.h"
#include "sim/timeline/error.h"

namespace carom::pipeline {
namespace {

const CameraRig& rig_at(std::span<const CameraRig> rigs, const WideRational& video_time,
                        std::int64_t number) {
    for (const CameraRig& rig : rigs) {
        if ((video_time - WideRational(rig.video_start)).sign() >= 0 &&
            (WideRational(rig.video_end) - video_time).sign() > 0) {
            return rig;
        }
    }
    throw Error("no camera films frame " + std::to_string(number) + " at " +
                std::to_string(video_time.to_double()) + " s of the film");
}

PlannedFrame plan(std::int64_t number, const CameraRig& rig, const FilmTiming& timing,
                  const sim::Timeline& timeline) {
    const Exposure exposure = expose(rig, number, timing);
    PlannedFrame frame;
    frame.number = number;
    frame.rig = rig.name;
    frame.video_time = exposure.video_time.to_double();
    frame.scene_time = exposure.scene_time.to_double();
    frame.scene_open = exposure.scene_open.to_double();
    frame.scene_close = exposure.scene_close.to_double();
    frame.camera_open =
        camera_state(rig, {progress_at(rig, exposure.video_open), frame.scene_open}, timeline);
    frame.camera_close =
        camera_state(rig, {progress_at(rig, exposure.video_close), frame.scene_close}, timeline);
    if (frame.scene_close < frame.scene_open) {
        std::swap(frame.scene_open, frame.scene_close);
        std::swap(frame.camera_open, frame.camera_close);
        frame.reversed = true;
    }
    return frame;
}

}  // namespace

std::int64_t frame_count(std::span<const CameraRig> rigs, const FilmTiming& timing) {
    std::int64_t count = 0;
    for (const CameraRig& rig : rigs) {
        const WideRational frames = WideRational(rig.video_end) * WideRational(timing.fps);
        count = std::max(count, frames.ceil());
    }
    return count;
}

PlannedFrame plan_frame(std::int64_t number, std::span<const CameraRig> rigs,
                        const FilmTiming& timing, const sim::Timeline& timeline) {
    const WideRational time = frame_time(number, timing);
    const CameraRig& rig = rig_at(rigs, time, number);
    try {
        return plan(number, rig, timing, timeline);
    } catch (const Error& error) {
        throw Error("camera '" + rig.name + "', frame " + std::to_string(number) + ": " +
                    error.what());
    }
}

}  // namespace carom::pipeline
