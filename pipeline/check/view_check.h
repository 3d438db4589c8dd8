// Finds cameras whose picture does not show what they are for.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/progress.h"
#include "pipeline/shot/shot.h"
#include "render/camera/camera_state.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The radius of a ball around each moving object of the shot, by its track, m.
[[nodiscard]] std::map<std::string, double> sizes_of_objects(const Shot& shot);

/// Adds a warning about an object at one of the camera's keys: the sentence after the camera's
/// name.
using AddViewWarning =
    std::function<void(const char* key, const std::string& object, const std::string& sentence)>;

/// Counts in how many of its frames a camera sees the object that it aims at, and the objects on
/// which it is focused.
class ViewCheck {
  public:
    /// `target`: the path of the target as it was written. The arguments must outlive the object.
    ViewCheck(const CameraRig& rig, const CameraPath& target,
              const std::map<std::string, double>& sizes, const sim::Timeline& timeline);

    void check_frame(const render::CameraState& camera, Progress progress, double scene_time);

    /// Adds a warning for each object that is outside of the picture in more than half of the
    /// frames that it should be in.
    void report(const AddViewWarning& add) const;

  private:
    struct Frames {
        std::int64_t all = 0;
        std::int64_t without = 0;  // the object in the picture
    };

    void count(Frames& frames, const std::string& object, const render::CameraState& camera,
               double scene_time) const;

    const CameraRig& rig_;
    const std::map<std::string, double>& sizes_;
    const sim::Timeline& timeline_;
    std::string aim_;  // object; empty: none
    Frames aimed_;
    std::map<std::string, Frames> focused_;
};

}  // namespace carom::pipeline
