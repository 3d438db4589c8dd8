// Claims: the right of one process to make something, which all processes on all machines that
// share a folder respect.
//
// A claim is a file that is made atomically and carries a counter, its heartbeat, that the owner
// counts up while it works. Others never compare clocks: for a process a claim is dead when it has
// seen no change of the counter for some seconds of its own steady clock. On the owner's machine a
// lock on the file tells at once that the owner has ended.
//
// The file of a claim on NAME is NAME.0. Whoever finds it dead claims NAME.1, and so on: there is
// no moment at which a file has to be replaced, so two processes that find the same claim dead
// cannot both take it over. The file is a hard link to a draft, so that nobody sees it without its
// content; if that fails for another reason than that it exists, it is created exclusively. Either
// may report a failure though the file was made (a reply of a network file system was lost), so
// that its content decides, and no attribute of a file is asked for, because attributes may be a
// minute old. If all this fails, two processes do the same work: what is made has to be the same
// then.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/store/claim_note.h"
#include "pipeline/store/claim_times.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {

/// Owned by the process until it is destroyed.
class Claim {
  public:
    struct Held;
    explicit Claim(std::unique_ptr<Held> held);
    ~Claim();
    Claim(Claim&&) noexcept;
    Claim& operator=(Claim&&) noexcept;
    Claim(const Claim&) = delete;
    Claim& operator=(const Claim&) = delete;

    /// The work is done and its result is in its place, where other machines may see it a little
    /// later: until then they see that it was finished. The file stays until `Claims` is destroyed
    /// or longer, unless somebody removes it.
    void finish();

    /// Whether the claim took the place of a dead one.
    [[nodiscard]] bool replaces_dead_one() const;

  private:
    std::unique_ptr<Held> held_;
};

/// The claims in a folder. May be used from any thread, and must outlive its claims.
class Claims {
  public:
    explicit Claims(std::string folder, ClaimTimes times = {});
    ~Claims();
    Claims(const Claims&) = delete;
    Claims& operator=(const Claims&) = delete;
    Claims(Claims&&) = delete;
    Claims& operator=(Claims&&) = delete;

    /// The claim on `name`, or nothing if another process has it, or if it finished the work on
    /// another machine and the result should be seen soon. Without waiting: who wants it calls
    /// again, at least once a second. Throws Error if the folder cannot be written to, or a file in
    /// it cannot be made, locked or read.
    [[nodiscard]] std::optional<Claim> claim(const std::string& name);

    /// For people, a sentence without its full stop about who has the claim on `name`, since when,
    /// and how long ago this process saw its last sign of life; empty if nobody has it. Throws
    /// Error if a claim cannot be read.
    [[nodiscard]] std::string holder(const std::string& name);

    /// Removes all claims on `name`, whose result is there for all machines.
    void forget(const std::string& name) const;

    /// Removes the claims of processes of this machine that have ended, except finished ones that
    /// are kept.
    void remove_dead() const;

  private:
    friend struct Claim::Held;

    /// A claim of another process and since when it has not changed.
    struct Seen {
        ClaimNote note;
        std::chrono::steady_clock::time_point since;
    };
    /// The last of the claims on a name, the number of the one after it, from 0.
    struct Last {
        std::optional<ClaimNote> note;
        int next = 0;
    };
    /// A claim of this process whose work is done. Others may have removed it since.
    struct Finished {
        std::string name;
        int number = 0;
        ClaimNote note;
    };
    /// Removes the claims up to one of this process, the lowest number first: as long as its own is
    /// there, nobody takes a dead one below it for the last one.
    void remove(const std::string& name, int last) const;
    [[nodiscard]] Last last_of(const std::string& name) const;
    /// The file of the claim with that number.
    [[nodiscard]] std::string path(const std::string& name, int number) const;
    [[nodiscard]] bool is_dead(const std::string& path, const ClaimNote& note);
    [[nodiscard]] FileDescriptor make_draft(const std::string& path, const ClaimNote& note) const;
    [[nodiscard]] std::unique_ptr<Claim::Held> make(const std::string& name, int number,
                                                    const std::optional<ClaimNote>& replaced);

    std::string folder_;
    ClaimTimes times_;
    std::mutex mutex_;
    std::map<std::string, Seen> seen_;  // by path
    std::vector<Finished> finished_;
};

}  // namespace carom::pipeline
