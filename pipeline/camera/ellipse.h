// An arc of an ellipse.
#pragma once

#include "pipeline/camera/curve.h"

namespace carom::pipeline {

/// cos(angle) a + sin(angle) b around the origin. The angle is linear in the parameter, also beyond
/// the ends.
class EllipseCurve : public Curve {
  public:
    EllipseCurve(const Vec3& a, const Vec3& b, double start_angle, double end_angle)
        : a_(a), b_(b), start_(start_angle), end_(end_angle) {}

    [[nodiscard]] Vec3 position(Progress parameter) const override;
    [[nodiscard]] Vec3 derivative(Progress parameter) const override;

  private:
    Vec3 a_;
    Vec3 b_;
    double start_;
    double end_;
};

}  // namespace carom::pipeline
