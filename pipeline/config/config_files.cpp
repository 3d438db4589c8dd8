#include "pipeline/config/config_files.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

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
    ConfigFolders folders;
    for (const fs::path& path : wanted) {
        std::error_code code;
        if (fs::is_directory(path, code)) {
            folders.folders.push_back(fs::absolute(path).lexically_normal().string());
        }
    }
    return folders;
}

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
            return {code ? fs::absolute(path, code).string() : canonical.string(), {}};
        }
        if (first_problem.empty() || first_problem == "does not exist") {
            first_problem = problem;
        }
    }
    return {{}, "file " + quote(name) + " " + first_problem};
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
        text = "has more than " + std::to_string(most_bytes) + " bytes";
        return false;
    }
    return true;
}

}  // namespace carom::pipeline::config
