#include "pipeline/store/cache_entry.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

std::optional<Hash128> hash_of_name(const std::string& digits) {
    if (digits.size() != 32) {
        return std::nullopt;
    }
    Hash128 hash;
    const char* text = digits.data();
    const auto high = std::from_chars(text, text + 16, hash.high, 16);
    const auto low = std::from_chars(text + 16, text + 32, hash.low, 16);
    if (high.ptr != text + 16 || low.ptr != text + 32 || hash.to_string() != digits) {
        return std::nullopt;
    }
    return hash;
}

/// Bakes of version 1 of their format had their warnings in a file beside them.
std::string old_warnings_of(const std::string& bake) {
    return bake + ".warnings";
}

/// Nothing if it is no entry's file, or gone by now.
std::optional<CacheEntry> entry_of(const fs::path& path, CacheEntry::Kind kind) {
    struct stat status {};
    const std::optional<Hash128> key = hash_of_name(path.stem().string());
    if (!key || ::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
        return std::nullopt;
    }
    CacheEntry entry{kind, path.string(), *key, static_cast<std::uint64_t>(status.st_size), {}};
    entry.last_used = std::chrono::system_clock::time_point(
        std::chrono::duration_cast<std::chrono::system_clock::duration>(
            std::chrono::seconds(status.st_mtim.tv_sec) +
            std::chrono::nanoseconds(status.st_mtim.tv_nsec)));
    return entry;
}

void collect(const fs::path& folder, const char* extension, CacheEntry::Kind kind,
             std::vector<CacheEntry>& entries) {
    std::error_code failure;
    fs::recursive_directory_iterator it(folder, failure);
    if (failure && failure != std::errc::no_such_file_or_directory) {
        throw Error("the cache '" + folder.string() + "' cannot be read: " + failure.message());
    }
    // What vanishes meanwhile is another process's doing.
    for (; !failure && it != fs::recursive_directory_iterator(); it.increment(failure)) {
        if (it->path().extension() != extension) {
            continue;
        }
        if (std::optional<CacheEntry> entry = entry_of(it->path(), kind)) {
            entries.push_back(std::move(*entry));
        }
    }
}

}  // namespace

std::vector<CacheEntry> list_cache(const std::string& folder) {
    std::vector<CacheEntry> entries;
    collect(fs::path(folder) / "frames", ".exr", CacheEntry::Kind::frame, entries);
    collect(fs::path(folder) / "bakes", ".bake", CacheEntry::Kind::bake, entries);
    std::sort(entries.begin(), entries.end(), [](const CacheEntry& a, const CacheEntry& b) {
        return a.last_used != b.last_used ? a.last_used < b.last_used : a.path < b.path;
    });
    return entries;
}

void mark_used(const std::string& path) {
    static_cast<void>(::utimensat(AT_FDCWD, path.c_str(), nullptr, 0));
}

bool remove_entry(const CacheEntry& entry) {
    if (::unlink(entry.path.c_str()) != 0 && errno != ENOENT) {
        return false;
    }
    if (entry.kind == CacheEntry::Kind::bake) {
        ::unlink(old_warnings_of(entry.path).c_str());
    }
    return true;
}

}  // namespace carom::pipeline
