#include "pipeline/config/config_files.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

#include <fmt/core.h>

#include "core/limits.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestPathBytes = 4096;

/// The reason why `path` cannot be used; empty if it is a regular file.
std::string problem_with(const fs::path& path) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (status.type() == fs::file_type::not_found || status.type() == fs::file_type::none) {
        return "does not exist";
    }
    if (status.type() == fs::file_type::directory) {
        return "is a folder";
    }
    return status.type() == fs::file_type::regular ? "" : "is not a regular file";
}

/// All paths that may be meant, in the order of the search.
std::vector<fs::path> candidates(const fs::path& name, const std::string& folder,
                                 const ConfigFolders& folders) {
    if (name.is_absolute()) {
        return {name};
    }
    std::vector<fs::path> paths{fs::path(folder) / name};
    if (!folders.folder_of_target.empty() && folder == folders.folder_of_link) {
        paths.push_back(fs::path(folders.folder_of_target) / name);
    }
    fs::path relative;  // the part after the last "configs/"
    bool is_in_configs = false;
    for (const fs::path& part : name) {
        if (part == "configs") {
            relative.clear();
            is_in_configs = true;
        } else if (is_in_configs) {
            relative /= part;
        }
    }
    for (const std::string& config_folder : folders.folders) {
        paths.push_back(fs::path(config_folder) / name);
        if (!relative.empty()) {
            paths.push_back(fs::path(config_folder) / relative);
        }
    }
    return paths;
}

std::optional<fs::path> folder_of_program() {
    std::error_code code;
    const fs::path program = fs::read_symlink("/proc/self/exe", code);
    return code ? std::nullopt : std::optional(program.parent_path());
}

}  // namespace

ConfigFolders standard_config_folders() {
    std::vector<fs::path> candidates;
    const char* given = std::getenv("CAROM_CONFIGS");
    if (given != nullptr && *given != '\0') {
        candidates.emplace_back(given);
    }
    if (const std::optional<fs::path> program = folder_of_program()) {
        candidates.push_back(*program / "../share/carom/configs");     // bin/carom
        candidates.push_back(*program / "../../share/carom/configs");  // libexec/carom/carom-film
    }
    candidates.emplace_back(CAROM_SOURCE_CONFIGS);
    candidates.emplace_back(CAROM_INSTALLED_CONFIGS);
    ConfigFolders folders;
    for (const fs::path& path : candidates) {
        std::error_code code;
        if (fs::is_directory(path, code)) {
            folders.folders.push_back(fs::absolute(path).lexically_normal().string());
        }
    }
    return folders;
}

ConfigFolders config_folders_of(const std::string& shot) {
    ConfigFolders folders = standard_config_folders();
    std::error_code code;
    const fs::path named = fs::absolute(shot, code).lexically_normal();
    const fs::path whole = code ? fs::path() : fs::canonical(named, code);
    if (!code && whole.parent_path() != fs::canonical(named.parent_path(), code) && !code) {
        folders.folder_of_link = named.parent_path().string();
        folders.folder_of_target = whole.parent_path().string();
    }
    return folders;
}

