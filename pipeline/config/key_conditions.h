// The conditions under which the keys of a map can be given together. They are checked when a shot
// is read, and decide which defaults are written.
#pragma once

#include "pipeline/config/map_spec.h"

namespace carom::pipeline::config {

/// Whether `map` could also give `key`, a key of `info` that it does not give yet.
[[nodiscard]] bool can_be_added(const MapInfo& info, const KeyInfo& key, const Node& map);

/// Reports keys of `map` that have no meaning there or are excluded, and missing keys that others
/// need.
void check_conditions(Reader& reader, const Node& map, const MapInfo& info);

}  // namespace carom::pipeline::config
