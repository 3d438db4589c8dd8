#include "pipeline/store/claims.h"

#include <cerrno>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/error.h"
#include "core/write_all.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;
using State = ClaimNote::State;

constexpr int kMostNumbers = 1000;  // of claims on one name, all but the last of them dead

bool write_text(int descriptor, const std::string& text) {
    return write_all(descriptor, std::as_bytes(std::span(text)));
}

/// Writes a new file. Closing it hands the text to a network file system's server. False and errno
/// if it exists or cannot be written.
bool write_new(const std::string& path, const std::string& text) {
    const int descriptor = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        return false;
    }
    const bool is_written = write_text(descriptor, text);
    const int failure = errno;
    const bool is_closed = ::close(descriptor) == 0;
    if (!is_written) {
        errno = failure;
    }
    return is_written && is_closed;
}

bool locks(int descriptor) {
    return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

/// Locks a file that nobody else wants, though one who looks for dead claims may have it for a
/// moment. Where there are no locks, the beats have to suffice.
void lock_own(int descriptor) {
    while (!locks(descriptor) && (errno == EWOULDBLOCK || errno == EINTR)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// Whether nobody has locked a file of this machine, because its owner has ended.
bool is_abandoned(const std::string& path) {
    const FileDescriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    return file.is_open() && locks(file.get());
}

}  // namespace

// The owner's side: keeps the file locked and its counter counting.
struct Claim::Held {
    Held(Claims& claims, std::string claim_name, int claim_number, ClaimNote first)
        : all(claims), name(std::move(claim_name)), number(claim_number), note(std::move(first)) {}
    ~Held() { release(); }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    Held(Held&&) = delete;
    Held& operator=(Held&&) = delete;

    void start(FileDescriptor locked) {
        file = std::move(locked);
        heart = std::jthread([this](const std::stop_token& end) { beat(end); });
    }

    void beat(const std::stop_token& end) {
        std::unique_lock lock(mutex);
        while (!wake.wait_for(lock, end, all.times_.beat, [&] { return end.stop_requested(); })) {
            ++note.beat;
            write_note();
        }
    }

    // A failure is ignored: in the worst case others do the work, too.
    void write_note() const {
        const std::string text = text_of(note);
        (void)!::pwrite(file.get(), text.data(), text.size(), 0);
        (void)::fdatasync(file.get());
    }

    void stop_heart() {
        if (heart.joinable()) {
            heart.request_stop();
            wake.notify_all();
            heart.join();
        }
    }

    void finish() {
        stop_heart();
        note.state = State::finished;
        const std::string text = text_of(note);
        (void)!::pwrite(file.get(), text.data(), text.size(), 0);
        file.reset();  // hands it to the server, and gives up the lock
        const std::lock_guard lock(all.mutex_);
        for (int i = 0; i <= number && !all.times_.keeps_finished; ++i) {
            all.finished_.push_back(all.path(name, i));
        }
        is_finished = true;
    }

    // The lowest number first: as long as this file is there, nobody takes a dead one below it for
    // the last one.
    void release() {
        stop_heart();
        for (int i = 0; i <= number && !is_finished; ++i) {
            ::unlink(all.path(name, i).c_str());
        }
    }

    Claims& all;
    std::string name;
    int number;
    ClaimNote note;
    FileDescriptor file;
    bool is_finished = false;
    std::mutex mutex;
    std::condition_variable_any wake;
    std::jthread heart;
};

Claim::Claim(std::unique_ptr<Held> held) : held_(std::move(held)) {}
Claim::~Claim() = default;
Claim::Claim(Claim&&) noexcept = default;
Claim& Claim::operator=(Claim&&) noexcept = default;

void Claim::finish() {
    held_->finish();
}

bool Claim::replaces_dead_one() const {
    return held_->number > 0;
}

Claims::Claims(std::string folder, ClaimTimes times) : folder_(std::move(folder)), times_(times) {}

Claims::~Claims() {
    for (const std::string& path : finished_) {
        ::unlink(path.c_str());
    }
}

std::string Claims::path(const std::string& name, int number) const {
    return fmt::format("{}/{}.{}", folder_, name, number);
}

std::optional<Claim> Claims::claim(const std::string& name) {
    std::optional<ClaimNote> last;
    int number = 0;
    for (; number < kMostNumbers; ++number) {
        std::optional<ClaimNote> note = read_claim_note(path(name, number));
        if (!note) {
            break;
        }
        last = std::move(note);
    }
    if (last && !is_dead(path(name, number - 1), *last)) {
        return std::nullopt;
    }
    std::unique_ptr<Claim::Held> held = make(name, number, last);
    return held ? std::optional<Claim>(std::move(held)) : std::nullopt;
}

/// The file of a claim under a name of its own, locked.
FileDescriptor Claims::make_draft(const std::string& path, const ClaimNote& note) const {
    bool is_written = write_new(path, text_of(note));
    if (!is_written && errno == ENOENT) {
        create_folder(folder_);
        is_written = write_new(path, text_of(note));
    }
    if (!is_written) {
        const std::string problem = system_problem(path, "a claim cannot be written");
        ::unlink(path.c_str());
        throw Error(problem);
    }
    FileDescriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    lock_own(file.get());
    return file;
}

std::unique_ptr<Claim::Held> Claims::make(const std::string& name, int number,
                                          const std::optional<ClaimNote>& replaced) {
    ClaimNote note{this_host(), new_claim_process(), 0, State::working};
    const std::string own = path(name, number);
    const std::string draft = fmt::format("{}/new-{}{}", folder_, host_prefix(), note.process);
    FileDescriptor file = make_draft(draft, note);
    const bool is_linked = ::link(draft.c_str(), own.c_str()) == 0;
    const int failure = errno;
    ::unlink(draft.c_str());
    if (!is_linked && (failure == EPERM || failure == EOPNOTSUPP || failure == ENOSYS)) {
        if (write_new(own, text_of(note))) {  // a file system without hard links
            file = FileDescriptor(::open(own.c_str(), O_RDWR | O_CLOEXEC));
            lock_own(file.get());
        }
    }
    if (read_claim_note(own) != note) {
        return nullptr;
    }
    auto held = std::make_unique<Claim::Held>(*this, name, number, std::move(note));
    // Whoever released a claim in this moment has removed the dead ones below it, and another
    // process may have begun anew with the first number.
    if (number > 0 && read_claim_note(path(name, number - 1)) != replaced) {
        ::unlink(own.c_str());
        held->is_finished = true;  // nothing else is to be removed
        return nullptr;
    }
    held->start(std::move(file));
    return held;
}

bool Claims::is_dead(const std::string& path, const ClaimNote& note) {
    if (note.host == this_host() && is_abandoned(path)) {
        return true;  // it has ended, or finished: on this machine the result would be seen
    }
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard lock(mutex_);
    const auto [seen, is_new] = seen_.try_emplace(path, Seen{note, now});
    if (is_new || seen->second.note != note) {
        seen->second = {note, now};
        return false;
    }
    return now - seen->second.since >= times_.dead_after;
}

void Claims::forget(const std::string& name) const {
    for (int number = 0; number < kMostNumbers; ++number) {
        if (::unlink(path(name, number).c_str()) != 0) {
            return;
        }
    }
}

void Claims::remove_dead() const {
    // The folder is listed first, so that files which other processes create or remove meanwhile do
    // not matter.
    std::error_code ignored;
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, ignored)) {
        paths.push_back(entry.path().string());
    }
    for (const std::string& path : paths) {
        const std::optional<ClaimNote> note = read_claim_note(path);
        const bool is_own = note && (note->host.empty() || note->host == this_host());
        const bool is_kept = times_.keeps_finished && note && note->state == State::finished;
        if (is_own && !is_kept && is_abandoned(path)) {
            ::unlink(path.c_str());
        }
    }
}

}  // namespace carom::pipeline
