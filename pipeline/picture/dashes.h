// Cuts lines into dashes.
#pragma once

#include <vector>

#include "pipeline/picture/annotation.h"

namespace carom::pipeline {

/// A point of a line with its opacity.
struct StrongPoint {
    Vec3 at{0, 0, 0};  // m
    double strength = 1;
};

using StrongLine = std::vector<StrongPoint>;  // at least one point; one: a dot

/// The dashes of a line, from its first point on. `scale`: of the usual lengths, dashes of 5 cm and
/// gaps of 3.5 cm. A solid line is one piece.
[[nodiscard]] std::vector<StrongLine> cut_into_dashes(const StrongLine& line, Dash dash,
                                                      double scale);

}  // namespace carom::pipeline
