#include "pipeline/check/turn_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "core/elementary.h"
#include "pipeline/camera/steady_up.h"

namespace carom::pipeline {

namespace {

/// The angle of the rotation from one camera's axes to the other's: the trace of its matrix is
/// 1 + 2 cos(angle).
double turn_between(const ViewAxes& a, const ViewAxes& b) {
    const double trace = a.right.dot(b.right) + a.up.dot(b.up) + a.ahead.dot(b.ahead);
    return arccosine(std::clamp((trace - 1) / 2, -1.0, 1.0));
}

int degrees(double angle) {
    return static_cast<int>(std::lround(angle * 180 / std::numbers::pi));
}

}  // namespace

void TurnCheck::add(Found& found, double angle, std::int64_t first, std::int64_t last) {
    found.frames = FrameRange{found.frames ? found.frames->first : first, last};
    found.angle = std::max(found.angle, angle);
}

void TurnCheck::check_frame(const PlannedFrame& frame, const Vec3& up) {
    // In the order of video time.
    const ViewAxes open = view_axes(frame.reversed ? frame.camera_close : frame.camera_open);
    const ViewAxes close = view_axes(frame.reversed ? frame.camera_open : frame.camera_close);
    const double in_shutter = turn_between(open, close);
    if (in_shutter > kTurnOfShutter) {
        add(in_shutter_, in_shutter, frame.number, frame.number);
    }
    const double between =
        before_ && *before_ + 1 == frame.number ? turn_between(axes_before_, open) : 0;
    if (between > kTurnOfFrame) {
        add(between_, between, *before_, frame.number);
    }
    constexpr double kUpsideDown = -0.7;  // cosine
    const render::CameraState& state = frame.camera_open;
    const Vec3 ahead = (state.target - state.position).normalized();
    if (upright_of(ahead, state.up).dot(up.normalized()) < kUpsideDown) {
        extend(upside_down_, frame.number);
    }
    before_ = frame.number;
    axes_before_ = open;
}

void TurnCheck::report(const FilmTiming& timing, const AddTurnWarning& add) const {
    if (between_.frames) {
        add("target", fmt::format("turns by up to {} degrees from one frame to the next {}, which "
                                  "looks like a cut",
                                  degrees(between_.angle), between_.frames->text(timing)));
    }
    if (in_shutter_.frames) {
        add("target",
            fmt::format("turns by up to {} degrees while the shutter is open {}, so that the "
                        "picture is smeared",
                        degrees(in_shutter_.angle), in_shutter_.frames->text(timing)));
    }
    if (upside_down_) {
        add("position",
            fmt::format("keeps its up direction where it passes over or under its target, so "
                        "its picture is upside down {}; 'up' or 'roll' with keys turns it",
                        upside_down_->text(timing)));
    }
}

}  // namespace carom::pipeline
