// Fits a Bezier curve to an object's path.
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
    std::vector<Vec3> points;  // control points; the curve's parameter is the fraction of the time
    double error = 0;          // m, largest distance from the object at the same time
};

/// Fits the track's path over [from, to] (`to` may come first) by least squares, with both ends
/// fixed. The reversed interval gives the same points in reverse, bit for bit.
[[nodiscard]] PathFit fit_path(const sim::Track& track, double from, double to);

/// The result of the fit of a rig's path along an object.
struct FittedPath {
    std::string rig;
    std::string object;
    bool is_target = false;
    int degree = 0;
    double error = 0;  // m
};

/// Replaces each AlongPath of the rigs by its fitted Bezier path, so that it is fitted once and not
/// for every frame. `fitted`, if given, receives one entry for each of them. Fills in the rigs'
/// up_turns where they are not known (keep_up). Throws Error, with the rig's name, if the object is
/// not in the timeline.
[[nodiscard]] std::vector<CameraRig> with_fitted_paths(std::span<const CameraRig> rigs,
                                                       const sim::Timeline& timeline,
                                                       std::vector<FittedPath>* fitted = nullptr);

/// The Bezier path that is fitted to `path`; `fit`, if given, receives the fit.
[[nodiscard]] BezierPath fit_bezier_path(const AlongPath& path, const sim::Timeline& timeline,
                                         PathFit* fit = nullptr);

}  // namespace carom::pipeline
