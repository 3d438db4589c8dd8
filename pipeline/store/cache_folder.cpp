#include "pipeline/store/cache_folder.h"

#include <cstdlib>

namespace carom::pipeline {
namespace {

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

/// Relative paths are invalid and have to be ignored (XDG Base Directory Specification 0.8, section
/// "Basics"): each current folder would have a cache of its own.
std::string absolute_path(const char* name) {
    std::string path = environment(name);
    return path.starts_with('/') ? path : std::string();
}

}  // namespace

std::string default_cache_folder() {
    if (std::string own = environment("CAROM_CACHE"); !own.empty()) {
        return own;
    }
    if (const std::string shared = absolute_path("XDG_CACHE_HOME"); !shared.empty()) {
        return shared + "/carom";
    }
    const std::string home = absolute_path("HOME");
    if (home.empty()) {
        throw CacheUnusable(
            "there is no folder for the cache; set CAROM_CACHE, or XDG_CACHE_HOME or HOME to an "
            "absolute path");
    }
    return home + "/.cache/carom";
}

std::string readable_cache_folder(const std::string& given) {
    try {
        return given.empty() ? default_cache_folder() : given;
    } catch (const CacheUnusable&) {
        return "/dev/null";  // no folder, so that nothing can be below it
    }
}

}  // namespace carom::pipeline
