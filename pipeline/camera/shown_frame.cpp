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

/// The first time in [from, to], s, at which the rig shows the scene at `scene_time` or later.
std::optional<double> time_reached_in(const CameraRig& rig, double scene_time, double from,
                                      double to) {
    constexpr double kRounding = 1e-9;  // s; a camera that starts at a moment shows it
    constexpr int kSteps = 4096;        // of a ramp, which may turn back within a step
    constexpr int kHalvings = 60;
    const auto left = [&](double time) {
        return scene_time - scene_time_at(rig, Rational::nearest(time)).to_double() - kRounding;
    };
    const int steps = rig.time_map.speeds.empty() ? 1 : kSteps;
    double before = from;
    for (int i = 0; i <= steps; ++i) {
        double after = from + (to - from) * i / steps;
        if (left(after) > 0) {
            before = after;
            continue;
        }
        for (int halving = 0; i > 0 && halving < kHalvings; ++halving) {
            const double middle = (before + after) / 2;
            (left(middle) > 0 ? before : after) = middle;
        }
        return after;
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> time_reached(double scene_time, std::span<const CameraRig> rigs) {
    std::optional<double> reached;
    for (const CameraRig& rig : rigs) {
        double end = rig.video_end.to_double();
        for (const CameraRig& next : rigs) {
            if (rig.video_start < next.video_start && next.video_start < rig.video_end) {
                end = std::min(end, next.video_start.to_double() + next.fade.to_double() / 2);
            }
        }
        const double start = rig.video_start.to_double() + rig.fade.to_double() / 2;
        const auto here = time_reached_in(rig, scene_time, start, end);
        if (here && *here < end && (!reached || *here < *reached)) {
            reached = here;
        }
    }
    return reached;
}

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
