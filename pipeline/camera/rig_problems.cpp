// Problems of rigs as a sequence.
#include <algorithm>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/wide_rational.h"

namespace carom::pipeline {
namespace {

std::string quoted(const CameraRig& rig) {
    return "camera '" + rig.name + "'";
}

std::string seconds(const Rational& time) {
    return seconds_text(time.to_double());
}

void check_timing(const FilmTiming& timing, std::vector<RigProblem>& problems) {
    if (timing.fps <= Rational(0)) {
        problems.push_back(
            {"the film has " + timing.fps.to_string() + " frames per second; it needs more than 0",
             {},
             {}});
    }
    if (timing.shutter.exposure < Rational(0)) {
        problems.push_back({"the shutter is open for " + seconds(timing.shutter.exposure) +
                                "; it cannot be less than 0",
                            {},
                            {}});
    }
    if (!(timing.shutter.switch_ratio >= 0 && timing.shutter.switch_ratio <= 1)) {
        problems.push_back(
            {fmt::format("the shutter's switch ratio is {:f}; it must be between 0 and 1",
                         timing.shutter.switch_ratio),
             {},
             {}});
    }
}

/// The problem of the transition from `before` to `after`; empty if there is none.
std::string transition_problem(const CameraRig& before, const CameraRig& after) {
    if (after.fade == Rational(0)) {
        if (before.video_end < after.video_start) {
            return "there is a gap in the film: " + quoted(before) + " ends at " +
                   seconds(before.video_end) + ", and " + quoted(after) + " starts at " +
                   seconds(after.video_start);
        }
        if (after.video_start < before.video_end) {
            return quoted(after) + " starts at " + seconds(after.video_start) +
                   " of the film, before " + quoted(before) + " ends at " +
                   seconds(before.video_end) + "; to overlap it needs a 'fade' of " +
                   seconds(before.video_end - after.video_start);
        }
        return {};
    }
    const Rational fade_end = after.video_start + after.fade;
    if (before.video_end != fade_end) {
        return quoted(after) + " fades in until " + seconds(fade_end) + " of the film, so " +
               quoted(before) + " must end there, not at " + seconds(before.video_end);
    }
    if (after.video_start < before.video_start + before.fade) {
        return quoted(after) + " starts to fade in at " + seconds(after.video_start) +
               " of the film, before " + quoted(before) + " has finished fading in at " +
               seconds(before.video_start + before.fade);
    }
    return {};
}

/// The problem of a fade that is longer than its rig or has no rig to fade from; empty if there is
/// none.
std::string fade_problem(const CameraRig& rig, bool is_first) {
    if (rig.fade == Rational(0)) {
        return {};
    }
    if (is_first) {
        return quoted(rig) + " fades in, but no camera films before it";
    }
    if (rig.video_end < rig.video_start + rig.fade) {
        return quoted(rig) + " ends at " + seconds(rig.video_end) +
               " of the film, before it has faded in at " + seconds(rig.video_start + rig.fade);
    }
    return {};
}

}  // namespace

std::vector<RigProblem> find_problems(std::span<const CameraRig> rigs, const FilmTiming& timing) {
    std::vector<RigProblem> problems;
    check_timing(timing, problems);
    if (rigs.empty()) {
        problems.push_back({"there is no camera", {}, {}});
        return problems;
    }
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < rigs.size(); ++i) {
        const CameraRig& rig = rigs[i];
        if (rig.video_end <= rig.video_start) {
            problems.push_back({quoted(rig) + " films from " + seconds(rig.video_start) + " to " +
                                    seconds(rig.video_end) +
                                    " of the film; the end must be after the start",
                                i,
                                {}});
        } else {
            order.push_back(i);
        }
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rigs[a].video_start < rigs[b].video_start;
    });
    if (!order.empty() && rigs[order.front()].video_start != Rational(0)) {
        const CameraRig& first = rigs[order.front()];
        problems.push_back({"the film starts at 0 s, but its first camera, '" + first.name +
                                "', starts at " + seconds(first.video_start),
                            order.front(),
                            {}});
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::string fade = fade_problem(rigs[order[i]], i == 0);
        if (!fade.empty()) {
            problems.push_back({fade, order[i], {}});
        } else if (i > 0) {
            const std::string transition = transition_problem(rigs[order[i - 1]], rigs[order[i]]);
            if (!transition.empty()) {
                problems.push_back({transition, order[i], order[i - 1]});
            }
        }
    }
    return problems;
}

}  // namespace carom::pipeline
