#include "pipeline/transfer/cache_transfer.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "core/error.h"
#include "core/group_folder.h"
#include "pipeline/store/cache_maintenance.h"
#include "pipeline/store/file_descriptor.h"
#include "pipeline/store/frame_checksum.h"
#include "pipeline/store/incoming.h"
#include "pipeline/store/pins.h"
#include "pipeline/store/reservations.h"
#include "pipeline/transfer/cache_place.h"
#include "pipeline/transfer/rsync.h"

namespace carom::transfer {
namespace {

namespace fs = std::filesystem;
using Kind = pipeline::CacheEntry::Kind;

// Times of the file system may be rounded to steps of 10 ms.
constexpr std::chrono::seconds kClockSlack{2};

/// Files and their bytes, in the order in which they are copied.
using Selection = CacheFiles;

std::uint64_t bytes_of(const Selection& files) {
    std::uint64_t bytes = 0;
    for (const auto& [file, size] : files) {
        bytes += size;
    }
    return bytes;
}

std::vector<Hash128> keys_of(const Selection& files) {
    std::vector<Hash128> keys;
    for (const auto& [file, size] : files) {
        keys.push_back(file.key);
    }
    return keys;
}

void count(const CacheFile& file, std::uint64_t bytes, TransferResult& result) {
    ++(file.kind == Kind::frame ? result.frames : result.bakes);
    result.bytes += bytes;
}

/// The files of `from` that `to` has not. Counts the others and the missing keys.
Selection choose(const CacheFiles& from, const CacheFiles& to, const TransferOptions& options,
                 TransferResult& result) {
    Selection chosen;
    std::set<Hash128> found;
    for (const CacheFiles& files : {from, to}) {
        for (const auto& [file, bytes] : files) {
            found.insert(file.key);
        }
    }
    for (const auto& [file, bytes] : from) {
        if (options.keys && !options.keys->contains(file.key)) {
            continue;
        }
        if (to.contains(file)) {
            ++result.there;
        } else {
            chosen[file] = bytes;
        }
    }
    if (options.keys) {
        for (const Hash128& key : *options.keys) {
            result.missing += found.contains(key) ? 0 : 1;
        }
    }
    return chosen;
}

CacheFiles own_files(const std::string& cache_folder) {
    CacheFiles files;
    for (const pipeline::CacheEntry& entry : pipeline::list_cache(cache_folder)) {
        if (entry.kind == Kind::frame || entry.kind == Kind::bake) {
            files[{entry.kind, entry.key}] = entry.bytes;
        }
    }
    return files;
}

/// Whether the file may be taken; else it is added to those of the result that may not.
bool may_take(const std::string& path, const CacheFile& file, TransferResult& result) {
    const pipeline::FrameFileState state = pipeline::state_of({file.kind, path, file.key, 0, {}});
    if (state == pipeline::FrameFileState::damaged) {
        result.damaged.push_back(file.path());
    } else if (state == pipeline::FrameFileState::unreadable) {
        result.unreadable.push_back(file.path());
    } else {
        return true;
    }
    return false;
}

/// Passes on the progress of rsync, which prints a line for each file.
class Progress {
  public:
    Progress(const Selection& files, const WorkContext& context) : context_(context) {
        for (const auto& [file, bytes] : files) {
            files_[file.path()] = {file, bytes};
            all_ += bytes;
        }
    }
    /// Returns the file that the line names, with its bytes, or nothing.
    std::optional<std::pair<CacheFile, std::uint64_t>> add(const std::string& line) {
        const std::size_t space = line.find(' ');
        const auto found =
            space == std::string::npos ? files_.end() : files_.find(line.substr(space + 1));
        if (found == files_.end()) {
            return std::nullopt;
        }
        done_ += found->second.second;
        if (context_.progress && all_ > 0) {
            context_.progress(
                std::min(1.0, static_cast<double>(done_) / static_cast<double>(all_)));
        }
        return found->second;
    }

  private:
    const WorkContext& context_;
    std::map<std::string, std::pair<CacheFile, std::uint64_t>> files_;
    std::uint64_t done_ = 0;
    std::uint64_t all_ = 0;
};

/// Copies exactly these files. The bytes before a name have rsync print it when it has the file.
RsyncCall copy_of(const Selection& files, const std::string& from, const std::string& to) {
    RsyncCall call{
        {"--files-from=-", "--from0", "--ignore-existing", "--outbuf=L", "--out-format=%b %n"},
        {from, to},
        {}};
    for (const auto& [file, bytes] : files) {
        call.input += file.path() + '\0';
    }
    return call;
}

/// A folder in the cache where files arrive.
class Arrivals {
  public:
    explicit Arrivals(const std::string& cache_folder)
        : cache_(cache_folder), folder_(pipeline::make_incoming_folder(cache_folder)) {}
    ~Arrivals() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Arrivals(const Arrivals&) = delete;
    Arrivals& operator=(const Arrivals&) = delete;
    Arrivals(Arrivals&&) = delete;
    Arrivals& operator=(Arrivals&&) = delete;

    [[nodiscard]] const std::string& folder() const { return folder_; }

    /// Moves those of the files that have arrived, except damaged ones, into the cache.
    void take(Selection& files, TransferResult& result) const {
        for (auto it = files.begin(); it != files.end();) {
            const std::string path = folder_ + "/" + it->first.path();
            std::error_code ignored;
            if (!fs::is_regular_file(fs::symlink_status(path, ignored))) {
                ++it;
                continue;
            }
            take_one(path, it->first, it->second, result);
            it = files.erase(it);
        }
    }

