#include "pipeline/camera/shown_frame.h"

#include <algorithm>
#include <cmath>

#include "pipeline/camera/exposure.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/time_map.h"

namespace carom::pipeline {

namespace {

bool is_active(const CameraRig& rig, const WideRational& time) {
    return (time - WideRational(rig.video_start)).sign() >= 0 &&
           (time - WideRational(rig.video_end)).sign() < 0;
}

}  // namespace

std::optional<std::int64_t> first_frame_showing(double scene_time, std::span<const CameraRig> rigs,
                                                const FilmTiming& timing) {
    const std::int64_t count = frame_count(rigs, timing);
    for (std::int64_t frame = 0; frame < count; ++frame) {
        const WideRational time = frame_time(frame, timing);
        const auto rig =
            std::ranges::find_if(rigs, [&](const CameraRig& one) { return is_active(one, time); });
        if (rig == rigs.end()) {
            continue;
        }
        // The frame stands for the film up to the next one, which may belong to another rig.
        const WideRational next = frame_time(frame + 1, timing);
        const double from = scene_time_at(*rig, time).to_double() - scene_time;
        const double to = scene_time_at(*rig, next).to_double() - scene_time;
        if (from == 0) {
            return frame;
        }
        if (from * to <= 0) {
            const bool is_next_nearer = std::abs(to) < std::abs(from) && is_active(*rig, next);
            return is_next_nearer ? frame + 1 : frame;
        }
    }
    return std::nullopt;
}

}  // namespace carom::pipeline
