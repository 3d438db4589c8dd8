#include "pipeline/studio/recent_files.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <system_error>

#include "core/atomic_file.h"
#include "core/error.h"

namespace carom::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMost = 20;
constexpr std::size_t kLongestPath = 4096;

/// Empty if the variable is not an absolute path: relative ones have to be ignored (XDG Base
/// Directory Specification 0.8, section "Basics").
std::string absolute_path(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value == '/' ? value : "";
}

}  // namespace

std::string default_state_folder() {
    if (const std::string state = absolute_path("XDG_STATE_HOME"); !state.empty()) {
        return state + "/carom";
    }
    const std::string home = absolute_path("HOME");
    return home.empty() ? "" : home + "/.local/state/carom";
}

RecentFiles::RecentFiles(const std::string& folder)
    : path_(folder.empty() ? "" : folder + "/recent_shots") {}

std::vector<std::string> RecentFiles::read() const {
    std::vector<std::string> files;
    std::ifstream file(path_);
    std::string line;
    while (files.size() < kMost && std::getline(file, line)) {
        if (line.starts_with('/') && line.size() <= kLongestPath) {
            files.push_back(line);
        }
    }
    return files;
}

std::vector<std::string> RecentFiles::list() const {
    std::vector<std::string> files = read();
    std::erase_if(files, [](const std::string& file) {
        std::error_code code;
        return !fs::is_regular_file(file, code);
    });
    return files;
}

void RecentFiles::add(const std::string& file) {
    if (file.find('\n') != std::string::npos) {
        return;
    }
    std::vector<std::string> files = list();
    std::erase(files, file);
    files.insert(files.begin(), file);
    files.resize(std::min(files.size(), kMost));
    write(files);
}

void RecentFiles::remove(const std::string& file) {
    std::vector<std::string> files = read();
    if (std::erase(files, file) > 0) {
        write(files);
    }
}

void RecentFiles::write(const std::vector<std::string>& files) const {
    if (path_.empty()) {
        return;
    }
    std::string text;
    for (const std::string& file : files) {
        text += file + "\n";
    }
    std::error_code ignored;
    fs::create_directories(fs::path(path_).parent_path(), ignored);
    try {
        write_file_atomically(path_, std::as_bytes(std::span(text)));
    } catch (const Error&) {
        return;  // such as a home that cannot be written
    }
}

}  // namespace carom::studio
