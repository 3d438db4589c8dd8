#include "pipeline/store/pins.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/write_all.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/claim_note.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;
using std::chrono::hours;

constexpr const char* kJob = "job-";  // begins the names of write_job_pin
constexpr hours kJobsCountFor{24 * 30};
constexpr hours kProcessesCountFor{24 * 7};  // those of other machines, whose locks are not seen

std::string pins_folder(const std::string& cache_folder) {
    return cache_folder + "/pins";
}

std::string text_of(std::span<const Hash128> keys) {
    std::string text;
    for (const Hash128& key : keys) {
        text += key.to_string() + "\n";
    }
    return text;
}

bool is_unlocked(const fs::path& path) {
    const FileDescriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    return file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0;
}

bool counts(const fs::path& path) {
    std::error_code failure;
    const fs::file_time_type written = fs::last_write_time(path, failure);
    if (failure) {
        return false;
    }
    const auto age = fs::file_time_type::clock::now() - written;
    const std::string name = path.filename().string();
    if (name.starts_with(kJob)) {
        return age < kJobsCountFor;
    }
    return name.starts_with(host_prefix()) ? !is_unlocked(path) : age < kProcessesCountFor;
}

void add_keys(const fs::path& path, std::set<Hash128>& keys) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (const std::optional<Hash128> key = parse_key(line)) {
            keys.insert(*key);
        }
    }
    if (file.bad()) {
        throw Error("'" + path.string() + "' cannot be read");
    }
}

}  // namespace

Pin::Pin(const std::string& cache_folder, std::span<const Hash128> keys) {
    static std::atomic<std::uint64_t> count{0};
    try {
        create_folder(pins_folder(cache_folder));
    } catch (const Error&) {
        return;
    }
    path_ =
        fmt::format("{}/{}{}-{}", pins_folder(cache_folder), host_prefix(), ::getpid(), ++count);
    lock_ = FileDescriptor(::open(path_.c_str(), O_CREAT | O_TRUNC | O_RDWR | O_CLOEXEC, 0666));
    if (lock_.is_open() && ::flock(lock_.get(), LOCK_EX) == 0) {
        const std::string text = text_of(keys);
        (void)write_all(lock_.get(), std::as_bytes(std::span(text)));
    }
}

Pin::~Pin() {
    if (lock_.is_open()) {
        ::unlink(path_.c_str());
    }
}

void write_job_pin(const std::string& cache_folder, const std::string& job,
                   std::span<const Hash128> keys) {
    create_folder(pins_folder(cache_folder));
    const std::string text = text_of(keys);
    write_file_atomically(pins_folder(cache_folder) + "/" + kJob + job,
                          std::as_bytes(std::span(text)));
}

void remove_job_pin(const std::string& cache_folder, const std::string& job) {
    ::unlink((pins_folder(cache_folder) + "/" + kJob + job).c_str());
}

std::set<Hash128> pinned_keys(const std::string& cache_folder) {
    std::set<Hash128> keys;
    std::error_code ignored;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(pins_folder(cache_folder), ignored)) {
        if (counts(entry.path())) {
            add_keys(entry.path(), keys);
        } else {
            fs::remove(entry.path(), ignored);
        }
    }
    return keys;
}

}  // namespace carom::pipeline
