// What is wrong with rigs as a sequence.
#include <algorithm>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/wide_rational.h"

namespace carom::pipeline {
namespace {

std::string quoted(const CameraRig& rig) {
    return "camera '" + rig.name + "'";
}

std::string seconds(const Rational& time) {
    std::string text = std::to_string(time.to_double());
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
        text.pop_back();
    }
    return text + " s";
}

void check_timing(const FilmTiming& timing, std::vector<std::string>& problems) {
    if (timing.fps <= Rational(0)) {
        problems.push_back("the film has " + timing.fps.to_string() +
                           " frames per second; it needs more than 0");
    }
    if (timing.shutter.exposure < Rational(0)) {
        problems.push_back("the shutter is open for " + seconds(timing.shutter.exposure) +
                           "; it cannot be less than 0");
    }
    if (!(timing.shutter.switch_ratio >= 0 && timing.shutter.switch_ratio <= 1)) {
        problems.push_back("the shutter's switch ratio is " +
                           std::to_string(timing.shutter.switch_ratio) +
                           "; it must be between 0 and 1");
    }
}

void check_neighbours(const CameraRig& before, const CameraRig& after,
                      std::vector<std::string>& problems) {
    if (before.video_end < after.video_start) {
        problems.push_back("nobody films between " + quoted(before) + ", which ends at " +
                           seconds(before.video_end) + " of the film, and " + quoted(after) +
                           ", which starts at " + seconds(after.video_start));
    } else if (after.video_start < before.video_end) {
        problems.push_back(quoted(after) + " starts at " + seconds(after.video_start) +
                           " of the film, before " + quoted(before) + " ends at " +
                           seconds(before.video_end));
    }
}

}  // namespace

std::vector<std::string> find_problems(std::span<const CameraRig> rigs, const FilmTiming& timing) {
    std::vector<std::string> problems;
    check_timing(timing, problems);
    if (rigs.empty()) {
        problems.push_back("there is no camera");
        return problems;
    }
    std::vector<const CameraRig*> order;
    for (const CameraRig& rig : rigs) {
        if (rig.video_end <= rig.video_start) {
            problems.push_back(quoted(rig) + " films from " + seconds(rig.video_start) + " to " +
                               seconds(rig.video_end) +
                               " of the film; the end must be after the start");
        } else {
            order.push_back(&rig);
        }
    }
    std::stable_sort(order.begin(), order.end(), [](const CameraRig* a, const CameraRig* b) {
        return a->video_start < b->video_start;
    });
    if (!order.empty() && order.front()->video_start != Rational(0)) {
        problems.push_back("the film starts at 0 s, but its first camera, '" + order.front()->name +
                           "', at " + seconds(order.front()->video_start));
    }
    for (std::size_t i = 1; i < order.size(); ++i) {
        check_neighbours(*order[i - 1], *order[i], problems);
    }
    return problems;
}

}  // namespace carom::pipeline
