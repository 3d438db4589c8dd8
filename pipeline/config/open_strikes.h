// Strikes some of whose values are found by `solve`.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/config/node.h"

namespace carom::pipeline::config {

/// A strike of a `solve`, and which of its values are found.
struct OpenStrike {
    std::size_t event = 0;  // in `events`
    bool finds_direction = false;
    bool finds_speed = false;
    bool finds_tip = false;
    bool finds_elevation = false;  // where a ball is to be cleared
    bool may_raise = false;        // the elevation is found if no level strike does it
};

/// The strikes of the tree's `solve`, in its order. Those of their values that are not given and
/// are needed get one that the search replaces. Leaves what is wrong to the sections' readers.
[[nodiscard]] std::vector<OpenStrike> open_strikes(Node& root);

/// What was found for a strike: keys and values as texts of the format.
struct FoundStrike {
    std::size_t event = 0;
    std::vector<std::pair<std::string, std::string>> values;
};

/// Gives the strikes of the tree what was found, and removes `solve`.
void write_found(Node& root, const std::vector<FoundStrike>& found);

/// The text of the shot's own file likewise; all else stays as it is. `root`: the tree. Throws
/// Error if a strike or `solve` stands in another file.
[[nodiscard]] std::string text_with_found(const std::string& text, const Node& root,
                                          const std::vector<FoundStrike>& found);

}  // namespace carom::pipeline::config
