// The folder below which a shot's files are, where the user names none.
#pragma once

#include <string>

#include "pipeline/config/load_shot.h"

namespace carom::studio {

/// `folder`, or the nearest folder above it that also holds the files that the shot, and what it
/// includes, name outside of it ("../shared/cameras.yaml"). It is never the home folder, one above
/// that, one at the top of the file system ("/tmp"), or one of another user: a shot of somebody
/// else must not open those. `options.root` does not count.
[[nodiscard]] std::string shot_root(const std::string& shot, const std::string& folder,
                                    const pipeline::LoadOptions& options);

}  // namespace carom::studio
