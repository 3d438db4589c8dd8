// Warns of what is not heard, or not as one would expect.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "pipeline/camera/time_map.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/check/placed_problem.h"

namespace carom::pipeline {

namespace {

constexpr double kSampleInterval = 1.0 / 240;  // s, in which a fast ball moves by its radius

/// The first time at which the point is inside the ball, s; empty if it never is, or from the
/// start, of which the reader of the shot warns.
std::optional<double> find_time_inside(const Vec3& point, double radius, const sim::Track& track,
                                       const sim::Timeline& timeline) {
    const double duration = timeline.end_time - timeline.start_time;
    const auto samples = static_cast<int>(std::ceil(duration / kSampleInterval));
    for (int i = 0; i <= samples; ++i) {
        const double time = std::min(timeline.start_time + i * kSampleInterval, timeline.end_time);
        if ((track.sample(time).position - point).length() < radius) {
            return i > 0 ? std::optional(time) : std::nullopt;
        }
    }
    return std::nullopt;
}

class SoundChecker {
  public:
    SoundChecker(const Shot& shot, const ShotSource* source, const sim::Timeline& timeline)
        : shot_(shot), source_(source), timeline_(timeline) {}

    void check() {
        const CameraSound& all = shot_.sound.cameras;
        check_listener(all, {"sound", "listener", "at"});
        for (std::size_t i = 0; i < shot_.cameras.size(); ++i) {
            check_listener(shot_.cameras[i].sound,
                           {"cameras", fmt::format("{}", i), "sound", "listener", "at"});
        }
        if (all.listener && !all.listener->is_camera && !shot_.cameras.empty()) {
            check_unseen_impacts();
        }
    }

    std::vector<Problem> problems;

  private:
    void warn(const std::vector<std::string>& path, const std::string& message) {
        problems.push_back(placed_problem(source_, path, Severity::warning, message));
    }

    void check_listener(const CameraSound& sound, const std::vector<std::string>& path) {
        if (!sound.listener || sound.listener->is_camera) {
            return;
        }
        for (const sim::Body& body : shot_.world.bodies) {
            const auto* ball = std::get_if<sim::Sphere>(&body.shape);
            const sim::Track* track = ball != nullptr ? timeline_.find(body.name) : nullptr;
            if (track == nullptr) {
                continue;
            }
            if (const auto time =
                    find_time_inside(sound.listener->at, ball->radius, *track, timeline_)) {
                warn(path, fmt::format("the listener is inside '{}' at {:.3f} s of the scene",
                                       body.name, *time));
            }
        }
    }

    [[nodiscard]] bool is_shown(double time) const {
        return std::ranges::any_of(shot_.cameras, [&](const CameraRig& rig) {
            const SceneTimeRange shown = shown_scene_times(rig);
            return shown.first.to_double() <= time && time <= shown.last.to_double();
        });
    }

    void check_unseen_impacts() {
        std::vector<double> times;  // of the impacts that no camera shows
        for (const sim::Event& event : timeline_.events) {
            if (event.kind == sim::EventKind::impact && !is_shown(event.time)) {
                times.push_back(event.time);
            }
        }
        if (times.empty()) {
            return;
        }
        const auto [first, last] = std::ranges::minmax(times);
        const std::string which =
            times.size() == 1 ? fmt::format("the impact at {:.3f} s of the scene is", first)
                              : fmt::format("{} impacts from {:.3f} s to {:.3f} s of the scene are",
                                            times.size(), first, last);
        warn({"sound", "listener"},
             which +
                 " not heard, because no camera shows that time: a film has the sound of what "
                 "it shows, wherever the listener is");
    }

    const Shot& shot_;
    const ShotSource* source_;
    const sim::Timeline& timeline_;
};

}  // namespace

std::vector<Problem> sound_problems(const Shot& shot, const ShotSource* source,
                                    const sim::Timeline& timeline) {
    if (shot.sound.is_silent) {
        return {};
    }
    SoundChecker checker(shot, source, timeline);
    checker.check();
    return std::move(checker.problems);
}

}  // namespace carom::pipeline
