#include "pipeline/farm/wishes.h"

#include <chrono>
#include <sstream>
#include <thread>

#include <unistd.h>

#include "core/error.h"
#include "pipeline/farm/record.h"
#include "pipeline/store/lock_file.h"

namespace carom::farm {
namespace {

constexpr int kFormat = 1;
constexpr int kAttempts = 50;  // to get the lock
constexpr std::chrono::milliseconds kPause{100};

std::string path_of(const FarmJob& job) {
    return job.folder + "/wishes.json";
}

std::string text_of(const std::set<std::int64_t>& frames) {
    std::string text;
    for (const std::int64_t frame : frames) {
        text += (text.empty() ? "" : " ") + std::to_string(frame);
    }
    return text;
}

std::set<std::int64_t> frames_of(const std::string& text) {
    std::istringstream in(text);
    std::set<std::int64_t> frames;
    for (std::int64_t frame = 0; in >> frame;) {
        frames.insert(frame);
    }
    return frames;
}

/// "12 5 13 5": pairs of a frame and a revision.
std::string text_of(const std::map<std::int64_t, std::int64_t>& retried) {
    std::string text;
    for (const auto& [frame, revision] : retried) {
        text += (text.empty() ? "" : " ") + std::to_string(frame) + " " + std::to_string(revision);
    }
    return text;
}

std::map<std::int64_t, std::int64_t> retried_of(const std::string& text) {
    std::istringstream in(text);
    std::map<std::int64_t, std::int64_t> retried;
    for (std::int64_t frame = 0, revision = 0; in >> frame >> revision;) {
        retried[frame] = revision;
    }
    return retried;
}

/// Only one process at a time changes the wishes. A file system without locks has none here either.
pipeline::FileDescriptor lock(const std::string& path) {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        pipeline::LockAttempt tried = pipeline::try_lock(path);
        if (tried.state != pipeline::LockState::busy) {
            return std::move(tried.descriptor);
        }
        std::this_thread::sleep_for(kPause);
    }
    throw Error("somebody else changes the wishes of this job ('" + path +
                "' is locked); try again");
}

}  // namespace

Wishes read_wishes(const FarmJob& job) {
    const std::string path = path_of(job);
    const std::optional<Record> record = Record::read(path);
    if (!record) {
        return {};
    }
    if (record->integer("carom_farm_wishes") != kFormat) {
        throw Error("'" + path + "' was written by another version of carom");
    }
    return {record->integer("revision"), frames_of(record->text("preferred")),
            frames_of(record->text("skipped")), retried_of(record->text("retried"))};
}

void change_wishes(const FarmJob& job, const std::function<void(Wishes&)>& change) {
    const std::string lock_path = job.folder + "/wishes.lock";
    const pipeline::FileDescriptor locked = lock(lock_path);
    Wishes wishes = read_wishes(job);
    ++wishes.revision;
    change(wishes);
    JsonMembers members;
    members.add("carom_farm_wishes", kFormat)
        .add("revision", wishes.revision)
        .add("preferred", text_of(wishes.preferred))
        .add("skipped", text_of(wishes.skipped))
        .add("retried", text_of(wishes.retried));
    write_record(path_of(job), members);
    ::unlink(lock_path.c_str());
}

}  // namespace carom::farm
