// The default folder of the cache for bakes and frames.
#pragma once

#include <string>

namespace carom::pipeline {

/// $CAROM_CACHE, else $XDG_CACHE_HOME/carom, else ~/.cache/carom. Throws Error if none is set.
[[nodiscard]] std::string default_cache_folder();

}  // namespace carom::pipeline
