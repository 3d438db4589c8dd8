// The cue stick that is seen to strike balls.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.h"
#include "pipeline/shot/stick_stroke.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::pipeline {

/// The name of its track, and the beginning of the names of its parts.
inline constexpr std::string_view kStickTrack = "stick/tip";
inline constexpr std::string_view kStickPrefix = "stick/";

/// The visible stick of a shot.
struct ShownStick {
    /// Indices of the world's events: the strikes at which it is seen. Empty: there is no stick.
    std::vector<std::size_t> events;
    double length = 1.47;          // m
    double tip_diameter = 0.0129;  // m
};

/// Diameters of the stick, m: of the shaft at the joint, and of the butt at its end.
inline constexpr double kStickJoint = 0.0215;
inline constexpr double kStickButt = 0.0295;

/// Adds the parts of the stick ("stick/shaft" ...), which follow the track of the stick. Their
/// materials are "stick_tip", "stick_ferrule", "stick_shaft", "stick_joint", "stick_butt",
/// "stick_wrap" and "stick_bumper".
void add_stick(render::SceneDescription& scene, const ShownStick& stick);

/// The strikes at which the stick is seen, in order of time: those of `stick.events` that the
/// timeline logs. A strike that follows another one so soon that the stick cannot be back is left
/// out.
[[nodiscard]] std::vector<StickStrike> shown_strikes(const ShownStick& stick,
                                                     const sim::WorldDescription& world,
                                                     const sim::Timeline& timeline);

/// The motion of the stick, without any strike far away.
[[nodiscard]] sim::Track stick_motion(const ShownStick& stick, const sim::WorldDescription& world,
                                      const sim::Timeline& timeline);

/// Warnings, each about its event: the stick touches the rail or a ball (with the least elevation
/// that clears it), or a strike is not shown.
[[nodiscard]] std::vector<Diagnostic> stick_problems(const ShownStick& stick,
                                                     const sim::WorldDescription& world,
                                                     const sim::Timeline& timeline);

}  // namespace carom::pipeline
