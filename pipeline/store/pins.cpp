#include "pipeline/store/pins.h"

#include <algorithm>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <system_error>

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/write_all.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/store/claim_note.h"
#include "pipeline/store/lock_file.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;
using std::chrono::hours;
using std::chrono::minutes;

constexpr const char* kJob = "job-";  // begins the names of write_job_pin
constexpr hours kJobsCountFor{24 * 30};
constexpr hours kProcessesCountFor{24 * 7};  // those of other machines, whose locks are not seen
constexpr minutes kRenewedEvery{1};
constexpr minutes kFreshFor{10};  // attributes of network file systems may be a minute old
constexpr hours kStaysWithoutFolder{1};

std::string pins_folder(const std::string& cache_folder) {
    return cache_folder + "/pins";
}

std::string process_text() {
    return owner_of({this_host(), std::to_string(::getpid())});
}

enum class PinState { fresh, old, not_counted, dead };

PinState state_of_job(const std::string& cache_folder, const PinText& pin,
                      fs::file_time_type::duration age) {
    if (age >= kJobsCountFor) {
        return PinState::dead;
    }
    std::error_code failure;
    const bool is_gone =
        !pin.folder.empty() && !fs::exists(cache_folder + "/" + pin.folder, failure) && !failure;
    if (is_gone) {
        // Another machine may see the folder a little later than the pin.
        return age < kStaysWithoutFolder ? PinState::not_counted : PinState::dead;
    }
    return PinState::fresh;
}

PinState state_of(const std::string& cache_folder, const fs::path& path, const PinText& pin) {
    std::error_code failure;
    const fs::file_time_type written = fs::last_write_time(path, failure);
    if (failure) {
        return PinState::not_counted;
    }
    const auto age = fs::file_time_type::clock::now() - written;
    const std::string name = path.filename().string();
    if (name.starts_with(kJob)) {
        return state_of_job(cache_folder, pin, age);
    }
    if (name.starts_with(host_prefix())) {
        switch (lock_state_of(path.string())) {
            case LockState::busy:
                return PinState::fresh;
            case LockState::acquired:
                return PinState::dead;
            case LockState::unsupported:
                break;
        }
    }
    if (age >= kProcessesCountFor) {
        return PinState::dead;
    }
    return age < kFreshFor ? PinState::fresh : PinState::old;
}

/// Throws CacheUnusable if only the folder of the pins cannot be written to. A cache that cannot be
/// written to at all is not pruned either, and a full disk ends those jobs that need room.
void check_pins_folder(const std::string& cache_folder, const std::string& problem) {
    const std::string inside = pins_folder(cache_folder) + "/.";
    if (::access(cache_folder.c_str(), W_OK) == 0 && ::access(inside.c_str(), W_OK) != 0 &&
        errno != ENOENT) {
        throw CacheUnusable(problem +
                            "; without a pin there, other jobs may prune the files of this one");
    }
}

}  // namespace

Pin::Pin(const std::string& cache_folder, std::span<const Hash128> keys, std::uint64_t bytes_each)
    : name_(host_prefix() + new_claim_process()), path_(pins_folder(cache_folder) + "/" + name_) {
    try {
        create_folder(pins_folder(cache_folder));
        lock_ =
            lock_own_file(path_).descriptor;  // where there are no locks, the time has to suffice
    } catch (const Error& error) {
        check_pins_folder(cache_folder, error.what());
        return;
    }
    const std::string text = text_of({process_text(), {}, bytes_each, {keys.begin(), keys.end()}});
    bytes_at_ = text.find(bytes_line(bytes_each));
    (void)write_all(lock_.get(), std::as_bytes(std::span(text)));
    (void)::fdatasync(lock_.get());  // hands it to a network file system's server
    stay_young();
}

Pin::~Pin() {
    if (renewal_.joinable()) {
        renewal_.request_stop();
        renewal_.join();
    }
    if (lock_.is_open()) {
        ::unlink(path_.c_str());
    }
}

void Pin::stay_young() {
    renewal_ = std::jthread([descriptor = lock_.get()](const std::stop_token& end) {
        std::mutex mutex;
        std::condition_variable_any wake;
        std::unique_lock lock(mutex);
        while (!wake.wait_for(lock, end, kRenewedEvery, [&end] { return end.stop_requested(); })) {
            (void)::futimens(descriptor, nullptr);
        }
    });
}

void Pin::expect(std::uint64_t bytes_each) const {
    if (lock_.is_open()) {
        const std::string line = bytes_line(bytes_each);
        (void)!::pwrite(lock_.get(), line.data(), line.size(), static_cast<off_t>(bytes_at_));
        (void)::fdatasync(lock_.get());
    }
}

std::string job_pin_name(const std::string& job) {
    return kJob + job;
}

void write_job_pin(const std::string& cache_folder, const JobPin& pin,
                   std::span<const Hash128> keys) {
    create_folder(pins_folder(cache_folder));
    const std::string text =
        text_of({"farm job " + pin.job, pin.folder, pin.bytes_each, {keys.begin(), keys.end()}});
    write_file_atomically(pins_folder(cache_folder) + "/" + job_pin_name(pin.job),
                          std::as_bytes(std::span(text)), FileAccess::of_folder);
}

void remove_job_pin(const std::string& cache_folder, const std::string& job) {
    ::unlink((pins_folder(cache_folder) + "/" + job_pin_name(job)).c_str());
}

void forget_reservation(const std::string& cache_folder, const std::string& job) {
    const std::string path = pins_folder(cache_folder) + "/" + job_pin_name(job);
    try {
        if (std::optional<PinText> pin = read_pin(path)) {
            pin->bytes_each = 0;
            const std::string text = text_of(*pin);
            write_file_atomically(path, std::as_bytes(std::span(text)), FileAccess::of_folder);
        }
    } catch (const Error&) {
        return;
    }
}

std::vector<LivePin> live_pins(const std::string& cache_folder) {
    std::vector<LivePin> pins;
    std::error_code ignored;
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(pins_folder(cache_folder), ignored)) {
        paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
        std::optional<PinText> text = read_pin(path.string());
        if (!text) {
            continue;
        }
        const PinState state = state_of(cache_folder, path, *text);
        if (state == PinState::dead) {
            fs::remove(path, ignored);
        } else if (state != PinState::not_counted) {
            pins.push_back({path.filename().string(), std::move(*text), state == PinState::fresh});
        }
    }
    return pins;
}

std::set<Hash128> pinned_keys(const std::string& cache_folder) {
    std::set<Hash128> keys;
    for (const LivePin& pin : live_pins(cache_folder)) {
        keys.insert(pin.text.keys.begin(), pin.text.keys.end());
    }
    return keys;
}

}  // namespace carom::pipeline
