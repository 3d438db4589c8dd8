// The first line of a shot that tells editors where its schema is.
#pragma once

#include <string>
#include <string_view>

namespace carom::pipeline::config {

/// The text with that line for the installed schema, instead of one that it has. `folder` is that
/// of the shot; if it is absolute, a schema below its parent is named relative to it. Without an
/// installed schema, the text has no such line.
[[nodiscard]] std::string with_schema_line(std::string text, const std::string& folder);

/// Whether the text has such a line.
[[nodiscard]] bool has_schema_line(std::string_view text);

}  // namespace carom::pipeline::config
