#include "pipeline/camera/frame_plan.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/camera/exposure.h"
#include "pipeline/camera/no_view.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/steady_up.h"

namespace carom::pipeline {
namespace {

struct WeightedRig {
    const CameraRig* rig = nullptr;
    double weight = 1;  // in the picture
};

bool is_active(const CameraRig& rig, const WideRational& video_time) {
    return (video_time - WideRational(rig.video_start)).sign() >= 0 &&
           (WideRational(rig.video_end) - video_time).sign() > 0;
}

/// The weight in the picture of a rig that is fading in.
WideRational fade_weight(const CameraRig& rig, const WideRational& video_time) {
    const WideRational since = video_time - WideRational(rig.video_start);
    const bool is_fading = (WideRational(rig.fade) - since).sign() > 0;
    return is_fading ? since / WideRational(rig.fade) : WideRational(1, 1);
}

/// The rigs that film at that time, in the order of descending weight.
std::vector<WeightedRig> rigs_at(std::span<const CameraRig> rigs, const WideRational& video_time,
                                 std::int64_t number) {
    const CameraRig* latest = nullptr;
    const CameraRig* before = nullptr;  // the rig from which it takes over
    for (const CameraRig& rig : rigs) {
        if (!is_active(rig, video_time)) {
            continue;
        }
        const bool is_later = latest == nullptr || latest->video_start < rig.video_start;
        if (is_later) {
            before = latest;
            latest = &rig;
        } else {
            before = &rig;
        }
    }
    if (latest == nullptr) {
        throw Error(fmt::format("no camera films frame {} at {:f} s of the film", number,
                                video_time.to_double()));
    }
    const double weight = fade_weight(*latest, video_time).to_double();
    if (before == nullptr || weight == 1) {
        return {{latest, 1}};
    }
    if (weight == 0) {
        return {{before, 1}};
    }
    if (weight < 0.5) {
        return {{before, 1 - weight}, {latest, weight}};
    }
    return {{latest, weight}, {before, 1 - weight}};
}

Vec3 ahead_of(const render::CameraState& camera) {
    return (camera.target - camera.position).normalized();
}

/// Whether the picture is turned by more than a right angle from one view to the other, besides
/// the turn from view to view.
bool is_turned_over(const render::CameraState& a, const render::CameraState& b) {
    const Vec3 upright = carried(upright_of(ahead_of(a), a.up), ahead_of(a), ahead_of(b));
    return upright.dot(b.up) < 0;
}

/// Lets both ends of an exposure be the same way up as its middle, which the ends of the path and
/// objects that jump do not ensure: between them the renderer mixes the up directions.
void join_up(PlannedFrame& frame, const CameraRig& rig, const Exposure& exposure,
             const sim::Timeline& timeline) {
    if (is_turned_over(frame.camera_open, frame.camera_close)) {
        const render::CameraState middle =
            camera_state(rig, {progress_at(rig, exposure.video_time), frame.scene_time}, timeline);
        for (render::CameraState* end : {&frame.camera_open, &frame.camera_close}) {
            end->up = is_turned_over(middle, *end) ? -end->up : end->up;
        }
    } else if (!rig.up_turns || rig.up_turns->empty() ||
               frame.camera_open.up == frame.camera_close.up) {
        return;
    }
    for (render::CameraState* end : {&frame.camera_open, &frame.camera_close}) {
        end->up = upright_of(ahead_of(*end), end->up);
    }
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

PlannedFrame plan_frame_of(std::int64_t number, const CameraRig& rig, const FilmTiming& timing,
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
    join_up(frame, rig, exposure, timeline);
    // The number of blades does not change while the shutter is open.
    const int blades = blades_at(rig, progress_at(rig, exposure.video_time));
    frame.camera_open.blades = blades;
    frame.camera_close.blades = blades;
    frame.speed = speed_at(rig, exposure.video_time).to_double();
    frame.look = rig.lens.look;
    if (frame.scene_close < frame.scene_open) {
        std::swap(frame.scene_open, frame.scene_close);
        std::swap(frame.camera_open, frame.camera_close);
        frame.reversed = true;
    }
    return frame;
}

std::vector<PlannedFrame> plan_mixed_frame(std::int64_t number, std::span<const CameraRig> rigs,
                                           const FilmTiming& timing,
                                           const sim::Timeline& timeline) {
    std::vector<PlannedFrame> frames;
    for (const WeightedRig& seen : rigs_at(rigs, frame_time(number, timing), number)) {
        try {
            frames.push_back(plan_frame_of(number, *seen.rig, timing, timeline));
            frames.back().weight = seen.weight;
        } catch (const Error& error) {
            throw NoView(
                fmt::format("camera '{}', frame {}: {}", seen.rig->name, number, error.what()));
        }
    }
    return frames;
}

PlannedFrame plan_frame(std::int64_t number, std::span<const CameraRig> rigs,
                        const FilmTiming& timing, const sim::Timeline& timeline) {
    return plan_mixed_frame(number, rigs, timing, timeline).front();
}

}  // namespace carom::pipeline
