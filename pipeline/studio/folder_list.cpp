#include "pipeline/studio/folder_list.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "pipeline/config/text.h"
#include "pipeline/studio/paths.h"

namespace carom::studio {

namespace fs = std::filesystem;
using pipeline::config::quote;

namespace {

constexpr std::size_t kMostEntries = 2'000;
constexpr std::size_t kLongestName = 1'024;

bool is_shot(const fs::path& path) {
    return path.extension() == ".yaml" || path.extension() == ".yml";
}

}  // namespace

Folder list_folder(const std::string& folder, const std::string& root) {
    const std::string path = whole_path(fs::path(root) / folder);
    if (path != root && !is_below(path, root)) {
        throw Error(quote(folder) + " is not below " + quote(root));
    }
    Folder list;
    list.folder = path;
    list.name = path == root ? "" : name_below(path, root);
    list.parent = path == root ? "" : fs::path(path).parent_path().string();
    std::error_code code;
    fs::directory_iterator entry(path, code);
    if (code) {
        throw Error("the folder " + quote(folder) + " cannot be read");
    }
    for (const fs::directory_iterator end; entry != end && list.entries.size() < kMostEntries;
         entry.increment(code)) {
        const std::string name = entry->path().filename().string();
        const bool is_folder = entry->is_directory(code);
        if (!name.starts_with('.') &&
            (is_folder || (is_shot(entry->path()) && entry->is_regular_file(code)))) {
            list.entries.push_back({name, entry->path().string(), is_folder});
        }
        if (code) {
            code.clear();  // a link without a target
        }
    }
    std::ranges::sort(list.entries, [](const FolderEntry& a, const FolderEntry& b) {
        return std::pair(!a.is_folder, a.name) < std::pair(!b.is_folder, b.name);
    });
    return list;
}

std::string path_for_writing(const std::string& name, const std::string& root) {
    const bool is_odd =
        name.empty() || name.size() > kLongestName ||
        std::ranges::any_of(name, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
    fs::path path = fs::path(root) / name;
    if (is_odd || path.filename().empty() || path.filename().string().starts_with('.')) {
        throw Error(quote(name) + " is not a name for a file");
    }
    if (!is_shot(path)) {
        path += ".yaml";
    }
    std::string file = whole_path(path);
    std::error_code code;
    if (!is_writable(file, root) || !is_shot(file)) {
        throw Error(quote(name) + " cannot be written: shots are written below " + quote(root) +
                    ", but not into carom's own configurations");
    }
    if (!fs::is_directory(fs::path(file).parent_path(), code)) {
        throw Error("there is no folder " + quote(fs::path(file).parent_path().string()));
    }
    if (fs::is_directory(file, code)) {
        throw Error(quote(name) + " is a folder");
    }
    return file;
}

std::string name_below(const std::string& file, const std::string& root) {
    return is_below(file, root) ? fs::path(file).lexically_relative(root).string() : file;
}

}  // namespace carom::studio
