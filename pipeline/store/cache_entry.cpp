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
#include "pipeline/store/claims.h"
#include "pipeline/store/lock_file.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

/// Version 1 of the bake format kept the warnings in a separate file beside the bake.
std::string old_warnings_path(const std::string& bake) {
    return bake + ".warnings";
}

/// The entry of a file. Empty if the file is not an entry or was removed in the meantime.
std::optional<CacheEntry> read_entry(const fs::path& path, CacheEntry::Kind kind) {
    struct stat status {};
    const std::optional<Hash128> key = parse_key(path.stem().string());
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

void collect_entries(const fs::path& folder, const char* extension, CacheEntry::Kind kind,
                     std::vector<CacheEntry>& entries) {
    std::error_code failure;
    fs::recursive_directory_iterator it(folder, failure);
    if (failure && failure != std::errc::no_such_file_or_directory) {
        throw Error("the cache '" + folder.string() + "' cannot be read: " + failure.message());
    }
    // Another process may remove files meanwhile: that is not an error.
    for (; !failure && it != fs::recursive_directory_iterator(); it.increment(failure)) {
        if (it->path().extension() != extension) {
            continue;
        }
        if (std::optional<CacheEntry> entry = read_entry(it->path(), kind)) {
            entries.push_back(std::move(*entry));
        }
    }
}

}  // namespace

std::optional<Hash128> parse_key(const std::string& digits) {
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

std::string file_about(const Hash128& key, const std::string& frames_folder,
                       const char* extension) {
    const std::string digits = key.to_string();
    return frames_folder + "/" + digits.substr(0, 2) + "/" + digits + extension;
}

std::string frame_file(const std::string& cache_folder, const Hash128& key) {
    return file_about(key, cache_folder + "/frames", ".exr");
}

std::string bake_file(const std::string& cache_folder, const Hash128& key) {
    return cache_folder + "/bakes/" + key.to_string() + ".bake";
}

std::string answers_folder(const std::string& cache_folder) {
    return cache_folder + "/answers";
}

std::vector<CacheEntry> list_cache(const std::string& folder) {
    std::vector<CacheEntry> entries;
    collect_entries(fs::path(folder) / "frames", ".exr", CacheEntry::Kind::frame, entries);
    collect_entries(fs::path(folder) / "frames", ".sums", CacheEntry::Kind::sums, entries);
    collect_entries(fs::path(folder) / "frames", kFarLightExtension, CacheEntry::Kind::light,
                    entries);
    collect_entries(fs::path(folder) / "frames", kNoisyExtension, CacheEntry::Kind::noisy, entries);
    collect_entries(answers_folder(folder), ".answer", CacheEntry::Kind::answer, entries);
    collect_entries(fs::path(folder) / "bakes", ".bake", CacheEntry::Kind::bake, entries);
    std::sort(entries.begin(), entries.end(), [](const CacheEntry& a, const CacheEntry& b) {
        return a.last_used != b.last_used ? a.last_used < b.last_used : a.path < b.path;
    });
    return entries;
}

void mark_used(const std::string& path) {
    static_cast<void>(::utimensat(AT_FDCWD, path.c_str(), nullptr, 0));
}

void remove_leftovers(const std::string& frames_folder, const ClaimTimes& times) {
    Claims(frames_folder + "/locks", times).remove_dead();
    remove_abandoned_files(frames_folder + "/partial", host_prefix());
}

bool remove_entry(const CacheEntry& entry) {
    if (::unlink(entry.path.c_str()) != 0 && errno != ENOENT) {
        return false;
    }
    if (entry.kind == CacheEntry::Kind::bake) {
        ::unlink(old_warnings_path(entry.path).c_str());
    }
    return true;
}

}  // namespace carom::pipeline
