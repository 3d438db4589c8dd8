#include "pipeline/check/motion_check.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/core.h>

#include "core/elementary.h"
#include "core/error.h"
#include "pipeline/camera/changing_value.h"
#include "pipeline/camera/exposure.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/frame_range.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/check/lamp_check.h"
#include "pipeline/check/placed_problem.h"
#include "pipeline/check/solid_check.h"
#include "pipeline/check/things_check.h"
#include "pipeline/check/turn_check.h"
#include "pipeline/check/view_check.h"

namespace carom::pipeline {

namespace {

constexpr std::int64_t kMaxCheckedFrames = 2000;
constexpr std::int64_t kMaxTurnFrames = 50'000;  // in longer films, pairs of frames are checked
constexpr std::int64_t kLampFrames = 50;         // of the film, in which lamps are looked for
constexpr double kHiddenShare = 0.1;             // of the cloth, from which on a lamp is reported
constexpr double kHighPicture = 100;             // m, where the target is

/// What all cameras of a shot are checked against.
struct Subjects {
    SolidCheck solids;
    std::map<std::string, double> sizes;
    LampCheck lamps;
    ThingsCheck things;
};

/// Checks one camera, frame by frame.
class CameraChecker {
  public:
    /// `target`: the path of the rig's target as it was written.
    CameraChecker(const CameraRig& rig, const CameraPath& target, Subjects& subjects,
                  const FilmTiming& timing, const sim::Timeline& timeline)
        : rig_(rig),
          timing_(timing),
          solids_(subjects.solids),
          lamps_(subjects.lamps),
          things_(subjects.things),
          timeline_(timeline),
          view_(rig, target, subjects.sizes, timeline) {}

    void check_frame(std::int64_t frame, bool with_lamps) {
        const WideRational time = frame_time(frame, timing_);
        const RigInstant instant{progress_at(rig_, time), scene_time_at(rig_, time).to_double()};
        try {
            const render::CameraState camera = camera_state(rig_, instant, timeline_);
            check_place(camera.position, instant.scene_time, frame);
            for (const std::string& name : find_focus_behind_camera(rig_, instant, timeline_)) {
                extend(behind_[name], frame);
            }
            view_.check_frame(camera, instant.progress, instant.scene_time);
            check_picture(camera, instant.scene_time, frame);
            if (with_lamps && lamps_.is_above_table(camera)) {
                check_lamps(camera);
            }
        } catch (const Error& error) {
            extend(invalid_[error.what()], frame);
        }
    }

    /// The same for how the camera turns, of which every frame has to be known.
    void check_turn(std::int64_t frame) {
        try {
            turn_.check_frame(
                plan_frame_of(frame, rig_, timing_, timeline_),
                value_at(rig_.up, rig_, progress_at(rig_, frame_time(frame, timing_))));
        } catch (const Error& error) {
            extend(invalid_[error.what()], frame);
        }
    }

    void report(std::size_t index, const ShotSource* source, std::vector<Problem>& problems) const {
        const std::string number = fmt::format("{}", index);
        const std::string camera = "camera '" + rig_.name + "' ";
        const auto add_problem = [&](const char* key, Severity severity,
                                     const std::string& message) {
            problems.push_back(
                placed_problem(source, {"cameras", number, key}, severity, camera + message));
        };
        for (const auto& [reason, frames] : invalid_) {
            add_problem("name", Severity::error,
                        "has no valid view " + frames->text(timing_) + ": " + reason);
        }
        for (const auto& [place, frames] : places_) {
            add_problem("position", Severity::warning, "is " + place + " " + frames->text(timing_));
        }
        if (2 * frames_without_ > frames_) {
            add_problem("target", Severity::warning,
                        "shows nothing " + without_->text(timing_) +
                            ": no ball, no object and no part of the table is in its picture");
        }
        if (far_) {
            add_problem("target", Severity::warning,
                        fmt::format("aims at a point {:.0f} m away {}, where its picture is {:.0f} "
                                    "m high; lengths without a unit are metres",
                                    distance_, far_->text(timing_), height_));
        }
        for (const auto& [object, frames] : behind_) {
            add_problem(
                "focus", Severity::warning,
                "is focused on '" + object + "', which is behind it " + frames->text(timing_));
        }
        view_.report([&](const char* key, const std::string& object, const std::string& message) {
            if (behind_.count(object) == 0) {  // else it has been reported
                add_problem(key, Severity::warning, message);
            }
        });
        turn_.report(timing_, [&](const char* key, const std::string& message) {
            add_problem(key, Severity::warning, message);
        });
        for (const auto& [lamp, found] : hidden_) {
            if (2 * found.frames > frames_above_) {
                add_problem("position", Severity::warning,
                            fmt::format("looks down on the table, but '{}' is between them and "
                                        "hides {:.0f} % of the cloth",
                                        lamp, 100 * found.share));
            }
        }
    }

