// Parses YAML text into a tree of nodes with exact places, independently of the format of shots.
#pragma once

#include <cstddef>
#include <optional>

#include "core/limits.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline::config {

/// Limits of a text; a text that exceeds one is a problem. They are far above any real shot and far
/// below sizes that take a noticeable time.
struct YamlLimits {
    std::size_t bytes = input_limit(4U << 20U);
    int depth = 64;                                      // nested maps and lists
    int nodes = static_cast<int>(input_limit(250'000));  // after alias expansion
    int entries_per_map = static_cast<int>(input_limit(10'000));
};

/// Parses the text `source` of `sources`. Anchors and aliases are resolved; duplicate keys, tags,
/// keys that are not words and several documents in one text are problems. After a syntax error the
/// result is empty. An empty text is a null node.
[[nodiscard]] std::optional<Node> parse_yaml(const SourceSet& sources, int source,
                                             ProblemList& problems, const YamlLimits& limits = {},
                                             std::size_t skipped_bytes = 0);

}  // namespace carom::pipeline::config
