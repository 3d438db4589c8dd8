// Makes untrusted text safe for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// `text` with '?' for each control character (of ASCII, and U+0080 to U+009F of Unicode), which
/// could move the cursor, hide text or control the terminal. Tabs are kept. Line breaks are
/// replaced too, so that the name of a file cannot imitate a message.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace carom
