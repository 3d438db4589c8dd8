// The cubic Hermite curve of a PathSegment (formulas: docs/timeline.md).
#pragma once

#include "sim/timeline/track.h"

namespace carom::sim {

/// Where the curve is at `time` within [start, end]; the ends are returned exactly.
[[nodiscard]] Vec3 hermite_position(const PathSegment& segment, double time);

/// Its derivative, m/s; the ends are returned exactly.
[[nodiscard]] Vec3 hermite_velocity(const PathSegment& segment, double time);

/// The part of the curve during [from, to], a subset of [start, end].
[[nodiscard]] PathSegment cut(const PathSegment& segment, double from, double to);

/// A box around the curve during [from, to], a subset of [start, end]; wider by rounding only.
[[nodiscard]] Bounds bounds_of(const PathSegment& segment, double from, double to);

}  // namespace carom::sim
