// The programs behind bin/carom, in libexec/carom.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace carom::cli {

/// The path of "carom-film", found from where the running program is.
[[nodiscard]] std::string helper_program(const std::string& name);

/// "carom: error: cannot start the renderer ..." without its beginning: for an errno.
[[nodiscard]] std::string cannot_start(const std::string& what, const std::string& path,
                                       int reason);

/// Runs it to its end with `input` as its standard input and returns its standard output; what it
/// complains of goes to ours. Throws Error if it cannot be started or fails.
[[nodiscard]] std::vector<std::byte> run_helper(const std::string& name, const std::string& what,
                                                const std::string& argument,
                                                std::span<const std::byte> input);

}  // namespace carom::cli
