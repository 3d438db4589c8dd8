// Where something stands in the tree of a shot.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.h"
#include "pipeline/config/node.h"

namespace carom::pipeline::config {

struct FoundPlace {
    Place place;
    std::string key_path;  // "events[0].strike.tip"
};

/// Follows the keys of a path ({"events", "0", "strike", "tip"}; elements of lists by their index)
/// for as long as the tree has them.
[[nodiscard]] FoundPlace find_place(const Node& root, const std::vector<std::string>& path);

/// The path of what a diagnostic is about; empty if it is about the shot as a whole.
[[nodiscard]] std::vector<std::string> path_of(const Diagnostic& diagnostic, const Node& root);

}  // namespace carom::pipeline::config
