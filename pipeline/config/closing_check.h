// Finds quotes and brackets that are not closed where they must be. yaml-cpp would read on to the
// next quote or bracket, at any distance, or to the end of the text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace carom::pipeline::config {

struct ClosingProblem {
    std::size_t offset = 0;  // bytes, of the part to which the message refers
    std::size_t length = 1;  // bytes, of this part
    std::string message;
};

/// Finds the first of these problems in a YAML document: a quoted text that is never closed, or
/// that is followed by other text; a quoted text or a bracket that continues on a line which is not
/// indented more deeply than its key (YAML 1.2.2, production 74, s-flow-line-prefix), except that
/// such a line may begin with the closing bracket; a bracket that is closed by one of the other
/// kind.
[[nodiscard]] std::optional<ClosingProblem> find_closing_problem(std::string_view text);

}  // namespace carom::pipeline::config
