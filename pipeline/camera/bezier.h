// Bezier curves of any degree, evaluated by de Casteljau's algorithm.
#pragma once

#include <span>
#include <vector>

#include "pipeline/camera/curve.h"

namespace carom::pipeline {

/// A curve over [0, 1] from its first to its last control point. It is numerically stable at high
/// degrees: inside [0, 1] every step averages points, so the rounding error is at most the degree
/// times that of one average.
class BezierCurve : public Curve {
  public:
    /// Throws Error without points.
    explicit BezierCurve(std::vector<Vec3> points);

    [[nodiscard]] std::span<const Vec3> points() const { return points_; }

    /// A point of the curve inside [0, 1], and of the tangent at the end outside.
    [[nodiscard]] Vec3 position(Progress parameter) const override;

    /// d position / d parameter, `parameter` in [0, 1].
    [[nodiscard]] Vec3 derivative(Progress parameter) const override;

    [[nodiscard]] BezierCurve reversed() const;

  private:
    std::vector<Vec3> points_;
};

}  // namespace carom::pipeline
