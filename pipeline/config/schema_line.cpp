#include "pipeline/config/schema_line.h"

#include <filesystem>
#include <string_view>

#include "pipeline/config/config_files.h"

namespace carom::pipeline::config {

namespace {

constexpr std::string_view kStart = "# yaml-language-server: $schema=";

}  // namespace

std::string with_schema_line(std::string text, const std::string& folder) {
    if (text.starts_with(kStart)) {
        const std::size_t end = text.find('\n');
        text.erase(0, end == std::string::npos ? end : end + 1);
    }
    const FoundFile schema =
        find_config_file("carom.schema.json", folder, standard_config_folders());
    if (schema.path.empty()) {
        return text;
    }
    const std::filesystem::path shot_folder(folder);
    const std::string parent = shot_folder.parent_path().string();
    const bool is_near =
        shot_folder.is_absolute() && parent.size() > 1 && schema.path.starts_with(parent + "/");
    const std::string name =
        is_near ? std::filesystem::path(schema.path).lexically_relative(shot_folder).string()
                : schema.path;
    return std::string(kStart) + name + "\n" + text;
}

bool has_schema_line(std::string_view text) {
    return text.starts_with(kStart);
}

}  // namespace carom::pipeline::config
