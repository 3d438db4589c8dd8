// A track as keys for programs that go straight from key to key.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/timeline/track.h"

namespace carom::pipeline {

/// How far the straight way may be from the track, and how far a key may turn from the one before.
struct LinearTolerance {
    double position = 5e-5;     // m
    double orientation = 2e-3;  // rad
    /// rad: so far programs that mix the components of quaternions (Blender) instead of going at
    /// constant speed are wrong by 1.4 mrad at most.
    double turn = 0.7;
};

/// Positions to be joined by straight lines, orientations by the shorter arc at constant speed
/// (slerp). All lists have the same length, times strictly increase, neighbouring quaternions lie
/// in one hemisphere.
struct LinearKeys {
    std::vector<double> times;  // scene time, s
    std::vector<Vec3> positions;
    std::vector<Quat> orientations;

    [[nodiscard]] std::size_t size() const { return times.size(); }
    /// Whether nothing of it ever changes.
    [[nodiscard]] bool is_still() const;
    void add(double time, const Vec3& position, Quat orientation);
};

/// Every key of the track is one, so that what happened in an instant keeps its corner; between
/// them there are as many as the tolerance asks for. Throws Error if that is more than `most`.
[[nodiscard]] LinearKeys linear_keys(const sim::Track& track, std::size_t most,
                                         const LinearTolerance& tolerance = {});

}  // namespace carom::pipeline
