// The standard normal distribution.
#pragma once

namespace carom {

/// The number below which a standard normal variable is with probability `p`, in (0, 1).
[[nodiscard]] double normal_quantile(double p);

}  // namespace carom
