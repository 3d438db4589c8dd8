// From YAML text to a tree of nodes with exact places; nothing about shots is known here.
#pragma once

#include <cstddef>
#include <optional>

#include "core/limits.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline::config {

/// What a text may ask for; more is refused with a sentence. Chosen far above any real shot and far
/// below what takes a noticeable time.
struct YamlLimits {
    std::size_t bytes = input_limit(4U << 20U);
    int depth = 64;                                      // nested maps and lists
    int nodes = static_cast<int>(input_limit(250'000));  // after aliases are put in
    int entries_per_map = static_cast<int>(input_limit(10'000));
};

/// Parses text `source` of `sources`. Anchors and aliases are resolved; duplicate keys, tags, keys
/// that are not words and several documents in one text are problems. After a syntax error (which
/// ends its text) the result is empty. An empty text is a null node.
[[nodiscard]] std::optional<Node> parse_yaml(const SourceSet& sources, int source,
                                             ProblemList& problems, const YamlLimits& limits = {},
                                             std::size_t skipped_bytes = 0);

}  // namespace carom::pipeline::config
