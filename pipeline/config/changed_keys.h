// In what two shots differ.
#pragma once

#include <string>
#include <vector>

namespace carom::pipeline {

/// Paths of the keys in which the physics of two resolved shots differ ("events[0].strike.speed"),
/// in the order of the second. Where a list got longer or shorter it is named as a whole. Texts
/// that cannot be read have no keys.
[[nodiscard]] std::vector<std::string> changed_physics_keys(const std::string& before,
                                                            const std::string& after);

}  // namespace carom::pipeline
