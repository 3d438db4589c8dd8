// Text of others as a terminal may show it.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// `text` with '?' for each control character (ASCII's, and Unicode's U+0080 to U+009F): they could
/// move the cursor, hide text or speak to the terminal. Tabs stay; a line break does not, so that a
/// file's name cannot pretend to be a message of its own.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace carom
