// Which keys of a map can be given beside which others: checked when a shot is read, and known when
// its defaults are written.
#pragma once

#include "pipeline/config/map_spec.h"

namespace carom::pipeline::config {

/// Whether `key` of `info`, which `map` does not give, could be added to what it gives.
[[nodiscard]] bool can_be_added(const MapInfo& info, const KeyInfo& key, const Node& map);

/// Reports keys of `map` that have no meaning there or are excluded, and the keys that those which
/// are given need.
void check_conditions(Reader& reader, const Node& map, const MapInfo& info);

}  // namespace carom::pipeline::config
