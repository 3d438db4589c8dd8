#include "pipeline/studio/output_path.h"

#include <filesystem>
#include <system_error>

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
    std::error_code ignored;
    const std::string result = fs::weakly_canonical(path, ignored).string();
    const std::string canonical_base = fs::weakly_canonical(base, ignored).string();
    if (!is_below(result, canonical_base) && !is_below(result, root)) {
        throw Error("files can be written below '" + root + "' only, not '" + path.string() + "'");
    }
    return result;
}

}  // namespace carom::studio