namespace {

constexpr std::size_t kMaxSuggestions = 2000;  // files that are compared for a hint

/// The names of the files beside the missing one and of all files in the config folders, as a shot
/// would write them: "tables/pool_9ft.yaml".
std::vector<std::string> nearby_names(const fs::path& name, const std::string& folder,
                                      const ConfigFolders& folders) {
    std::vector<std::string> names;
    std::error_code code;
    const fs::path parent = name.parent_path();
    for (fs::directory_iterator entry(fs::path(folder) / parent, code), end;
         !code && entry != end && names.size() < kMaxSuggestions; entry.increment(code)) {
        if (entry->path().extension() == name.extension()) {
            names.push_back((parent / entry->path().filename()).string());
        }
    }
    for (const std::string& root : folders.folders) {
        for (fs::recursive_directory_iterator entry(root, code), end;
             !code && entry != end && names.size() < kMaxSuggestions; entry.increment(code)) {
            if (entry->path().extension() == name.extension()) {
                names.push_back(entry->path().lexically_relative(root).string());
            }
        }
    }
    std::erase_if(names, [](const std::string& found) {
        return find_invalid_utf8(found) != std::string_view::npos;
    });
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

/// " (did you mean 'rigs/orbit.yaml'?)", or nothing. The name of an existing file without its
/// folder is recognised, too.
Message file_hint(const fs::path& name, const std::string& folder, const ConfigFolders& folders) {
    std::vector<std::string> names = nearby_names(name, folder, folders);
    for (const std::string& known : names) {
        if (fs::path(known).filename() == name.filename() && known != name.string()) {
            return {" (did you mean " + quote(known) + "?)", known};
        }
    }
    // Paths in the same folder are always similar, so the file's own name must be similar, too.
    std::erase_if(names, [&](const std::string& known) {
        const std::vector<std::string> stem{fs::path(known).stem().string()};
        return !nearest_name(name.stem().string(), stem);
    });
    // The typed path may lead to the configs through another folder: ../configs/rigs/orbt.yaml.
    const std::string text = name.string();
    const std::size_t configs = text.rfind("configs/");
    const std::string name_in_configs =
        configs != std::string::npos ? text.substr(configs + std::strlen("configs/")) : text;
    return hint(name_in_configs, names);
}

}  // namespace

namespace {

bool is_below(const fs::path& path, const std::string& folder) {
    std::error_code code;
    const fs::path relative = path.lexically_relative(fs::canonical(folder, code));
    return !code && !relative.empty() && *relative.begin() != "..";
}

/// Whether a shot may use the file; `path` contains no links.
bool is_allowed(const fs::path& path, const ConfigFolders& folders) {
    return folders.root.empty() || is_below(path, folders.root) ||
           std::any_of(folders.folders.begin(), folders.folders.end(),
                       [&](const std::string& folder) { return is_below(path, folder); });
}

}  // namespace

namespace {

/// The path of the open text that is meant by `path`; empty if there is none.
std::string open_text_of(const fs::path& path, const ConfigFolders& folders) {
    if (folders.texts == nullptr || folders.texts->empty()) {
        return {};
    }
    std::error_code code;
    const fs::path whole = fs::weakly_canonical(path, code);
    return !code && folders.texts->contains(whole.string()) ? whole.string() : std::string();
}

}  // namespace

FoundFile find_config_file(std::string_view name, const std::string& folder,
                           const ConfigFolders& folders) {
    if (name.empty() || name.size() > kLongestPathBytes ||
        name.find('\0') != std::string_view::npos) {
        return {{}, quote(name) + " is not a valid file name"};
    }
    std::string first_problem;
    for (const fs::path& path : candidates(fs::path(name), folder, folders)) {
        const std::string open_text = open_text_of(path, folders);
        const std::string problem = open_text.empty() ? problem_with(path) : "";
        if (problem.empty()) {
            std::error_code code;
            const fs::path canonical =
                open_text.empty() ? fs::canonical(path, code) : fs::path(open_text);
            const std::string found = code ? fs::absolute(path, code).string() : canonical.string();
            if (!is_allowed(found, folders)) {
                if (folders.missing != nullptr) {
                    folders.missing->push_back(found);
                }
                return {{},
                        "file " + quote(name) + " is outside " + quote(folders.root) +
                            "; --root allows only files inside that folder"};
            }
            return {found, {}};
        }
        if (first_problem.empty() || first_problem == "does not exist") {
            first_problem = problem;
        }
    }
    const bool is_missing = first_problem == "does not exist";
    if (is_missing && folders.missing != nullptr) {
        std::error_code code;
        folders.missing->push_back(
            fs::weakly_canonical(fs::path(folder) / fs::path(name), code).string());
    }
    return {{},
            "file " + quote(name) + " " + first_problem +
                (is_missing ? file_hint(fs::path(name), folder, folders) : Message())};
}

std::vector<std::string> preset_names(const std::string& kind, const ConfigFolders& folders) {
    std::vector<std::string> names;
    for (const std::string& folder : folders.folders) {
        std::error_code code;
        for (const fs::directory_entry& entry :
             fs::directory_iterator(fs::path(folder) / kind, code)) {
            if (entry.path().extension() == ".yaml") {
                names.push_back(entry.path().stem().string());
            }
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

bool read_config_text(const std::string& path, std::size_t max_bytes, const ConfigFolders& folders,
                      std::string& text) {
    const std::string open_text = open_text_of(path, folders);
    if (open_text.empty()) {
        return read_text_file(path, max_bytes, text);
    }
    text = folders.texts->at(open_text);
    if (text.size() > max_bytes) {
        text = fmt::format("has more than {} bytes{}", max_bytes, how_to_raise_limits());
        return false;
    }
    return true;
}

bool read_text_file(const std::string& path, std::size_t max_bytes, std::string& text) {
    const std::string problem = problem_with(path);
    if (!problem.empty()) {
        text = problem;
        return false;
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        text = "cannot be opened";
        return false;
    }
    text.clear();
    std::string block(65536, '\0');
    while (stream && text.size() <= max_bytes) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad()) {
        text = "cannot be read";
        return false;
    }
    if (text.size() > max_bytes) {
        text = fmt::format("has more than {} bytes{}", max_bytes, how_to_raise_limits());
        return false;
    }
    return true;
}

}  // namespace carom::pipeline::config
