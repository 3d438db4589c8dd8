#include "pipeline/check/motion_check.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/core.h>

#include "core/error.h"
#include "core/text.h"
#include "pipeline/camera/exposure.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/camera/rig_state.h"

namespace carom::pipeline {

namespace {

constexpr std::int64_t kMaxCheckedFrames = 2000;

Problem problem_at(const ShotSource* source, const std::vector<std::string>& path,
                   Severity severity, std::string message) {
    if (source != nullptr) {
        return source->problem_at(path, severity, std::move(message));
    }
    Problem problem;
    problem.severity = severity;
    problem.message = std::move(message);
    return problem;
}

/// The first and the last frame of a camera with a problem.
struct FrameRange {
    std::int64_t first = 0, last = 0;

    /// "at 1.25 s of the film (frame 30)", "from 1.25 s to 2 s of the film (frames 30 to 48)"
    [[nodiscard]] std::string text(const FilmTiming& timing) const {
        const auto time = [&](std::int64_t frame) {
            return decimal_text(static_cast<double>(frame) / timing.fps.to_double(), 3) + " s";
        };
        return first == last ? fmt::format("at {} of the film (frame {})", time(first), first)
                             : fmt::format("from {} to {} of the film (frames {} to {})",
                                           time(first), time(last), first, last);
    }
};

struct Ball {
    const sim::Track* track = nullptr;
    double radius = 0;
};

std::vector<Ball> balls_of(const Shot& shot, const sim::Timeline& timeline) {
    std::vector<Ball> balls;
    for (const sim::Body& body : shot.world.bodies) {
        const auto* sphere = std::get_if<sim::Sphere>(&body.shape);
        const sim::Track* track = timeline.find(body.name);
        if (sphere != nullptr && track != nullptr) {
            balls.push_back({track, sphere->radius});
        }
    }
    return balls;
}

/// Checks one camera, frame by frame.
class CameraChecker {
  public:
    CameraChecker(const CameraRig& rig, const FilmTiming& timing, const std::vector<Ball>& balls,
                  const sim::Timeline& timeline)
        : rig_(rig), timing_(timing), balls_(balls), timeline_(timeline) {}

    void check_frame(std::int64_t frame) {
        const WideRational time = frame_time(frame, timing_);
        const RigInstant instant{progress_at(rig_, time), scene_time_at(rig_, time).to_double()};
        try {
            const render::CameraState camera = camera_state(rig_, instant, timeline_);
            for (const Ball& ball : balls_) {
                const Vec3 centre = ball.track->sample(instant.scene_time).position;
                if ((camera.position - centre).length() < ball.radius) {
                    add(inside_[ball.track->name()], frame);
                }
            }
            for (const std::string& name : find_focus_behind_camera(rig_, instant, timeline_)) {
                add(behind_[name], frame);
            }
        } catch (const Error& error) {
            add(invalid_[error.what()], frame);
        }
    }

    void report(std::size_t index, const ShotSource* source, std::vector<Problem>& problems) const {
        const std::string number = fmt::format("{}", index);
        const std::string camera = "camera '" + rig_.name + "' ";
        const auto add_problem = [&](const char* key, Severity severity,
                                     const std::string& message) {
            problems.push_back(
                problem_at(source, {"cameras", number, key}, severity, camera + message));
        };
        for (const auto& [reason, frames] : invalid_) {
            add_problem("name", Severity::error,
                        "has no valid view " + frames->text(timing_) + ": " + reason);
        }
        for (const auto& [ball, frames] : inside_) {
            add_problem("position", Severity::warning,
                        "is inside '" + ball + "' " + frames->text(timing_));
        }
        for (const auto& [object, frames] : behind_) {
            add_problem(
                "focus", Severity::warning,
                "is focused on '" + object + "', which is behind it " + frames->text(timing_));
        }
    }

  private:
    static void add(std::optional<FrameRange>& range, std::int64_t frame) {
        range = range ? FrameRange{range->first, frame} : FrameRange{frame, frame};
    }

    const CameraRig& rig_;
    const FilmTiming& timing_;
    const std::vector<Ball>& balls_;
    const sim::Timeline& timeline_;
    std::map<std::string, std::optional<FrameRange>> inside_, behind_, invalid_;
};

/// The shot's cameras with fitted paths; unchanged if the object of a path does not exist.
std::vector<CameraRig> fit_camera_paths(const Shot& shot, const sim::Timeline& timeline) {
    try {
        return with_fitted_paths(shot.cameras, timeline);
    } catch (const Error&) {
        return shot.cameras;
    }
}

bool is_active(const CameraRig& rig, const WideRational& time) {
    return (time - WideRational(rig.video_start)).sign() >= 0 &&
           (time - WideRational(rig.video_end)).sign() < 0;
}

}  // namespace

std::vector<Problem> simulation_problems(const sim::Timeline& timeline, const ShotSource* source) {
    std::vector<Problem> problems;
    for (const Diagnostic& warning : timeline.warnings) {
        problems.push_back(source != nullptr
                               ? source->problem_of(warning)
                               : problem_at(nullptr, {}, warning.severity, warning.sentence));
    }
    return problems;
}

std::vector<Problem> stick_problems(const Shot& shot, const ShotSource* source,
                                    const sim::Timeline& timeline) {
    std::vector<Problem> problems;
    if (shot.stick.events.empty()) {
        return problems;
    }
    for (const Diagnostic& warning : stick_problems(shot.stick, shot.world, timeline)) {
        problems.push_back(source != nullptr
                               ? source->problem_of(warning)
                               : problem_at(nullptr, {}, warning.severity, warning.sentence));
    }
    return problems;
}

std::vector<Problem> camera_problems(const Shot& shot, const ShotSource* source,
                                     const sim::Timeline& timeline) {
    const std::vector<CameraRig> rigs = fit_camera_paths(shot, timeline);
    const std::vector<Ball> balls = balls_of(shot, timeline);
    std::vector<CameraChecker> checkers;
    checkers.reserve(rigs.size());
    for (const CameraRig& rig : rigs) {
        checkers.emplace_back(rig, shot.timing, balls, timeline);
    }
    const std::int64_t frames = frame_count(rigs, shot.timing);
    const std::int64_t step = std::max<std::int64_t>(1, frames / kMaxCheckedFrames);
    for (std::int64_t frame = 0; frame < frames; frame += step) {
        const WideRational time = frame_time(frame, shot.timing);
        for (std::size_t i = 0; i < rigs.size(); ++i) {
            if (is_active(rigs[i], time)) {
                checkers[i].check_frame(frame);
            }
        }
    }
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < checkers.size(); ++i) {
        checkers[i].report(i, source, problems);
    }
    return problems;
}

}  // namespace carom::pipeline