  private:
    void take_one(const std::string& path, const CacheFile& file, std::uint64_t bytes,
                  TransferResult& result) const {
        const std::string place = cache_ + "/" + file.path();
        if (!may_take(path, file, result)) {
            ::unlink(path.c_str());
        } else if (::access(place.c_str(), F_OK) == 0) {
            ++result.there;  // made here meanwhile
            ::unlink(path.c_str());
        } else {
            const pipeline::FileDescriptor opened(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
            (void)::fsync(opened.get());
            const std::string folder = fs::path(place).parent_path().string();
            pipeline::create_folder(folder);
            share_file(opened.get(), folder);
            if (::rename(path.c_str(), place.c_str()) != 0) {
                throw Error(pipeline::system_problem(place, "the file cannot be moved here"));
            }
            count(file, bytes, result);
        }
    }

    std::string cache_;
    std::string folder_;
};

void copy_here(const TransferOptions& options, const std::string& place, Selection files,
               TransferResult& result, const WorkContext& context) {
    const Arrivals arrivals(options.cache_folder);
    Progress progress(files, context);
    const RsyncCall call = copy_of(files, place, arrivals.folder() + "/");
    Selection announced;
    RsyncResult done;
    try {
        done = run_rsync(
            call,
            [&](const std::string& line) {
                if (const auto file = progress.add(line)) {
                    announced.insert(*file);
                    arrivals.take(announced, result);  // perhaps the next time: it is renamed now
                    files.erase(file->first);
                }
            },
            context.stop);
    } catch (const Stopped&) {
        files.merge(announced);
        arrivals.take(files, result);
        throw;
    }
    files.merge(announced);
    arrivals.take(files, result);
    if (done.exit_code != 0) {
        throw_rsync_error("not everything could be copied from '" + options.place + "'", done);
    }
}

/// A pin that reserves room for the files.
void require_room(const TransferOptions& options, const pipeline::Pin& pin, std::uint64_t removable,
                  const std::stop_token& stop) {
    const pipeline::RoomRequest request{options.cache_folder, pin.name(), removable, 1, {},
                                        options.on_wait};
    pipeline::reserve_room(
        request, [] {}, stop);
}

pipeline::PruneResult prune(const TransferOptions& options, std::uint64_t limit,
                            std::chrono::system_clock::time_point begin, bool dry_run) {
    pipeline::PruneOptions prune;
    prune.limit = limit;
    prune.keep_since = begin;
    prune.dry_run = dry_run;
    return pipeline::prune_cache(options.cache_folder, prune);
}

/// What the limit will remove when so many bytes have arrived.
std::uint64_t removable_for(const TransferOptions& options, std::uint64_t bytes,
                            std::chrono::system_clock::time_point begin) {
    if (options.cache_limit == pipeline::kNoLimit) {
        return 0;
    }
    const std::uint64_t limit = options.cache_limit > bytes ? options.cache_limit - bytes : 0;
    return prune(options, limit, begin, true).removed_bytes;
}

void check_folder(const std::string& folder) {
    std::error_code ignored;
    if (is_remote(folder)) {
        return;
    }
    if (!fs::is_directory(folder, ignored)) {
        throw Error("there is no folder '" + folder + "'");
    }
    if (!fs::exists(folder + "/frames", ignored) && !fs::exists(folder + "/bakes", ignored)) {
        throw Error("'" + folder + "' is not a cache: it has neither a folder frames nor bakes");
    }
}

}  // namespace

TransferResult pull(const TransferOptions& options, const WorkContext& context) {
    check_folder(options.place);
    const auto begin = std::chrono::system_clock::now() - kClockSlack;
    const std::string place = rsync_place(options.place);
    TransferResult result;
    const Selection files = choose(list_place(place, false, context.stop),
                                   own_files(options.cache_folder), options, result);
    if (options.dry_run) {
        for (const auto& [file, bytes] : files) {
            count(file, bytes, result);
        }
        return result;
    }
    if (files.empty()) {
        return result;
    }
    const pipeline::Pin pin(options.cache_folder, keys_of(files), bytes_of(files) / files.size());
    require_room(options, pin, removable_for(options, bytes_of(files), begin), context.stop);
    copy_here(options, place, files, result, context);
    const pipeline::PruneResult pruned = prune(options, options.cache_limit, begin, false);
    if (pruned.kept_bytes > options.cache_limit) {
        result.exceeds_limit = pruned.kept_bytes;
    }
    return result;
}

TransferResult push(const TransferOptions& options, const WorkContext& context) {
    const std::string place = rsync_place(options.place);
    TransferResult result;
    Selection files = choose(own_files(options.cache_folder), list_place(place, true, context.stop),
                             options, result);
    std::optional<pipeline::Pin> pin;  // so that nothing is pruned before it was sent
    if (!options.dry_run && !files.empty()) {
        pin.emplace(options.cache_folder, keys_of(files));
    }
    for (auto it = files.begin(); it != files.end();) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        const std::string path = options.cache_folder + "/" + it->first.path();
        it = may_take(path, it->first, result) ? std::next(it) : files.erase(it);
    }
    if (options.dry_run || files.empty()) {
        for (const auto& [file, bytes] : files) {
            count(file, bytes, result);
        }
        return result;
    }
    std::set<CacheFile> copied;
    Progress progress(files, context);
    const RsyncResult done = run_rsync(
        copy_of(files, rsync_place(options.cache_folder), place),
        [&](const std::string& line) {
            if (const auto file = progress.add(line)) {
                copied.insert(file->first);
            }
        },
        context.stop);
    if (done.exit_code != 0) {
        throw_rsync_error("not everything could be copied to '" + options.place + "'", done);
    }
    for (const auto& [file, bytes] : files) {
        if (copied.contains(file)) {
            count(file, bytes, result);
        } else {
            ++result.there;  // it came from elsewhere meanwhile
        }
    }
    return result;
}

}  // namespace carom::transfer
