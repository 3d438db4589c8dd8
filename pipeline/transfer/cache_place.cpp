#include "pipeline/transfer/cache_place.h"

#include <filesystem>
#include <optional>
#include <sstream>

#include "pipeline/transfer/rsync.h"

namespace carom::transfer {
namespace {

using Kind = pipeline::CacheEntry::Kind;

constexpr int kPartialTransfer = 23;  // rsync's exit code, also if a folder does not exist

/// The file that a path in a cache names; empty if no finished file has this path.
std::optional<CacheFile> parse_path(const std::string& path) {
    const std::filesystem::path parsed(path);
    const std::optional<Hash128> key = pipeline::parse_key(parsed.stem().string());
    if (!key) {
        return std::nullopt;
    }
    const CacheFile file{parsed.extension() == ".bake" ? Kind::bake : Kind::frame, *key};
    return file.path() == path ? std::optional(file) : std::nullopt;
}

/// "-rw-r--r--      5412345 2026/01/31 12:00:00 frames/ab/abcdef....exr"
void add_line(const std::string& line, CacheFiles& files) {
    std::istringstream in(line);
    std::string mode;
    std::string date;
    std::string time;
    std::string path;
    std::uint64_t bytes = 0;
    in >> mode >> bytes >> date >> time >> path;
    const std::optional<CacheFile> file = in ? parse_path(path) : std::nullopt;
    if (file && mode.starts_with('-')) {
        files[*file] = bytes;
    }
}

}  // namespace

std::string CacheFile::path() const {
    return kind == Kind::frame ? pipeline::frame_file("", key).substr(1)
                               : pipeline::bake_file("", key).substr(1);
}

CacheFiles list_place(const std::string& place, bool may_be_missing, const std::stop_token& stop) {
    const RsyncCall call{
        {"--recursive", "--list-only", "--no-human-readable", "--include=/frames/",
         "--include=/frames/[0-9a-f][0-9a-f]/", "--include=/frames/[0-9a-f][0-9a-f]/*.exr",
         "--include=/bakes/", "--include=/bakes/*.bake", "--exclude=*"},
        {place},
        {}};
    CacheFiles files;
    const RsyncResult result = run_rsync(
        call, [&](const std::string& line) { add_line(line, files); }, stop);
    const bool is_missing = may_be_missing && result.exit_code == kPartialTransfer &&
                            files.empty() &&
                            result.errors.find("No such file or directory") != std::string::npos;
    if (result.exit_code != 0 && !is_missing) {
        throw_rsync_error("the cache '" + place + "' cannot be listed", result);
    }
    return files;
}

}  // namespace carom::transfer
