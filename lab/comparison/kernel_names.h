// Names of triangle kernels and their variants in options and in output.
#pragma once

#include <string>
#include <vector>

#include "lab/triangle/variant.h"

namespace carom::pipeline {

/// "all", or a comma-separated list of names without repetition. Throws Error that names the
/// mistake and lists the names.
[[nodiscard]] std::vector<render::triangle::KernelName> kernels_from_text(const std::string& text);

/// Likewise; empty for an empty text. "all": every one but "plain", which is no name here.
[[nodiscard]] std::vector<render::triangle::Technique> techniques_from_text(
    const std::string& text);

}  // namespace carom::pipeline
