// Finds the place of a key in the tree of a shot.
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
/// as far as the tree has them.
[[nodiscard]] FoundPlace find_place(const Node& root, const std::vector<std::string>& path);

/// The path to which a diagnostic refers; empty if it refers to the whole shot.
[[nodiscard]] std::vector<std::string> path_of(const Diagnostic& diagnostic, const Node& root);

}  // namespace carom::pipeline::config
