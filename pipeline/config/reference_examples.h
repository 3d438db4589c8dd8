// The examples of the sections of docs/reference.md.
#pragma once

#include <map>
#include <string>

namespace carom::pipeline::config {

/// YAML that uses a section, by the section's name (MapInfo::name). With `carom: 1` before it, each
/// example is a whole shot without errors; a test loads them all.
[[nodiscard]] const std::map<std::string, std::string>& reference_examples();

}  // namespace carom::pipeline::config
