// What can be walked along.
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

    /// Beyond the ends the curve goes on in its own way.
    [[nodiscard]] virtual Vec3 position(Progress parameter) const = 0;

    /// d position / d parameter, `parameter` in [0, 1].
    [[nodiscard]] virtual Vec3 derivative(Progress parameter) const = 0;
};

}  // namespace carom::pipeline
