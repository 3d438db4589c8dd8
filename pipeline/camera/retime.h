// The same film at another speed: slower, backwards, a part of it, a ramp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/camera/camera_rig.h"

namespace carom::pipeline {

struct RetimeOptions {
    std::optional<Rational> speed;  // > 0, scene seconds per second of film; empty: as it was
    std::optional<Rational> from;   // scene times; empty: all that the film shows
    std::optional<Rational> to;
    bool reverse = false;
    std::vector<SpeedKey> ramp;  // instead of `speed` and `to`; film times from 0 on
    bool gentle = true;          // how the ramp gets from one speed to the next
    std::string rig;             // only this one; empty: the film as it is cut
};

/// The rigs of the new film, from video time 0 on. Each goes the same way as before, or the part
/// of it on which it showed those scene times. A stretch of scene time is seen by the first rig of
/// the film that shows it, then by the next: forwards, whichever way that rig went. Rigs of frozen
/// time keep their length. A ramp is filmed by one rig, the first that shows its beginning.
/// Throws Error with a sentence where the film does not show what is asked for or the options
/// contradict each other.
[[nodiscard]] std::vector<CameraRig> retimed(std::span<const CameraRig> rigs,
                                             const RetimeOptions& options);

}  // namespace carom::pipeline
