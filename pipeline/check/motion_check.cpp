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

constexpr std::int64_t kMostFrames = 2000;

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

/// The frames of a camera at which something is the case.
struct Stretch {
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

/// Looks at one camera, frame by frame.
class RigLook {
  public:
    RigLook(const CameraRig& rig, const FilmTiming& timing, const std::vector<Ball>& balls,
            const sim::Timeline& timeline)
        : rig_(rig), timing_(timing), balls_(balls), timeline_(timeline) {}

    void look(std::int64_t frame) {
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
            for (const std::string& name : focus_behind_camera(rig_, instant, timeline_)) {
                add(behind_[name], frame);
            }
        } catch (const Error& error) {
            add(broken_[error.what()], frame);
        }
    }

    void report(std::size_t index, const ShotSource* source, std::vector<Problem>& problems) const {
        const std::string number = fmt::format("{}", index);
        const std::string camera = "camera '" + rig_.name + "' ";
        const auto tell = [&](const char* key, Severity severity, const std::string& message) {
            problems.push_back(
                problem_at(source, {"cameras", number, key}, severity, camera + message));
        };
        for (const auto& [reason, stretch] : broken_) {
            tell("name", Severity::error,
                 "makes no picture " + stretch->text(timing_) + ": " + reason);
        }
        for (const auto& [ball, stretch] : inside_) {
            tell("position", Severity::warning,
                 "is inside '" + ball + "' " + stretch->text(timing_));
        }
        for (const auto& [object, stretch] : behind_) {
            tell("focus", Severity::warning,
                 "is focused on '" + object + "', which is behind it " + stretch->text(timing_));
        }
    }

  private:
    static void add(std::optional<Stretch>& stretch, std::int64_t frame) {
        stretch = stretch ? Stretch{stretch->first, frame} : Stretch{frame, frame};
    }

    const CameraRig& rig_;
    const FilmTiming& timing_;
    const std::vector<Ball>& balls_;
    const sim::Timeline& timeline_;
    std::map<std::string, std::optional<Stretch>> inside_, behind_, broken_;
};

/// The shot's cameras, ready to be asked; those along something that is not there stay as they are.
std::vector<CameraRig> ready(const Shot& shot, const sim::Timeline& timeline) {
    try {
        return with_fitted_paths(shot.cameras, timeline);
    } catch (const Error&) {
        return shot.cameras;
    }
}

bool films(const CameraRig& rig, const WideRational& time) {
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

std::vector<Problem> camera_problems(const Shot& shot, const ShotSource* source,
                                     const sim::Timeline& timeline) {
    const std::vector<CameraRig> rigs = ready(shot, timeline);
    const std::vector<Ball> balls = balls_of(shot, timeline);
    std::vector<RigLook> looks;
    looks.reserve(rigs.size());
    for (const CameraRig& rig : rigs) {
        looks.emplace_back(rig, shot.timing, balls, timeline);
    }
    const std::int64_t frames = frame_count(rigs, shot.timing);
    const std::int64_t step = std::max<std::int64_t>(1, frames / kMostFrames);
    for (std::int64_t frame = 0; frame < frames; frame += step) {
        const WideRational time = frame_time(frame, shot.timing);
        for (std::size_t i = 0; i < rigs.size(); ++i) {
            if (films(rigs[i], time)) {
                looks[i].look(frame);
            }
        }
    }
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        looks[i].report(i, source, problems);
    }
    return problems;
}

}  // namespace carom::pipeline
