// Files that arrive from other caches (pipeline/transfer).
//   CACHE/incoming/NAME/        what one command receives, until it is checked
//   CACHE/frames/ab/.KEY.*      what rsync writes when another machine copies into this cache
#pragma once

#include <string>

namespace carom::pipeline {

/// Makes a new folder for arriving files. The caller removes it. Throws CacheUnusable.
[[nodiscard]] std::string make_incoming_folder(const std::string& cache_folder);

/// Removes what killed commands have left of arriving files and nobody has changed for a day.
void remove_old_arrivals(const std::string& cache_folder);

}  // namespace carom::pipeline
