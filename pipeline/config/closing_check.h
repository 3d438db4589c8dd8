// Quotes and brackets that are not closed where they must be: yaml-cpp reads on to the next quote
// or bracket, however far away it is, and for a quote to the end of the text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace carom::pipeline::config {

struct ClosingProblem {
    std::size_t offset = 0;  // in bytes, of what the message is about
    std::size_t length = 1;  // of it, in bytes
    std::string message;
};

/// The first of these in a YAML document: a quoted text that is never closed, or is followed by
/// text which belongs to nothing; a quoted text or a bracket that runs over a line which is not
/// indented deeper than its key (YAML 1.2.2, production 74, s-flow-line-prefix), except that such a
/// line may begin with the closing bracket; a bracket that is closed by one of the other kind.
[[nodiscard]] std::optional<ClosingProblem> find_closing_problem(std::string_view text);

}  // namespace carom::pipeline::config
