#include "pipeline/studio/journal.h"

#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>
#include <span>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>

#include "core/atomic_file.h"
#include "core/error.h"
#include "pipeline/store/lock_file.h"
#include "pipeline/studio/message_json.h"
#include "pipeline/studio/text_hash.h"

namespace carom::studio {

namespace fs = std::filesystem;

namespace {

constexpr int kMostStudios = 8;  // that have a journal of the same shot

std::vector<RecoveredText> read_journal(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    try {
        return std::get<Recovered>(read_server_message(text)).files;
    } catch (const std::exception&) {
        return {};  // there is none, or it is damaged
    }
}

/// A journal that no other studio has, and the lock that keeps it so.
struct Place {
    std::string path;
    std::string lock_path;
    pipeline::FileDescriptor lock;
};

/// A studio that was killed may hold the lock of its journal for a moment longer.
pipeline::LockAttempt patient_lock(const std::string& path, bool is_worth_waiting) {
    pipeline::LockAttempt attempt = pipeline::try_lock(path);
    for (int i = 0; i < 20 && is_worth_waiting && attempt.state == pipeline::LockState::busy; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        attempt = pipeline::try_lock(path);
    }
    return attempt;
}

/// If possible one that another studio left behind. Throws Error if none can be made.
std::optional<Place> find_place(const std::string& shot, const std::string& folder) {
    pipeline::create_folder(folder);
    fs::permissions(folder, fs::perms::owner_all);
    const std::string stem = folder + "/" + hash_of(shot) + "-";
    std::optional<Place> place;
    for (int i = 0; i < kMostStudios; ++i) {
        Place other{stem + std::to_string(i) + ".json", stem + std::to_string(i) + ".lock", {}};
        const bool exists = fs::exists(other.path);
        if (place && !exists) {
            continue;
        }
        pipeline::LockAttempt attempt = patient_lock(other.lock_path, exists);
        if (attempt.state != pipeline::LockState::busy) {
            other.lock = std::move(attempt.descriptor);
            place = std::move(other);
        }
        if (place && exists) {
            break;
        }
    }
    return place;
}

}  // namespace

class Journal::Writer {
  public:
    Writer(Place place, std::chrono::milliseconds interval)
        : place_(std::move(place)), interval_(interval) {
        thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
    }

    ~Writer() {
        thread_.request_stop();
        thread_.join();
        std::error_code ignored;
        fs::remove(place_.lock_path, ignored);
    }

    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    Writer(Writer&&) = delete;
    Writer& operator=(Writer&&) = delete;

    void keep(std::vector<RecoveredText> texts) {
        const std::lock_guard lock(mutex_);
        waiting_ = std::move(texts);
        wake_.notify_one();
    }

  private:
    void run(const std::stop_token& end) {
        std::unique_lock lock(mutex_);
        while (wake_.wait(lock, end, [&] { return waiting_.has_value(); })) {
            // A file of texts that are saved is removed at once.
            wake_.wait_for(lock, end, interval_, [&] { return waiting_->empty(); });
            const std::vector<RecoveredText> texts = *std::exchange(waiting_, {});
            lock.unlock();
            write(texts);
            lock.lock();
        }
    }

    void write(const std::vector<RecoveredText>& texts) {
        const std::string text = texts.empty() ? "" : to_json(ServerMessage(Recovered{texts}));
        if (text == written_) {
            return;
        }
        written_ = text;
        std::error_code ignored;
        if (text.empty()) {
            fs::remove(place_.path, ignored);
            return;
        }
        try {
            write_file_atomically(place_.path, std::as_bytes(std::span(text)));
        } catch (const Error&) {
            written_.reset();  // the disk may be full: the next change tries again
        }
    }

    Place place_;
    std::chrono::milliseconds interval_;
    std::optional<std::string> written_;  // empty: not known

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<std::vector<RecoveredText>> waiting_;

    std::jthread thread_;
};

Journal::Journal(const std::string& shot, const JournalOptions& options) {
    try {
        if (std::optional<Place> place = find_place(shot, options.folder)) {
            found_ = read_journal(place->path);
            writer_ = std::make_unique<Writer>(std::move(*place), options.interval);
        }
    } catch (const std::exception&) {
        return;  // the folder cannot be written
    }
}

Journal::~Journal() = default;

void Journal::keep(std::vector<RecoveredText> texts) {
    if (writer_) {
        writer_->keep(std::move(texts));
    }
}

}  // namespace carom::studio
