// Where the studio writes films and documents.
#pragma once

#include <string>

namespace carom::studio {

/// The absolute path of a file to write: `given` in `folder` (if that is empty, in the shot's), or
/// named after the shot; with `extension` if it has none. Throws Error if it is neither below that
/// folder nor below `root`.
[[nodiscard]] std::string output_path(const std::string& given, const std::string& shot,
                                      const std::string& folder, const std::string& root,
                                      const std::string& extension);

}  // namespace carom::studio
