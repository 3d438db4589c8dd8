#include "pipeline/studio/paths.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "pipeline/config/config_files.h"
#include "pipeline/video/picture_kind.h"

namespace carom::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kMediaTypes{{
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".mp4", "video/mp4"},
    {".mov", "video/quicktime"},
    {".mkv", "video/x-matroska"},
    {".webm", "video/webm"},
    {".avi", "video/x-msvideo"},
}};

std::vector<std::string> config_folders() {
    std::vector<std::string> folders;
    for (const std::string& folder : pipeline::config::standard_config_folders().folders) {
        std::error_code code;
        const fs::path canonical = fs::canonical(folder, code);
        folders.push_back(code ? folder : canonical.string());
    }
    return folders;
}

/// The path with its first link replaced by what that names; empty if it has none.
std::optional<fs::path> behind_link(const fs::path& path) {
    fs::path known;
    for (auto part = path.begin(); part != path.end(); ++part) {
        std::error_code code;
        if (fs::is_symlink(fs::symlink_status(known / *part, code))) {
            fs::path target = known / fs::read_symlink(known / *part, code);
            for (++part; part != path.end(); ++part) {
                target /= *part;
            }
            return target;
        }
        known /= *part;
    }
    return std::nullopt;
}

}  // namespace

std::string whole_path(const fs::path& path) {
    constexpr int kMostLinks = 40;  // as in Linux
    std::error_code code;
    fs::path result = fs::weakly_canonical(path, code);
    // A link without a target does not exist for weakly_canonical, but a file that is written by
    // its name comes to be at its target.
    std::optional<fs::path> target;
    for (int links = 0; !code && links < kMostLinks && (target = behind_link(result)); ++links) {
        result = fs::weakly_canonical(*target, code);
    }
    return code ? path.lexically_normal().string() : result.string();
}

bool is_there(const fs::path& path) {
    std::error_code code;
    return fs::exists(fs::symlink_status(path, code));
}

bool is_below(const std::string& path, const std::string& folder) {
    const fs::path relative = fs::path(path).lexically_relative(folder);
    return !relative.empty() && *relative.begin() != ".." && relative != ".";
}

bool is_writable(const std::string& path, const std::string& root) {
    static const std::vector<std::string> configs = config_folders();
    return is_below(path, root) && std::ranges::none_of(configs, [&](const std::string& folder) {
               return is_below(path, folder);
           });
}

std::string media_type_of(const std::string& path, const std::string& otherwise) {
    const std::string extension = pipeline::extension_of(path);
    const auto* const found = std::ranges::find(
        kMediaTypes, extension, &std::pair<std::string_view, std::string_view>::first);
    return found == kMediaTypes.end() ? otherwise : std::string(found->second);
}

}  // namespace carom::studio
