#include "pipeline/camera/ellipse.h"

#include <cmath>

namespace carom::pipeline {

Vec3 EllipseCurve::position(Progress parameter) const {
    const double angle = mix(start_, end_, parameter);
    return a_ * std::cos(angle) + b_ * std::sin(angle);
}

Vec3 EllipseCurve::derivative(Progress parameter) const {
    const double angle = mix(start_, end_, parameter);
    return (b_ * std::cos(angle) - a_ * std::sin(angle)) * (end_ - start_);
}

}  // namespace carom::pipeline
