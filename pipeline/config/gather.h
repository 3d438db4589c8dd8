// Merges a shot, the files that it includes, a quality preset and --set into one tree of YAML.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/config/config_files.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline::config {

/// The text of a shot whose file is `origin`, which need not exist.
[[nodiscard]] SourceText text_of_shot(std::string text, const std::string& origin);

struct GatherOptions {
    std::vector<std::string> own{};  // as overrides, but as if the shot's file gave the values
    std::vector<std::string> overrides{};  // "render.samples=64", highest precedence
    std::string quality{};                 // of the command line; empty: that of the shot
    std::string
        camera_file{};  // file whose cameras and look replace those of the shot; empty: none
};

struct Gathered {
    std::optional<Node> root;  // empty after a syntax error in the shot's own file
    bool is_complete = true;   // false if an included file is missing
};

/// Merges the text `root_source` with everything that it includes. The layers in the order of
/// ascending precedence: included files in their order, the preset that the shot's own `quality`
/// names, the shot's own keys, the preset of the command line (which replaces that of the shot),
/// the camera file with its includes, --set. A camera that includes a file is merged over the
/// camera of that file. A camera file has `cameras` and may change `render`, `output`, `lights` and
/// `materials`, so that an existing bake remains valid. A `render.size` with higher precedence
/// removes a `render.short_side`. The result has no keys `include` and `quality`.
[[nodiscard]] Gathered gather(SourceSet& sources, int root_source, const ConfigFolders& folders,
                              const GatherOptions& options, ProblemList& problems);

/// The file of that name in the config folders ("balls/pool.yaml"), merged over its includes; empty
/// if no folder has it, or after a problem. `named_at` is the place in the shot for which it is
/// read.
[[nodiscard]] std::optional<Node> read_config(SourceSet& sources, const std::string& name,
                                              const Place& named_at, const ConfigFolders& folders,
                                              ProblemList& problems);

}  // namespace carom::pipeline::config
