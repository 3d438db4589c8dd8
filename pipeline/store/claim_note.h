// What the file of a claim says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace carom::pipeline {

struct ClaimNote {
    enum class State { working, finished };
    std::string host;        // this_host() of the owner
    std::string process;     // differs for all processes and claims of a host
    std::uint64_t beat = 0;  // counted up while the owner works
    State state = State::working;
    std::string since{};  // when the claim was made, by the owner's clock, for people

    bool operator==(const ClaimNote&) const = default;
};

/// As text, which has the same length for every beat and state.
[[nodiscard]] std::string text_of(const ClaimNote& note);

/// Empty if the text is not that of a note.
[[nodiscard]] std::optional<ClaimNote> parse_claim_note(const std::string& text);

/// The note in a file; empty if there is no such file. The note of a file that cannot be understood
/// has an empty host. Throws Error if it cannot be read: at once if permission is missing or if it
/// is no file, else three times in a row, since network file systems fail for a moment. The file is
/// opened anew, because they look at the server's file only then.
[[nodiscard]] std::optional<ClaimNote> read_claim_note(const std::string& path);

/// The machine's name and what tells this run of it from others. The nodes of a Slurm cluster that
/// share a machine are hosts of their own.
[[nodiscard]] const std::string& this_host();

/// Begins the names of files that are only for processes of this machine.
[[nodiscard]] std::string host_prefix();

/// A new value for ClaimNote::process: the process's number, which another one in another container
/// may have, too, a random number, and a count.
[[nodiscard]] std::string new_claim_process();

/// The time of this machine as ClaimNote::since has it: "2026-11-29T07:40:18Z".
[[nodiscard]] std::string time_now();

/// Whose claim it is, for people: "process 4711 on n7".
[[nodiscard]] std::string owner_of(const ClaimNote& note);

}  // namespace carom::pipeline
