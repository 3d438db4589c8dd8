// The keys of things that happen in a shot: conditions of events, and moments as times.
#pragma once

#include "pipeline/config/value_types.h"
#include "sim/event_time.h"

namespace carom::pipeline::config {

/// The condition of an event (`when`). The moment's delay is never negative.
[[nodiscard]] ValueType<sim::EventTime> condition();

/// A moment in the shot.
[[nodiscard]] ValueType<sim::EventTime> moment();

/// A scene time: a number, or a moment in the shot. A moment is read as the time at which it comes,
/// or as 0 s while the motion is not known (Reader::time_of).
[[nodiscard]] ValueType<double> scene_time();
[[nodiscard]] ValueType<Rational> exact_scene_time();

/// Whether the node is a map that describes a moment.
[[nodiscard]] bool is_moment(const Node& node);

}  // namespace carom::pipeline::config
