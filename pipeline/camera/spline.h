// The smooth curve through points.
#pragma once

#include <vector>

#include "pipeline/camera/curve.h"

namespace carom::pipeline {

/// The natural cubic spline: position, velocity and acceleration change without a jump along the
/// parameter, and the acceleration is zero at both ends. The parameter from one point to the next
/// grows with the root of their distance, so that the curve neither loops nor races where points
/// lie close together.
class SplineCurve : public Curve {
  public:
    /// At least one point, else throws Error. Neighbours in the same place count once.
    explicit SplineCurve(const std::vector<Vec3>& points);

    [[nodiscard]] int segments() const { return static_cast<int>(knots_.size()) - 1; }

    /// Beyond the ends the tangent.
    [[nodiscard]] Vec3 position(Progress parameter) const override;
    [[nodiscard]] Vec3 derivative(Progress parameter) const override;

  private:
    // Where a parameter lies within its segment.
    struct Place {
        std::size_t segment = 0;
        double length = 1;  // of the segment in the parameter
        double left = 1;    // share of it that is ahead
        double done = 0;    // and behind
    };
    [[nodiscard]] Place find(double parameter) const;
    void choose_knots();
    void solve();

    std::vector<Vec3> points_;
    std::vector<double> knots_;  // parameters of the points, 0 to 1
    std::vector<Vec3> second_;   // second derivatives at the points
};

}  // namespace carom::pipeline
