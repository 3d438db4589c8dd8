// Finding the files that a shot refers to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom::pipeline::config {

/// Folders that hold tables, ball sets, looks and quality presets, in the order of the search.
struct ConfigFolders {
    std::vector<std::string> folders;
    /// Files that a shot names lie below this folder (or in the config folders), links followed;
    /// empty: anywhere.
    std::string root = {};
};

/// $CAROM_CONFIGS, share/carom/configs beside the program's own folder, the source tree's configs,
/// and those where carom is installed (for programs that only link it); those that exist.
[[nodiscard]] ConfigFolders standard_config_folders();

struct FoundFile {
    std::string path;     // absolute, without "." and ".."; empty if there is none
    std::string problem;  // why there is none
};

/// `name` below `folder`, or else in one of the config folders: under the same name, and under the
/// part of it that follows its last "configs/". Regular files only.
[[nodiscard]] FoundFile find_config_file(std::string_view name, const std::string& folder,
                                         const ConfigFolders& folders);

/// The quality presets, by name.
[[nodiscard]] std::vector<std::string> preset_names(const ConfigFolders& folders);

/// The whole text of a regular file of at most `most_bytes`. False: `text` says what is wrong.
[[nodiscard]] bool read_text_file(const std::string& path, std::size_t most_bytes,
                                  std::string& text);

}  // namespace carom::pipeline::config
