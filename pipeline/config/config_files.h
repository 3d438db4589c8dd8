// Finds the files to which a shot refers.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/message.h"

namespace carom::pipeline::config {

/// Texts by the absolute paths of their files, without links, "." and "..".
using OpenTexts = std::map<std::string, std::string>;

/// Folders with tables, ball sets, looks and quality presets, in the order of the search.
struct ConfigFolders {
    std::vector<std::string> folders;
    /// A shot may use only files inside this folder (or the config folders), with links resolved;
    /// empty: any files.
    std::string root = {};
    /// If the shot is a symbolic link: the folder of the link, and the folder of the file to which
    /// it leads, which is searched after it. Empty: it is none.
    std::string folder_of_link = {};
    std::string folder_of_target = {};
    /// Texts that are read instead of these files, which need not exist. nullptr: none.
    const OpenTexts* texts = nullptr;
    /// The largest size of a mesh or an image; 0: any.
    std::uintmax_t most_asset_bytes = 0;
    /// Gets the paths, in the folder of what names them, of files that were not found. nullptr:
    /// none.
    std::vector<std::string>* missing = nullptr;
};

/// The standard folders for a shot of this name, which may be a link.
[[nodiscard]] ConfigFolders config_folders_of(const std::string& shot);

/// Those of these folders that exist: $CAROM_CONFIGS, share/carom/configs beside the program's own
/// folder, the configs of the source tree, and those of the installed carom (for programs that link
/// to it).
[[nodiscard]] ConfigFolders standard_config_folders();

struct FoundFile {
    std::string path;  // absolute, without "." and ".."; empty if there is no such file
    Message problem;   // the reason if `path` is empty
};

/// Searches for `name` in `folder`, beside the file to which a linked shot leads, and then in the
/// config folders: under the same name, and under
/// the part of the name after its last "configs/". Only regular files are found.
[[nodiscard]] FoundFile find_config_file(std::string_view name, const std::string& folder,
                                         const ConfigFolders& folders);

/// As read_text_file, for a file that find_config_file found.
[[nodiscard]] bool read_config_text(const std::string& path, std::size_t max_bytes,
                                    const ConfigFolders& folders, std::string& text);

/// The names of the files in a folder of the config folders: "quality", "sets".
[[nodiscard]] std::vector<std::string> preset_names(const std::string& kind,
                                                    const ConfigFolders& folders);

/// Reads the whole text of a regular file of at most `max_bytes`. If it returns false, `text` is
/// the problem.
[[nodiscard]] bool read_text_file(const std::string& path, std::size_t max_bytes,
                                  std::string& text);

}  // namespace carom::pipeline::config
