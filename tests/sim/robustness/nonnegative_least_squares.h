// Least squares with unknowns that are not negative.
#pragma once

#include <vector>

namespace carom::sim::test {

/// The x >= 0 that minimises |A x - b| (Lawson and Hanson, Solving Least Squares Problems, 1974,
/// chapter 23). `columns`: those of A, each as long as `b`. Returns the residual b - A x.
[[nodiscard]] std::vector<double> nonnegative_residual(
    const std::vector<std::vector<double>>& columns, const std::vector<double>& b);

}  // namespace carom::sim::test
