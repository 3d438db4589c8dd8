// One tree of YAML out of a shot, the files that it includes, a quality preset and --set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/config/config_files.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline::config {

struct GatherOptions {
    std::vector<std::string> overrides;  // "render.samples=64", the strongest
    std::string quality;                 // of the command line; empty: as the shot says
    std::string camera_file;             // whose cameras and look replace the shot's; empty: none
};

struct Gathered {
    std::optional<Node> root;  // empty after a syntax error in the shot's own file
    bool is_whole = true;      // false: something that it includes is missing
};

/// Text `root_source` with all that it includes. From the weakest to the strongest: included files
/// in their order, the preset that the shot's own `quality` names, the shot's own keys, the preset
/// of the command line (which takes the place of the shot's), the camera file with what it
/// includes, --set. A camera that includes a file is laid over the one that this has. A camera file
/// says `cameras` and at most changes `render`, `output`, `lights` and `materials`, so that a bake
/// still fits. A `render.size` that is stronger than a `render.short_side` removes it. The keys
/// `include` and `quality` are used up.
[[nodiscard]] Gathered gather(SourceSet& sources, int root_source, const ConfigFolders& folders,
                              const GatherOptions& options, ProblemList& problems);

}  // namespace carom::pipeline::config
