#include "pipeline/studio/output_path.h"

#include <filesystem>

#include "core/error.h"
#include "pipeline/studio/paths.h"

namespace carom::studio {

namespace fs = std::filesystem;

std::string output_path(const std::string& given, const std::string& shot,
                        const std::string& folder, const std::string& root,
                        const std::string& extension) {
    const fs::path base = folder.empty() ? fs::path(shot).parent_path() : fs::path(folder);
    fs::path path = base / (given.empty() ? fs::path(shot).stem() : fs::path(given));
    if (!path.has_extension()) {
        path += extension;
    }
    std::string result = whole_path(path);
    if (!is_below(result, whole_path(base)) && !is_below(result, root)) {
        throw Error("files can be written below '" + root + "' only, not '" + path.string() + "'");
    }
    return result;
}

}  // namespace carom::studio
