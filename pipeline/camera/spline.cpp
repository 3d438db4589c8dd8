#include "pipeline/camera/spline.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace carom::pipeline {

SplineCurve::SplineCurve(const std::vector<Vec3>& points) {
    for (const Vec3& point : points) {
        if (points_.empty() || points_.back() != point) {
            points_.push_back(point);
        }
    }
    if (points_.empty()) {
        throw Error("a spline has no points");
    }
    choose_knots();
    solve_second_derivatives();
}

// Lee, "Choosing nodes in parametric curve interpolation", Computer-Aided Design 21 (1989): the
// centripetal parameter, t[i+1] - t[i] proportional to |p[i+1] - p[i]|^(1/2).
void SplineCurve::choose_knots() {
    knots_.assign(points_.size(), 0);
    for (std::size_t i = 1; i < points_.size(); ++i) {
        knots_[i] = knots_[i - 1] + std::sqrt((points_[i] - points_[i - 1]).length());
    }
    const double whole = knots_.back();
    for (double& knot : knots_) {
        knot = whole > 0 ? knot / whole : 0;
    }
}

// The second derivatives m of the natural spline (de Boor, "A Practical Guide to Splines", 1978,
// chapter IV): with h[i] = t[i+1] - t[i] and d[i] = (p[i+1] - p[i]) / h[i],
//   h[i-1] m[i-1] + 2 (h[i-1] + h[i]) m[i] + h[i] m[i+1] = 6 (d[i] - d[i-1]),  m[0] = m[n] = 0,
// solved by Gaussian elimination without pivoting, because the matrix is diagonally dominant.
void SplineCurve::solve_second_derivatives() {
    const std::size_t count = points_.size();
    second_.assign(count, Vec3(0, 0, 0));
    if (count < 3) {
        return;
    }
    std::vector<double> upper(count, 0);
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double before = knots_[i] - knots_[i - 1];
        const double after = knots_[i + 1] - knots_[i];
        const Vec3 change =
            (points_[i + 1] - points_[i]) / after - (points_[i] - points_[i - 1]) / before;
        const double diagonal = 2 * (before + after) - before * upper[i - 1];
        upper[i] = after / diagonal;
        second_[i] = (change * 6 - second_[i - 1] * before) / diagonal;
    }
    for (std::size_t i = count - 2; i > 0; --i) {
        second_[i] -= second_[i + 1] * upper[i];
    }
}

SplineCurve::Location SplineCurve::locate(double parameter) const {
    const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, parameter);
    Location location;
    location.segment = static_cast<std::size_t>(after - knots_.begin()) - 1;
    const double start = knots_[location.segment];
    const double end = knots_[location.segment + 1];
    location.length = end - start;
    location.left = (end - parameter) / location.length;
    location.done = (parameter - start) / location.length;
    return location;
}

Vec3 SplineCurve::position(Progress parameter) const {
    if (points_.size() == 1) {
        return points_.front();
    }
    if (parameter.done < 0) {
        return points_.front() + derivative({0, 1}) * parameter.done;
    }
    if (parameter.left < 0) {
        return points_.back() - derivative({1, 0}) * parameter.left;
    }
    const Location at = locate(parameter.done);
    const double a = at.left;
    const double b = at.done;
    return points_[at.segment] * a + points_[at.segment + 1] * b +
           (second_[at.segment] * (a * a * a - a) + second_[at.segment + 1] * (b * b * b - b)) *
               (at.length * at.length / 6);
}

Vec3 SplineCurve::derivative(Progress parameter) const {
    if (points_.size() == 1) {
        return {0, 0, 0};
    }
    const Location at = locate(std::clamp(parameter.done, 0.0, 1.0));
    return (points_[at.segment + 1] - points_[at.segment]) / at.length +
           (second_[at.segment + 1] * (3 * at.done * at.done - 1) -
            second_[at.segment] * (3 * at.left * at.left - 1)) *
               (at.length / 6);
}

}  // namespace carom::pipeline
