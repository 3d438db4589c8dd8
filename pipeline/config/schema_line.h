// The first line of a shot that tells editors where its schema is.
#pragma once

#include <string>
#include <string_view>

namespace carom::pipeline::config {

/// The text with that line, instead of one that it has. `folder` is that of the shot. A schema
/// below its parent, as in carom's source tree, is named relative to it; else the line names the
/// file that `carom schema -o carom.schema.json` writes beside the shot. It is never an absolute
/// path, which would mean nothing on another machine.
[[nodiscard]] std::string with_schema_line(std::string text, const std::string& folder);

/// Whether the text has such a line.
[[nodiscard]] bool has_schema_line(std::string_view text);

}  // namespace carom::pipeline::config
