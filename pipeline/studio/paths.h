// Paths of the files of a session: where they are, and which of them may be written.
#pragma once

#include <filesystem>
#include <string>

namespace carom::studio {

/// The absolute path without links, "." and "..": where a file is written that is named so, also if
/// it does not exist yet, or a link has no target yet. Where the system does not tell, "." and ".."
/// are taken out of the text only.
[[nodiscard]] std::string whole_path(const std::filesystem::path& path);

/// Whether there is a file, a folder, or a link, also one without a target.
[[nodiscard]] bool is_there(const std::filesystem::path& path);

/// Whether the path lies below the folder; both are absolute, without links, "." and "..".
[[nodiscard]] bool is_below(const std::string& path, const std::string& folder);

/// Whether the file may be written: it lies below the root and is not one of carom's configs.
[[nodiscard]] bool is_writable(const std::string& path, const std::string& root);

/// The media type of a film or drawing by its extension; `otherwise` for other files.
[[nodiscard]] std::string media_type_of(const std::string& path, const std::string& otherwise);

}  // namespace carom::studio
