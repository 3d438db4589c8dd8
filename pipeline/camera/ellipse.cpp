#include "pipeline/camera/ellipse.h"

#include "core/elementary.h"

namespace carom::pipeline {

Vec3 EllipseCurve::position(Progress parameter) const {
    const double angle = mix(start_, end_, parameter);
    return a_ * cosine(angle) + b_ * sine(angle);
}

Vec3 EllipseCurve::derivative(Progress parameter) const {
    const double angle = mix(start_, end_, parameter);
    return (b_ * cosine(angle) - a_ * sine(angle)) * (end_ - start_);
}

}  // namespace carom::pipeline
