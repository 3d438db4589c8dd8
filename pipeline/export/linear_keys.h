// Converts a track to keys for programs that interpolate linearly.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sim/timeline/track.h"

namespace carom::pipeline {

/// The allowed deviation of linear interpolation from the track, and the largest turn between two
/// keys.
struct LinearTolerance {
    double position = 5e-5;     // m
    double orientation = 2e-3;  // rad
    /// rad. Up to this turn, programs that interpolate the components of quaternions linearly
    /// (Blender) instead of using slerp are wrong by at most 1.4 mrad.
    double turn = 0.7;
};

/// Keys between which positions are interpolated linearly and orientations along the shorter arc at
/// constant speed (slerp). All lists have the same length, times are strictly increasing, and
/// neighbouring quaternions are in the same hemisphere.
struct LinearKeys {
    std::vector<double> times;  // scene time, s
    std::vector<Vec3> positions;
    std::vector<Quat> orientations;
    std::vector<std::size_t> jumps;  // keys that lie a number after the previous one and elsewhere

    [[nodiscard]] bool jumps_to(std::size_t key) const {
        return std::find(jumps.begin(), jumps.end(), key) != jumps.end();
    }
    [[nodiscard]] std::size_t size() const { return times.size(); }
    /// Whether all keys have the same position and orientation.
    [[nodiscard]] bool is_constant() const;
    /// The keys from a time on. Unless one is there or all are later, the first is what programs
    /// interpolate for it.
    [[nodiscard]] LinearKeys from(double time) const;
    void add(double time, const Vec3& position, Quat orientation);
};

/// The keys of the track, which keep sudden changes of velocity sharp, and as many between them as
/// the tolerance requires. Throws Error if these are more than `most`.
[[nodiscard]] LinearKeys linear_keys(const sim::Track& track, std::size_t most,
                                     const LinearTolerance& tolerance = {});

}  // namespace carom::pipeline
