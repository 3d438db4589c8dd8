// Interface of parametric curves.
#pragma once

#include "core/vectors.h"
#include "pipeline/camera/progress.h"

namespace carom::pipeline {

class Curve {
  public:
    Curve() = default;
    Curve(const Curve&) = default;
    Curve(Curve&&) = default;
    Curve& operator=(const Curve&) = default;
    Curve& operator=(Curve&&) = default;
    virtual ~Curve() = default;

    /// Each curve defines how it continues beyond its ends.
    [[nodiscard]] virtual Vec3 position(Progress parameter) const = 0;

    /// d position / d parameter, `parameter` in [0, 1].
    [[nodiscard]] virtual Vec3 derivative(Progress parameter) const = 0;
};

}  // namespace carom::pipeline
