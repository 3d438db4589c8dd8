// Finds frames in which a camera turns so fast that one sees two views at once or a jump.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/frame_range.h"
#include "pipeline/camera/view_axes.h"

namespace carom::pipeline {

/// From these angles on a turn is reported, rad: while the shutter is open, and from one frame to
/// the next.
inline constexpr double kTurnOfShutter = 0.5235987755982988;  // 30 degrees
inline constexpr double kTurnOfFrame = 1.0471975511965976;    // 60 degrees

/// Adds a warning about the camera: a key of it, and the sentence after its name.
using AddTurnWarning = std::function<void(const char* key, const std::string& sentence)>;

/// For one camera, whose frames are given in order. Frames that do not follow each other are not
/// compared.
class TurnCheck {
  public:
    /// `up`: the rig's up direction at that frame.
    void check_frame(const PlannedFrame& frame, const Vec3& up);

    void report(const FilmTiming& timing, const AddTurnWarning& add) const;

  private:
    struct Found {
        std::optional<FrameRange> frames;
        double angle = 0;  // rad, the largest
    };
    static void add(Found& found, double angle, std::int64_t first, std::int64_t last);

    std::optional<std::int64_t> before_;  // number of the frame before
    ViewAxes axes_before_;                // when its shutter opened
    Found in_shutter_, between_;
    std::optional<FrameRange> upside_down_;
};

}  // namespace carom::pipeline
