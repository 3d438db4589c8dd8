// Where the values of a shot come from.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/load_shot.h"
#include "pipeline/config/node.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/config/source_set.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

/// The places of all values of the shot, in its order. `root`: the folder below which files are
/// written.
[[nodiscard]] std::vector<ValuePlace> value_places(const pipeline::ShotSource& source,
                                                   const std::string& root);

/// The same of a text that is merged with no other.
[[nodiscard]] std::vector<ValuePlace> value_places(const pipeline::config::SourceSet& sources,
                                                   const pipeline::config::Node& top,
                                                   const std::string& root);

/// The problems with the paths of their files instead of their names.
[[nodiscard]] std::vector<Problem> problem_messages(const std::vector<pipeline::Problem>& problems,
                                                    const std::vector<pipeline::ReadFile>& files);

}  // namespace carom::studio
