// The differences between two shots.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/load_shot.h"

namespace carom::testing {

struct Difference {
    std::string path;    // of keys: "render.samples"
    std::string before;  // a scalar's text; empty if there is no scalar
    std::string after;
    bool is_scalar = false;   // a scalar became another scalar
    bool is_renamed = false;  // a key was renamed from `before` to `after`, with the same value
};

/// All differences between the trees of two loaded shots. Numbers are compared by value: "9 ft"
/// equals "2.7432 m". If the trees are equal, a difference between the shots is also reported.
[[nodiscard]] std::vector<Difference> differences(const pipeline::LoadResult& before,
                                                  const pipeline::LoadResult& after);

}  // namespace carom::testing
