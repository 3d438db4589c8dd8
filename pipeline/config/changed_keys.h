// Finds the differences between two shots.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom::pipeline {

/// Paths of the keys in which the physics of two resolved shots differ ("events[0].strike.speed"),
/// in the order of the second shot. A list whose length differs is named as a whole. A text that
/// cannot be read has no keys.
[[nodiscard]] std::vector<std::string> changed_physics_keys(const std::string& before,
                                                            const std::string& after);

/// Whether the section ("events") affects the simulation.
[[nodiscard]] bool is_physics_section(std::string_view section);

}  // namespace carom::pipeline
