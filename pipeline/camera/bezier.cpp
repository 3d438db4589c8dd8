#include "pipeline/camera/bezier.h"

#include <utility>

#include "core/error.h"

namespace carom::pipeline {
namespace {

// P. de Faget de Casteljau's algorithm (Farin, "Curves and Surfaces for CAGD", 5th ed. 2002,
// section 4.2): neighbouring points are interpolated until one point is left.
Vec3 de_casteljau(std::vector<Vec3> points, Progress parameter) {
    for (std::size_t count = points.size(); count > 1; --count) {
        for (std::size_t i = 0; i + 1 < count; ++i) {
            points[i] = mix(points[i], points[i + 1], parameter);
        }
    }
    return points.front();
}

}  // namespace

BezierCurve::BezierCurve(std::vector<Vec3> points) : points_(std::move(points)) {
    if (points_.empty()) {
        throw Error("a Bezier path has no control points");
    }
}

Vec3 BezierCurve::position(Progress parameter) const {
    if (parameter.done < 0) {
        return points_.front() + derivative({0, 1}) * parameter.done;
    }
    if (parameter.left < 0) {
        return points_.back() - derivative({1, 0}) * parameter.left;
    }
    return de_casteljau(points_, parameter);
}

Vec3 BezierCurve::derivative(Progress parameter) const {
    if (points_.size() == 1) {
        return {0, 0, 0};
    }
    std::vector<Vec3> differences(points_.size() - 1);
    for (std::size_t i = 0; i < differences.size(); ++i) {
        differences[i] = points_[i + 1] - points_[i];
    }
    const auto degree = static_cast<double>(differences.size());
    return de_casteljau(std::move(differences), parameter) * degree;
}

BezierCurve BezierCurve::reversed() const {
    return BezierCurve(std::vector<Vec3>(points_.rbegin(), points_.rend()));
}

}  // namespace carom::pipeline
