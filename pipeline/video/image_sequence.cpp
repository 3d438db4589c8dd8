#include "pipeline/video/image_sequence.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "pipeline/video/picture_kind.h"

namespace carom::pipeline {

namespace {

namespace fs = std::filesystem;

std::string stem_of(const std::string& path) {
    return fs::path(path).stem().string();
}

}  // namespace

bool is_image_sequence(const std::string& path) {
    return stem_of(path).find('#') != std::string::npos;
}

std::string check_image_sequence(const std::string& path) {
    const std::string stem = stem_of(path);
    const std::size_t end = stem.find_first_not_of('#', stem.find('#'));
    if (end != std::string::npos && stem.find('#', end) != std::string::npos) {
        return "'" + path + "' has two groups of '#'; the frame number needs exactly one";
    }
    if (!is_picture_path(path)) {
        return "'" + path + "' is not a known type of image file; the known types are " +
               list_pictures();
    }
    return {};
}

std::string path_in_sequence(const std::string& pattern, std::int64_t frame) {
    std::string name = fs::path(pattern).filename().string();
    const std::size_t first = name.find('#');
    const std::size_t end = std::min(name.find_first_not_of('#', first), name.size());
    std::string digits = fmt::format("{}", frame);
    if (digits.size() < end - first) {
        digits.insert(0, end - first - digits.size(), '0');
    }
    name.replace(first, end - first, digits);
    return (fs::path(pattern).parent_path() / name).string();
}

std::string sound_path_of_sequence(const std::string& pattern) {
    const std::string stem = stem_of(pattern);
    const std::size_t begin = stem.find('#');
    const std::size_t end = std::min(stem.find_first_not_of('#', begin), stem.size());
    std::string name = stem.substr(0, begin);
    name.erase(name.find_last_not_of("._- ") + 1);
    name += name.empty() ? "" : stem.substr(end);
    return (fs::path(pattern).parent_path() / ((name.empty() ? "sound" : name) + ".wav")).string();
}

}  // namespace carom::pipeline
