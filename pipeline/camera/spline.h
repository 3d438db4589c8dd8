// A smooth curve through given points.
#pragma once

#include <vector>

#include "pipeline/camera/curve.h"

namespace carom::pipeline {

/// The natural cubic spline: position and first and second derivative are continuous, and the
/// second derivative is zero at both ends. The parameter between two points is proportional to the
/// square root of their distance (centripetal parametrisation), so that the curve has no loops and
/// no peaks of speed where points are close together.
class SplineCurve : public Curve {
  public:
    /// Throws Error without points. Equal neighbouring points count once.
    explicit SplineCurve(const std::vector<Vec3>& points);

    [[nodiscard]] int segments() const { return static_cast<int>(knots_.size()) - 1; }

    /// Beyond the ends the position is on the tangent.
    [[nodiscard]] Vec3 position(Progress parameter) const override;
    [[nodiscard]] Vec3 derivative(Progress parameter) const override;

  private:
    // The location of a parameter within its segment.
    struct Location {
        std::size_t segment = 0;
        double length = 1;  // of the segment, in the parameter
        double left = 1;    // fraction of the segment after the parameter
        double done = 0;    // fraction before it
    };
    [[nodiscard]] Location locate(double parameter) const;
    void choose_knots();
    void solve_second_derivatives();

    std::vector<Vec3> points_;
    std::vector<double> knots_;  // parameters of the points, 0 to 1
    std::vector<Vec3> second_;   // second derivatives at the points
};

}  // namespace carom::pipeline
