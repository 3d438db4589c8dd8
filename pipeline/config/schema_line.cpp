#include "pipeline/config/schema_line.h"

#include <filesystem>
#include <string_view>
#include <system_error>

#include "pipeline/config/config_files.h"

namespace carom::pipeline::config {

namespace {

constexpr std::string_view kStart = "# yaml-language-server: $schema=";
constexpr std::string_view kSchema = "carom.schema.json";

}  // namespace

std::string with_schema_line(std::string text, const std::string& folder) {
    if (text.starts_with(kStart)) {
        const std::size_t end = text.find('\n');
        text.erase(0, end == std::string::npos ? end : end + 1);
    }
    const std::filesystem::path given(folder.empty() ? "." : folder);
    std::error_code ignored;
    const std::filesystem::path whole =
        std::filesystem::weakly_canonical(std::filesystem::absolute(given, ignored), ignored);
    const FoundFile schema = find_config_file(kSchema, whole.string(), standard_config_folders());
    const std::string parent = whole.parent_path().string();
    const bool is_near = parent.size() > 1 && schema.path.starts_with(parent + "/");
    const std::string name =
        is_near ? std::filesystem::path(schema.path).lexically_relative(whole).string()
                : std::string(kSchema);
    return std::string(kStart) + name + "\n" + text;
}

bool has_schema_line(std::string_view text) {
    return text.starts_with(kStart);
}

}  // namespace carom::pipeline::config
