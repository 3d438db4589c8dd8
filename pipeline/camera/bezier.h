// Bezier curves of any degree by de Casteljau's algorithm.
#pragma once

#include <span>
#include <vector>

#include "pipeline/camera/curve.h"

namespace carom::pipeline {

/// A curve over [0, 1] through its first and last control point. Sound at high degrees: inside
/// [0, 1] every step averages points, so the rounding error stays below the degree times that of
/// one average.
class BezierCurve : public Curve {
  public:
    /// At least one point; throws Error otherwise.
    explicit BezierCurve(std::vector<Vec3> points);

    [[nodiscard]] std::span<const Vec3> points() const { return points_; }

    /// Inside [0, 1] the curve, beyond it the tangent of the end.
    [[nodiscard]] Vec3 position(Progress parameter) const override;

    /// d position / d parameter, `parameter` in [0, 1].
    [[nodiscard]] Vec3 derivative(Progress parameter) const override;

    [[nodiscard]] BezierCurve reversed() const;

  private:
    std::vector<Vec3> points_;
};

}  // namespace carom::pipeline
