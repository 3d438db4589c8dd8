// The cubic Hermite curve of a PathSegment (formulas: docs/timeline.md).
#pragma once

#include "sim/timeline/track.h"

namespace carom::sim {

/// The point of the curve at `time` within [start, end]; the ends are returned exactly.
[[nodiscard]] Vec3 hermite_position(const PathSegment& segment, double time);

/// Its derivative, m/s; the ends are returned exactly.
[[nodiscard]] Vec3 hermite_velocity(const PathSegment& segment, double time);

/// The part of the curve during [from, to], a subset of [start, end].
[[nodiscard]] PathSegment cut(const PathSegment& segment, double from, double to);

/// The bounding box of the curve during [from, to], a subset of [start, end], enlarged only by
/// rounding.
[[nodiscard]] Bounds bounds_of(const PathSegment& segment, double from, double to);

}  // namespace carom::sim
