// Runs rsync, which copies files between machines.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace carom::transfer {

struct RsyncCall {
    std::vector<std::string> options;  // "--list-only"
    std::vector<std::string> places;   // never taken for options; as rsync_place() returns them
    std::string input;                 // on its standard input
};

struct RsyncResult {
    int exit_code = 0;
    std::string errors;  // what it printed on its standard error
};

/// Runs rsync to its end, without a shell here or, for names of files, on another machine.
/// `on_line` receives each line of its output as soon as it is printed. When stopped, rsync is
/// ended with SIGTERM, so that it removes its temporary files. Throws Error if rsync is not
/// installed, Stopped.
[[nodiscard]] RsyncResult run_rsync(const RsyncCall& call,
                                    const std::function<void(const std::string& line)>& on_line,
                                    const std::stop_token& stop);

/// The error of a call that has failed, with what rsync printed.
[[noreturn]] void throw_rsync_error(const std::string& what, const RsyncResult& result);

/// Whether rsync takes the text for a place on another machine: "host:folder", "rsync://host/...".
[[nodiscard]] bool is_remote(const std::string& place);

/// A folder as rsync takes it, so that its contents are meant, not the folder itself. Throws Error
/// if the text is empty or the name of its machine begins with a dash, which the remote shell would
/// take for an option.
[[nodiscard]] std::string rsync_place(const std::string& folder);

}  // namespace carom::transfer
