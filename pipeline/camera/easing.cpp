#include "pipeline/camera/easing.h"

#include <cmath>

namespace carom::pipeline {
namespace {

// One coordinate of the cubic Bezier curve 0, a, b, 1 at parameter s.
double coordinate(double a, double b, double s) {
    const double r = 1 - s;
    return 3 * r * r * s * a + 3 * r * s * s * b + s * s * s;
}

// The time x(s) never decreases, so bisection finds its parameter. 60 bisections exhaust a double.
double parameter_at(double time, const Easing& easing) {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (coordinate(easing.x1, easing.x2, middle) < time ? low : high) = middle;
    }
    return (low + high) / 2;
}

// dy/dx of the line from an end to the first control point that differs from it.
double slope(double dx, double dy) {
    return dx > 0 ? dy / dx : 0;
}

double end_slope(double x1, double y1, double x2, double y2) {
    if (x1 != 0 || y1 != 0) {
        return slope(x1, y1);
    }
    return x2 != 0 || y2 != 0 ? slope(x2, y2) : 1;
}

Progress ease_bezier(Progress progress, const Easing& easing) {
    if (progress.done <= 0) {
        const double y = progress.done * end_slope(easing.x1, easing.y1, easing.x2, easing.y2);
        return {y, 1 - y};
    }
    if (progress.left <= 0) {
        const double left =
            progress.left * end_slope(1 - easing.x2, 1 - easing.y2, 1 - easing.x1, 1 - easing.y1);
        return {1 - left, left};
    }
    const double y = coordinate(easing.y1, easing.y2, parameter_at(progress.done, easing));
    return {y, 1 - y};
}

}  // namespace

Progress ease(Progress progress, const Easing& easing) {
    if (easing.kind == Easing::linear) {
        return progress;
    }
    if (easing.kind == Easing::bezier) {
        return ease_bezier(progress, easing);
    }
    if (progress.done <= 0) {
        return {0, 1};
    }
    if (progress.left <= 0) {
        return {1, 0};
    }
    // The cubic Hermite step 3 u^2 - 2 u^3 = u^2 (1 + 2 (1 - u)), written symmetrically in both
    // ends.
    return {progress.done * progress.done * (1 + 2 * progress.left),
            progress.left * progress.left * (1 + 2 * progress.done)};
}

}  // namespace carom::pipeline
