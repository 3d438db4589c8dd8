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

/// Why `path` cannot be taken; empty if it is a regular file.
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

/// Every path that may be meant, in order.
std::vector<fs::path> candidates(const fs::path& name, const std::string& folder,
                                 const ConfigFolders& folders) {
    if (name.is_absolute()) {
        return {name};
    }
    std::vector<fs::path> paths{fs::path(folder) / name};
    fs::path behind;  // what follows the last "configs/"
    bool is_in_configs = false;
    for (const fs::path& part : name) {
        if (part == "configs") {
            behind.clear();
            is_in_configs = true;
        } else if (is_in_configs) {
            behind /= part;
        }
    }
    for (const std::string& config_folder : folders.folders) {
        paths.push_back(fs::path(config_folder) / name);
        if (!behind.empty()) {
            paths.push_back(fs::path(config_folder) / behind);
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
    std::vector<fs::path> wanted;
    const char* given = std::getenv("CAROM_CONFIGS");
    if (given != nullptr && *given != '\0') {
        wanted.emplace_back(given);
    }
    if (const std::optional<fs::path> program = folder_of_program()) {
        wanted.push_back(*program / "../share/carom/configs");     // bin/carom
        wanted.push_back(*program / "../../share/carom/configs");  // libexec/carom/carom-film
    }
    wanted.emplace_back(CAROM_SOURCE_CONFIGS);
    wanted.emplace_back(CAROM_INSTALLED_CONFIGS);
    ConfigFolders folders;
    for (const fs::path& path : wanted) {
        std::error_code code;
        if (fs::is_directory(path, code)) {
            folders.folders.push_back(fs::absolute(path).lexically_normal().string());
        }
    }
    return folders;
}

namespace {

constexpr std::size_t kMostSuggested = 2000;  // files that are looked at for a hint

/// Names as one would write them: files beside the wanted one, and all that the config folders
/// have, "tables/pool_9ft.yaml".
std::vector<std::string> nearby_names(const fs::path& name, const std::string& folder,
                                      const ConfigFolders& folders) {
    std::vector<std::string> names;
    std::error_code code;
    const fs::path parent = name.parent_path();
    for (fs::directory_iterator entry(fs::path(folder) / parent, code), end;
         !code && entry != end && names.size() < kMostSuggested; entry.increment(code)) {
        if (entry->path().extension() == name.extension()) {
            names.push_back((parent / entry->path().filename()).string());
        }
    }
    for (const std::string& root : folders.folders) {
        for (fs::recursive_directory_iterator entry(root, code), end;
             !code && entry != end && names.size() < kMostSuggested; entry.increment(code)) {
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

/// " (did you mean 'rigs/orbit.yaml'?)", or nothing. A name without its folder is known, too.
std::string file_hint(const fs::path& name, const std::string& folder,
                      const ConfigFolders& folders) {
    std::vector<std::string> names = nearby_names(name, folder, folders);
    for (const std::string& known : names) {
        if (fs::path(known).filename() == name.filename() && known != name.string()) {
            return " (did you mean " + quote(known) + "?)";
        }
    }
    // Folders have much in common: the file's own name must be near.
    std::erase_if(names, [&](const std::string& known) {
        const std::vector<std::string> stem{fs::path(known).stem().string()};
        return !nearest_name(name.stem().string(), stem);
    });
    // The typed folder may lead to the configs by another way: ../configs/rigs/orbt.yaml.
    const std::string text = name.string();
    const std::size_t configs = text.rfind("configs/");
    const std::string wanted =
        configs != std::string::npos ? text.substr(configs + std::strlen("configs/")) : text;
    return hint(wanted, names);
}

}  // namespace

namespace {

bool is_below(const fs::path& path, const std::string& folder) {
    std::error_code code;
    const fs::path way = path.lexically_relative(fs::canonical(folder, code));
    return !code && !way.empty() && *way.begin() != "..";
}

/// `path` has no links in it.
bool is_allowed(const fs::path& path, const ConfigFolders& folders) {
    return folders.root.empty() || is_below(path, folders.root) ||
           std::any_of(folders.folders.begin(), folders.folders.end(),
                       [&](const std::string& folder) { return is_below(path, folder); });
}

}  // namespace

FoundFile find_config_file(std::string_view name, const std::string& folder,
                           const ConfigFolders& folders) {
    if (name.empty() || name.size() > kLongestPathBytes ||
        name.find('\0') != std::string_view::npos) {
        return {{}, quote(name) + " is not a file's name"};
    }
    std::string first_problem;
    for (const fs::path& path : candidates(fs::path(name), folder, folders)) {
        const std::string problem = problem_with(path);
        if (problem.empty()) {
            std::error_code code;
            const fs::path canonical = fs::canonical(path, code);
            const std::string found = code ? fs::absolute(path, code).string() : canonical.string();
            if (!is_allowed(found, folders)) {
                return {{},
                        "file " + quote(name) + " lies outside of " + quote(folders.root) +
                            ", to which --root confines what a shot names"};
            }
            return {found, {}};
        }
        if (first_problem.empty() || first_problem == "does not exist") {
            first_problem = problem;
        }
    }
    const bool is_missing = first_problem == "does not exist";
    return {{},
            "file " + quote(name) + " " + first_problem +
                (is_missing ? file_hint(fs::path(name), folder, folders) : "")};
}

std::vector<std::string> preset_names(const ConfigFolders& folders) {
    std::vector<std::string> names;
    for (const std::string& folder : folders.folders) {
        std::error_code code;
        for (const fs::directory_entry& entry :
             fs::directory_iterator(fs::path(folder) / "quality", code)) {
            if (entry.path().extension() == ".yaml") {
                names.push_back(entry.path().stem().string());
            }
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

bool read_text_file(const std::string& path, std::size_t most_bytes, std::string& text) {
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
    while (stream && text.size() <= most_bytes) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad()) {
        text = "cannot be read";
        return false;
    }
    if (text.size() > most_bytes) {
        text = fmt::format("has more than {} bytes{}", most_bytes, how_to_raise_limits());
        return false;
    }
    return true;
}

}  // namespace carom::pipeline::config
