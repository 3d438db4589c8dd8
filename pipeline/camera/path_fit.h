// A Bezier curve along what an object did.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The fit stops at the lowest degree that is this close to the path everywhere, m, ...
inline constexpr double kFitError = 1e-3;
/// ... or at this one.
inline constexpr int kHighestFitDegree = 30;

struct PathFit {
    std::vector<Vec3> points;  // control points; the curve's parameter is the share of time
    double error = 0;          // m, largest distance from the object at the same time
};

/// The track's path over [from, to] (`to` may come first), least squares with both ends kept. The
/// same stretch backwards gives the same points backwards, bit for bit.
[[nodiscard]] PathFit fit_path(const sim::Track& track, double from, double to);

/// What became of a rig's path along an object.
struct FittedPath {
    std::string rig;
    std::string object;
    bool is_target = false;
    int degree = 0;
    double error = 0;  // m
};

/// The rigs with each AlongPath replaced by the Bezier path that it stands for, so that it is
/// fitted once and not for every frame. `fitted`, if given, gets one entry for each of them. Throws
/// Error naming the rig whose object is not in the timeline.
[[nodiscard]] std::vector<CameraRig> with_fitted_paths(std::span<const CameraRig> rigs,
                                                       const sim::Timeline& timeline,
                                                       std::vector<FittedPath>* fitted = nullptr);

/// The Bezier path that `path` stands for; `fit`, if given, is what it was made from.
[[nodiscard]] BezierPath fitted(const AlongPath& path, const sim::Timeline& timeline,
                                PathFit* fit = nullptr);

}  // namespace carom::pipeline
