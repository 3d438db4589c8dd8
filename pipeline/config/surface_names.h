// The parts of a table that objects touch.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom::pipeline::config {

/// Names of surfaces that are not objects of the shot: "cushion", "cloth" ...
[[nodiscard]] const std::vector<std::string>& surface_names();

[[nodiscard]] bool is_surface(std::string_view name);

}  // namespace carom::pipeline::config
