// Reads a Shot from YAML and reports all of its problems together.
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
    std::optional<Shot> shot;                  // empty if a problem is an error
    std::vector<Problem> problems;             // errors and warnings, sorted by file and place
    std::shared_ptr<const ShotSource> source;  // null if there is no shot
};

/// `overrides` are "render.samples=64" as given to --set, `quality` the name of a preset in
/// configs/quality ("draft", "preview", "final") or empty, `camera_file` a file whose cameras
/// replace those of the shot (gather.h) or empty, `root` the folder that must contain all files of
/// the shot (config_files.h) or empty. A file that cannot be read is a problem, not an exception.
/// Nothing is simulated, so loading takes only milliseconds. Several threads may load concurrently.
[[nodiscard]] LoadResult load_shot(const std::string& path,
                                   const std::vector<std::string>& overrides = {},
                                   const std::string& quality = {},
                                   const std::string& camera_file = {},
                                   const std::string& root = {});

/// Like load_shot for a text in memory (a bake's shot_text, a fuzzer's input). Relative paths are
/// relative to the folder of `origin`.
[[nodiscard]] LoadResult load_shot_text(const std::string& text, const std::string& origin,
                                        const std::vector<std::string>& overrides = {},
                                        const std::string& quality = {},
                                        const std::string& camera_file = {},
                                        const std::string& root = {});

}  // namespace carom::pipeline
