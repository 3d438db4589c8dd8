// From YAML to a Shot, with every problem at once.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/config/problem.h"
#include "pipeline/shot/shot.h"

namespace carom::pipeline {

class ShotSource;  // pipeline/config/shot_source.h

struct LoadResult {
    std::optional<Shot> shot;                  // set unless a problem is an error
    std::vector<Problem> problems;             // errors and warnings, by file and place
    std::shared_ptr<const ShotSource> source;  // with the shot
};

/// `overrides` are "render.samples=64" as given to --set, `quality` the name of a preset in
/// configs/quality ("draft", "preview", "final") or empty, `camera_file` a file whose cameras take
/// the place of the shot's (gather.h) or empty, `root` the folder that holds whatever the shot
/// names (config_files.h) or empty. A file that cannot be read is a problem, not an exception.
/// Nothing is simulated, which takes milliseconds. Any number of threads may load at the same time.
[[nodiscard]] LoadResult load_shot(const std::string& path,
                                   const std::vector<std::string>& overrides = {},
                                   const std::string& quality = {},
                                   const std::string& camera_file = {},
                                   const std::string& root = {});

/// The same for a text in memory (a bake's shot_text, a fuzzer's input). Relative paths are below
/// the folder of `origin`.
[[nodiscard]] LoadResult load_shot_text(const std::string& text, const std::string& origin,
                                        const std::vector<std::string>& overrides = {},
                                        const std::string& quality = {},
                                        const std::string& camera_file = {},
                                        const std::string& root = {});

}  // namespace carom::pipeline
