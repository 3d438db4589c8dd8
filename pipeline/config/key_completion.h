// Shell completion of --set, from the table of keys.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/node.h"

namespace carom::pipeline::config {

/// One possible continuation, as the whole text: "render.samples=", "render.",
/// "render.denoise=true".
struct KeyCandidate {
    std::string text;
    std::string description;
};

/// All continuations of `start`, the beginning of a --set, by one more key or by a value. The names
/// of balls, objects, materials, lights and cameras are those of `shot`.
[[nodiscard]] std::vector<KeyCandidate> complete_override(std::string_view start, const Node& shot);

/// The tree of a shot with its includes, and with the balls of its rack among its `balls`. Problems
/// are not reported; after a syntax error the tree is empty.
[[nodiscard]] Node readable_tree(const std::string& text, const std::string& origin);

/// The names of the shot's named cameras.
[[nodiscard]] std::vector<std::string> camera_names(const Node& shot);

}  // namespace carom::pipeline::config
