// What may stand in a --set, from the table of keys: for the completion in shells.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/node.h"

namespace carom::pipeline::config {

/// One way to go on, as the whole text: "render.samples=", "render.", "render.denoise=true".
struct KeyCandidate {
    std::string text;
    std::string description;
};

/// Every way to go on with `start`, the beginning of a --set, by one more key or by a value. Names
/// of balls, objects, materials, lights and cameras are those of `shot`; of an empty tree none.
[[nodiscard]] std::vector<KeyCandidate> complete_override(std::string_view start, const Node& shot);

/// The tree of a shot with what it includes, and with the balls of its rack among its `balls`.
/// Problems are not reported; after a syntax error the tree is empty.
[[nodiscard]] Node readable_tree(const std::string& text, const std::string& origin);

/// The names of the shot's cameras that have one.
[[nodiscard]] std::vector<std::string> camera_names(const Node& shot);

}  // namespace carom::pipeline::config
