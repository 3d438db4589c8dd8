// Where the values of a shot come from.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/load_shot.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

/// Whether the path lies below the folder; both are absolute, without links, "." and "..".
[[nodiscard]] bool is_below(const std::string& path, const std::string& folder);

/// Whether the file may be written: it lies below the root and is not one of carom's configs.
[[nodiscard]] bool is_writable(const std::string& path, const std::string& root);

/// The places of all values of the shot, in its order. `root`: the folder below which files are
/// written.
[[nodiscard]] std::vector<ValuePlace> value_places(const pipeline::ShotSource& source,
                                                   const std::string& root);

/// The problems with the paths of their files instead of their names.
[[nodiscard]] std::vector<Problem> problem_messages(const std::vector<pipeline::Problem>& problems,
                                                    const std::vector<pipeline::ReadFile>& files);

}  // namespace carom::studio
