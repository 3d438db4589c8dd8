// Changes the speed of a film: slower, backwards, only an interval, or a speed ramp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/camera/camera_rig.h"

namespace carom::pipeline {

struct RetimeOptions {
    std::optional<Rational> speed;  // > 0, scene seconds per second of film; empty: unchanged
    std::optional<Rational> from;   // scene times; empty: everything that the film shows
    std::optional<Rational> to;
    bool reverse = false;
    std::vector<SpeedKey> ramp;  // instead of `speed` and `to`; film times from 0 on
    bool is_smooth = true;       // the ramp's speed changes by the smooth step, else linearly
    std::string rig;             // only this one; empty: all rigs
};

/// The rigs of the new film, which starts at video time 0. Each rig keeps its path, or the part of
/// it on which it showed the chosen scene times. An interval of scene time is filmed by the first
/// rig that shows its start, then by the next, always forwards, whatever the direction of that rig
/// was. Rigs of frozen time keep their duration. A ramp is filmed by one rig, the first that shows
/// its start. Throws Error if the film does not show the chosen scene times or the options
/// contradict each other.
[[nodiscard]] std::vector<CameraRig> retime_rigs(std::span<const CameraRig> rigs,
                                                 const RetimeOptions& options);

}  // namespace carom::pipeline
