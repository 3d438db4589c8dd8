// The example of each section of docs/reference.md.
#pragma once

#include <map>
#include <string>

namespace carom::pipeline::config {

/// By the section's name (MapInfo::name): YAML that uses the section. With `carom: 1` before it
/// each one is a whole shot without errors; a test loads them all.
[[nodiscard]] const std::map<std::string, std::string>& reference_examples();

}  // namespace carom::pipeline::config
