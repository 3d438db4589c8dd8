#include "pipeline/store/claims.h"

#include <cerrno>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "core/error.h"
#include "core/group_folder.h"
#include "core/write_all.h"
#include "pipeline/store/file_descriptor.h"
#include "pipeline/store/lock_file.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;
using State = ClaimNote::State;

constexpr int kMostNumbers = 1000;  // of claims on one name, all but the last of them dead

/// Whether nobody has locked a file of this machine, because its owner has ended.
bool is_abandoned(const std::string& path) {
    return lock_state_of(path) == LockState::acquired;
}

/// Makes a file with this text and locks it. Closed, with errno, if it exists or cannot be written.
FileDescriptor make_file(const std::string& path, const std::string& text) {
    FileDescriptor file(::open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666));
    if (!file.is_open()) {
        return file;
    }
    share_file(file.get(), fs::path(path).parent_path().string());
    // Before it says whose it is, or others on this machine would take the owner for dead. Where
    // there are no locks, the beats have to suffice.
    lock_own_file(file.get(), path);
    // To close it once hands the text to a network file system's server.
    if (!write_all(file.get(), std::as_bytes(std::span(text))) || ::close(::dup(file.get())) != 0) {
        const int failure = errno;
        ::unlink(path.c_str());
        file.reset();
        errno = failure;
    }
    return file;
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
        if (!all.times_.keeps_finished) {
            all.finished_.push_back({name, number, note});
        }
        is_finished = true;
    }

    void release() {
        stop_heart();
        if (!is_finished) {
            all.remove(name, number);
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
    for (const Finished& own : finished_) {
        try {
            if (read_claim_note(path(own.name, own.number)) == own.note) {
                remove(own.name, own.number);
            }
        } catch (const Error&) {
            continue;  // whoever cannot read it does not know that it is still his
        }
    }
}

void Claims::remove(const std::string& name, int last) const {
    for (int number = 0; number <= last; ++number) {
        ::unlink(path(name, number).c_str());
    }
}

std::string Claims::path(const std::string& name, int number) const {
    return fmt::format("{}/{}.{}", folder_, name, number);
}

Claims::Last Claims::last_of(const std::string& name) const {
    Last last;
    for (; last.next < kMostNumbers; ++last.next) {
        std::optional<ClaimNote> note = read_claim_note(path(name, last.next));
        if (!note) {
            break;
        }
        last.note = std::move(note);
    }
    return last;
}

std::optional<Claim> Claims::claim(const std::string& name) {
    const Last last = last_of(name);
    if (last.note && !is_dead(path(name, last.next - 1), *last.note)) {
        return std::nullopt;
    }
    std::unique_ptr<Claim::Held> held = make(name, last.next, last.note);
    return held ? std::optional<Claim>(std::move(held)) : std::nullopt;
}

std::string Claims::holder(const std::string& name) {
    const Last last = last_of(name);
    if (!last.note) {
        return "";
    }
    const std::string file = path(name, last.next - 1);
    if (last.note->host.empty()) {
        return "'" + file + "' does not say who has claimed it";
    }
    std::string text = owner_of(*last.note) + " has claimed it";
    if (!last.note->since.empty()) {
        text += " since " + last.note->since;
    }
    if (last.note->state == State::finished) {
        return text + " and finished it, which is not seen here yet";
    }
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard lock(mutex_);
    const auto seen = seen_.find(file);
    const bool is_same = seen != seen_.end() && seen->second.note == *last.note;
    const auto silent = now - (is_same ? seen->second.since : now);
    return fmt::format("{}; its last sign of life came {} s ago", text,
                       std::chrono::floor<std::chrono::seconds>(silent).count());
}

/// The file of a claim under a name of its own, locked.
FileDescriptor Claims::make_draft(const std::string& path, const ClaimNote& note) const {
    FileDescriptor file = make_file(path, text_of(note));
    if (!file.is_open() && errno == ENOENT) {
        create_folder(folder_);
        file = make_file(path, text_of(note));
    }
    if (!file.is_open()) {
        throw Error(system_problem(path, "a claim cannot be written"));
    }
    return file;
}

std::unique_ptr<Claim::Held> Claims::make(const std::string& name, int number,
                                          const std::optional<ClaimNote>& replaced) {
    ClaimNote note{this_host(), new_claim_process(), 0, State::working, time_now()};
    const std::string own = path(name, number);
    const std::string draft = fmt::format("{}/new-{}{}", folder_, host_prefix(), note.process);
    FileDescriptor file = make_draft(draft, note);
    const bool is_linked = ::link(draft.c_str(), own.c_str()) == 0;
    const int failure = errno;
    ::unlink(draft.c_str());
    if (!is_linked && failure != EEXIST && !read_claim_note(own)) {  // perhaps there are no links
        FileDescriptor made = make_file(own, text_of(note));
        if (made.is_open()) {
            file = std::move(made);
        } else if (errno != EEXIST) {  // else it may be the link to the draft, seen late
            throw Error(system_problem(own, "the claim cannot be made"));
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
    const auto is_dead_here = [&](const std::string& path) {
        try {
            const std::optional<ClaimNote> note = read_claim_note(path);
            const bool is_own = note && (note->host.empty() || note->host == this_host());
            const bool is_kept = times_.keeps_finished && note && note->state == State::finished;
            return is_own && !is_kept && is_abandoned(path);
        } catch (const Error&) {
            return false;  // another user's
        }
    };
    for (const std::string& path : paths) {
        if (is_dead_here(path)) {
            ::unlink(path.c_str());
        }
    }
}

}  // namespace carom::pipeline
