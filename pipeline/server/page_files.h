// Reads the files of a page into memory.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "pipeline/server/server.h"

namespace carom::server {

/// The media type for a file name, by its ending; "application/octet-stream" if it is not known.
[[nodiscard]] std::string media_type(std::string_view name);

/// All regular files below the folder, for ServerOptions::files: by "/" and their path in the
/// folder, and index.html also as "/". Throws Error if the folder or a file cannot be read.
[[nodiscard]] std::map<std::string, Resource> read_page_files(const std::string& folder);

}  // namespace carom::server
