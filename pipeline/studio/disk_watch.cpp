#include "pipeline/studio/disk_watch.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

namespace carom::studio {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kGather{30};   // from the first event to the look, for those that follow it
constexpr milliseconds kAgain{300};   // until a second look for a missing file
constexpr milliseconds kRetry{500};   // until another attempt to watch a folder that is gone
constexpr milliseconds kPoll{2'000};  // between looks where inotify does not work
constexpr std::uint32_t kEvents = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE |
                                  IN_CREATE | IN_ATTRIB | IN_DELETE_SELF | IN_MOVE_SELF |
                                  IN_ONLYDIR;

/// Whether the system watches no folder, or none more, or not this one. A folder that is gone is
/// tried again instead.
bool is_refused(int error) {
    return error == ENOSPC || error == ENOMEM || error == EACCES;
}

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) {
            ::close(number_);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor(Descriptor&&) = delete;
    Descriptor& operator=(Descriptor&&) = delete;
    [[nodiscard]] int get() const { return number_; }

  private:
    int number_;
};

}  // namespace

class DiskWatch::Thread {
  public:
    explicit Thread(std::function<bool()> look)
        : look_(std::move(look)),
          inotify_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)),
          wake_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
        polls_ = inotify_.get() < 0;
        thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
    }

    ~Thread() { end(); }

    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;
    Thread(Thread&&) = delete;
    Thread& operator=(Thread&&) = delete;

    void watch(const std::vector<std::string>& files) {
        std::map<std::string, std::set<std::string>> wanted;
        for (const std::filesystem::path file : files) {
            std::error_code ignored;
            for (const auto& path : {file, std::filesystem::weakly_canonical(file, ignored)}) {
                wanted[path.parent_path().string()].insert(path.filename().string());
            }
        }
        wanted.erase("");
        const std::lock_guard lock(mutex_);
        for (const auto& [folder, watched] : folders_) {
            if (watched.number >= 0 && !wanted.contains(folder)) {
                ::inotify_rm_watch(inotify_.get(), watched.number);
            }
        }
        std::map<std::string, Folder> folders;
        for (auto& [folder, names] : wanted) {
            const auto known = folders_.find(folder);
            folders[folder] = {known == folders_.end() ? -1 : known->second.number,
                               std::move(names)};
        }
        folders_ = std::move(folders);
        add_watches();
        wake();
    }

    void end() {
        thread_.request_stop();
        wake();
        if (thread_.joinable()) {
            thread_.join();
        }
    }

  private:
    struct Folder {
        int number = -1;  // of its watch; negative: it has none
        std::set<std::string> names;
    };

    /// Watches the folders that have no watch. Returns whether one was added.
    bool add_watches() {
        bool has_added = false;
        for (auto& [path, folder] : folders_) {
            if (folder.number < 0 && inotify_.get() >= 0) {
                folder.number = ::inotify_add_watch(inotify_.get(), path.c_str(), kEvents);
                has_added = has_added || folder.number >= 0;
                if (folder.number < 0 && is_refused(errno)) {
                    polls_ = true;
                }
            }
        }
        return has_added;
    }

    void run(const std::stop_token& end) {
        while (!end.stop_requested()) {
            std::array<pollfd, 2> waits{pollfd{wake_.get(), POLLIN, 0},
                                        pollfd{inotify_.get(), POLLIN, 0}};
            ::poll(waits.data(), waits.size(), timeout());
            read_wake();
            if (end.stop_requested()) {
                return;
            }
            if (is_due(read_events())) {
                due_ = look_() ? std::optional(Clock::now() + kAgain) : std::nullopt;
            }
        }
    }

    /// Whether it is time to look. `is_touched`: something happened just now.
    bool is_due(bool is_touched) {
        const Clock::time_point now = Clock::now();
        bool polls = false;
        {
            const std::lock_guard lock(mutex_);
            polls = polls_;
            if (std::ranges::any_of(folders_,
                                    [](const auto& one) { return one.second.number < 0; })) {
                is_touched = add_watches() || is_touched;
            }
        }
        if (polls && now >= polled_ + kPoll) {
            polled_ = now;
            return true;
        }
        if (is_touched) {
            due_ = due_ ? std::min(*due_, now + kGather) : now + kGather;
        }
        return due_ && now >= *due_;
    }

    [[nodiscard]] int timeout() {
        std::optional<Clock::time_point> next = due_;
        const Clock::time_point now = Clock::now();
        const std::lock_guard lock(mutex_);
        const auto sooner = [&](Clock::time_point time) {
            next = next ? std::min(*next, time) : time;
        };
        if (polls_) {
            sooner(polled_ + kPoll);
        }
        if (std::ranges::any_of(folders_, [](const auto& one) { return one.second.number < 0; })) {
            sooner(now + kRetry);
        }
        if (!next) {
            return -1;
        }
        const auto left = std::chrono::ceil<milliseconds>(*next - now).count();
        return static_cast<int>(std::max<std::int64_t>(left, 0));
    }

    void wake() const {
        const std::uint64_t one = 1;
        static_cast<void>(!::write(wake_.get(), &one, sizeof one));
    }

    void read_wake() const {
        std::uint64_t count = 0;
        static_cast<void>(!::read(wake_.get(), &count, sizeof count));
    }

    /// Reads all events that wait. Returns whether one of them is about a watched file.
    bool read_events() {
        alignas(inotify_event) std::array<char, 16'384> bytes;  // NOLINT: written by read
        bool is_touched = false;
        for (;;) {
            const ssize_t size = ::read(inotify_.get(), bytes.data(), bytes.size());
            if (size <= 0) {
                return is_touched;
            }
            for (ssize_t at = 0; at < size;) {
                inotify_event event{};
                std::memcpy(&event, bytes.data() + at, sizeof event);
                const char* name = event.len > 0 ? bytes.data() + at + sizeof event : "";
                is_touched = take(event, name) || is_touched;
                at += static_cast<ssize_t>(sizeof event + event.len);
            }
        }
    }

    bool take(const inotify_event& event, const std::string& name) {
        if ((event.mask & IN_Q_OVERFLOW) != 0) {
            return true;
        }
        const bool has_gone = (event.mask & (IN_IGNORED | IN_DELETE_SELF | IN_MOVE_SELF)) != 0;
        bool is_touched = false;
        const std::lock_guard lock(mutex_);
        for (auto& [path, folder] : folders_) {  // two paths may lead to the same folder
            if (folder.number == event.wd) {
                is_touched = is_touched || has_gone || folder.names.contains(name);
                folder.number = has_gone ? -1 : folder.number;
            }
        }
        if ((event.mask & IN_MOVE_SELF) != 0) {
            ::inotify_rm_watch(inotify_.get(), event.wd);
        }
        return is_touched;
    }

    std::function<bool()> look_;
    Descriptor inotify_;
    Descriptor wake_;

    std::mutex mutex_;  // of the two members below
    std::map<std::string, Folder> folders_;
    bool polls_ = false;

    // Of the thread.
    std::optional<Clock::time_point> due_;  // when to look
    Clock::time_point polled_ = Clock::now();

    std::jthread thread_;
};

DiskWatch::DiskWatch(std::function<bool()> look)
    : thread_(std::make_unique<Thread>(std::move(look))) {}

DiskWatch::~DiskWatch() = default;

void DiskWatch::end() {
    thread_->end();
}

void DiskWatch::watch(const std::vector<std::string>& files) {
    thread_->watch(files);
}

}  // namespace carom::studio
