// The shots below the root folder, and the names of new ones.
#pragma once

#include <string>

#include "pipeline/studio/messages.h"

namespace carom::studio {

/// The folders and YAML files of `folder`, which is absolute or relative to `root`. Hidden ones are
/// left out. Throws Error if it is not the root or below it.
[[nodiscard]] Folder list_folder(const std::string& folder, const std::string& root);

/// The absolute path of a YAML file to write, which need not exist. `name` is absolute or relative
/// to `root`; without an ending it gets ".yaml". Throws Error if that is not a name of a file that
/// may be written below the root, or if its folder does not exist.
[[nodiscard]] std::string path_for_writing(const std::string& name, const std::string& root);

/// The name relative to the root, if the file is below it.
[[nodiscard]] std::string name_below(const std::string& file, const std::string& root);

}  // namespace carom::studio
