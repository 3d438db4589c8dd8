// The default folder of the cache for bakes and frames.
#pragma once

#include <string>

#include "core/error.h"

namespace carom::pipeline {

/// The cache cannot be created, written to or filled further.
class CacheUnusable : public Error {
  public:
    using Error::Error;
};

/// $CAROM_CACHE, else $XDG_CACHE_HOME/carom, else ~/.cache/carom. Throws CacheUnusable if none is
/// set.
[[nodiscard]] std::string default_cache_folder();

/// `given` if it is not empty, else the default, or a folder that cannot exist if there is none:
/// for jobs that only look whether the cache has something.
[[nodiscard]] std::string readable_cache_folder(const std::string& given);

}  // namespace carom::pipeline
