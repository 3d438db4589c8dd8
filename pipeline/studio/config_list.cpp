#include "pipeline/studio/config_list.h"

#include <filesystem>
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "pipeline/config/config_files.h"

namespace carom::studio {

namespace fs = std::filesystem;

namespace {

/// The first paragraph of the comments at the start of a file, on one line.
std::string comment_of(const fs::path& path) {
    std::ifstream stream(path);
    std::string about;
    for (std::string line; std::getline(stream, line) && line.starts_with("# ");) {
        if (line.find("yaml-language-server") == std::string::npos) {
            about += (about.empty() ? "" : " ") + line.substr(2);
        }
    }
    return about;
}

}  // namespace

std::string config_list_json() {
    std::map<std::string, std::string> known;
    for (const std::string& folder : pipeline::config::standard_config_folders().folders) {
        std::error_code error;
        for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error)) {
            const std::string name = fs::relative(entry->path(), folder, error).generic_string();
            if (!error && entry->path().extension() == ".yaml" && !name.starts_with("templates/")) {
                known.try_emplace(name, comment_of(entry->path()));
            }
        }
    }
    nlohmann::json list = nlohmann::json::array();
    for (const auto& [name, about] : known) {
        list.push_back({{"name", name}, {"about", about}});
    }
    return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace carom::studio