  private:
    void check_place(const Vec3& position, double scene_time, std::int64_t frame) {
        const std::vector<std::string> around = solids_.find_around(position, scene_time);
        for (const std::string& name : around) {
            extend(places_["inside '" + name + "'"], frame);
        }
        const std::string place = things_.place_under_table(position);
        if (around.empty() && !place.empty()) {
            extend(places_[place], frame);
        }
    }

    /// Whether something is in the picture, and how large things at the target would be.
    void check_picture(const render::CameraState& camera, double scene_time, std::int64_t frame) {
        ++frames_;
        if (!things_.may_be_seen(camera, scene_time)) {
            ++frames_without_;
            extend(without_, frame);
        }
        const double distance = (camera.target - camera.position).length();
        const double height = 2 * distance * tangent(camera.vertical_fov / 2);
        if (height > kHighPicture) {
            extend(far_, frame);
            distance_ = std::max(distance_, distance);
            height_ = std::max(height_, height);
        }
    }

    void check_lamps(const render::CameraState& camera) {
        ++frames_above_;
        for (const auto& [lamp, share] : lamps_.hidden_shares(camera)) {
            if (share >= kHiddenShare) {
                Hidden& found = hidden_[lamp];
                ++found.frames;
                found.share = std::max(found.share, share);
            }
        }
    }

    /// What a lamp hides.
    struct Hidden {
        std::int64_t frames = 0;
        double share = 0;  // of the cloth in the picture, the largest of all frames
    };

    const CameraRig& rig_;
    const FilmTiming& timing_;
    SolidCheck& solids_;
    LampCheck& lamps_;
    ThingsCheck& things_;
    const sim::Timeline& timeline_;
    ViewCheck view_;
    TurnCheck turn_;
    std::map<std::string, std::optional<FrameRange>> places_, behind_, invalid_;
    std::optional<FrameRange> without_, far_;
    std::int64_t frames_ = 0;
    std::int64_t frames_without_ = 0;  // anything in the picture
    double distance_ = 0;              // of the farthest target of `far_`
    double height_ = 0;                // of the picture there
    std::map<std::string, Hidden> hidden_;
    std::int64_t frames_above_ = 0;  // frames in which the camera looked down on the table
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
        problems.push_back(placed_problem(source, warning));
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
        problems.push_back(placed_problem(source, warning));
    }
    return problems;
}

std::vector<Problem> camera_problems(const Shot& shot, const ShotSource* source,
                                     const sim::Timeline& timeline) {
    const std::vector<CameraRig> rigs = fit_camera_paths(shot, timeline);
    Subjects subjects{SolidCheck(shot, timeline), sizes_of_objects(shot), LampCheck(shot),
                      ThingsCheck(shot, timeline)};
    std::vector<CameraChecker> checkers;
    checkers.reserve(rigs.size());
    for (std::size_t i = 0; i < rigs.size(); ++i) {
        checkers.emplace_back(rigs[i], shot.cameras[i].target, subjects, shot.timing, timeline);
    }
    const std::int64_t frames = frame_count(rigs, shot.timing);
    const std::int64_t step = std::max<std::int64_t>(1, frames / kMaxCheckedFrames);
    const std::int64_t lamp_step = step * std::max<std::int64_t>(1, frames / step / kLampFrames);
    const std::int64_t turn_step = 1 + frames / kMaxTurnFrames;
    for (std::int64_t frame = 0; frame < frames; ++frame) {
        const WideRational time = frame_time(frame, shot.timing);
        for (std::size_t i = 0; i < rigs.size(); ++i) {
            if (!is_active(rigs[i], time)) {
                continue;
            }
            if (frame % turn_step < 2) {
                checkers[i].check_turn(frame);
            }
            if (frame % step == 0) {
                checkers[i].check_frame(frame, frame % lamp_step == 0);
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
