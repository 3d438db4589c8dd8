// Generates docs/reference.md from the table of keys.
#pragma once

#include <string>

namespace carom::pipeline {

/// Every key of the format with its type, default and meaning, as Markdown.
[[nodiscard]] std::string reference_markdown();

}  // namespace carom::pipeline
