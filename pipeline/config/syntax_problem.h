// Translates syntax errors of yaml-cpp into clear messages.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/config/node.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

struct SyntaxProblem {
    Place place;
    std::string message;
};

/// `message` is that of yaml-cpp, at the byte `offset` of the text; `innermost` is the container
/// that was open there, or nullptr.
[[nodiscard]] SyntaxProblem describe_syntax_error(const SourceSet& sources, int source,
                                                  std::size_t offset, std::string_view message,
                                                  const Node* innermost);

}  // namespace carom::pipeline::config
