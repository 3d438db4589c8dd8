// The cubic Hermite curve of a PathStretch (formulas: docs/timeline.md).
#pragma once

#include "sim/timeline/track.h"

namespace carom::sim {

/// Where the curve is at `time` within [start, end]; the ends are returned exactly.
[[nodiscard]] Vec3 hermite_position(const PathStretch& stretch, double time);

/// Its derivative, m/s; the ends are returned exactly.
[[nodiscard]] Vec3 hermite_velocity(const PathStretch& stretch, double time);

/// The part of the curve during [from, to], a subset of [start, end].
[[nodiscard]] PathStretch cut(const PathStretch& stretch, double from, double to);

/// A box around the curve during [from, to], a subset of [start, end]; wider by rounding only.
[[nodiscard]] Bounds bounds_of(const PathStretch& stretch, double from, double to);

}  // namespace carom::sim
