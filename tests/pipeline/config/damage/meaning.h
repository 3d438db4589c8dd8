// What two shots say differently.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/load_shot.h"

namespace carom::testing {

struct Difference {
    std::string path;    // of keys: "render.samples"
    std::string before;  // a scalar's text; empty if there is none, or it is none
    std::string after;
    bool is_scalar = false;   // a scalar became another scalar
    bool is_renamed = false;  // a key with the same value became another key: `before` and `after`
};

/// Everything in which the trees of two loaded shots differ, numbers compared by value: "9 ft" is
/// "2.7432 m". Without a difference in the trees, one more where the shots made of them differ.
[[nodiscard]] std::vector<Difference> differences(const pipeline::LoadResult& before,
                                                  const pipeline::LoadResult& after);

}  // namespace carom::testing
