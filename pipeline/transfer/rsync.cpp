#include "pipeline/transfer/rsync.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "core/write_all.h"
#include "pipeline/store/file_descriptor.h"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace carom::transfer {
namespace {

using pipeline::FileDescriptor;

constexpr int kPollMilliseconds = 100;

std::string reason_of(int error) {
    return std::generic_category().message(error);
}

/// A file in memory with this content. Unlike a pipe it never blocks either side.
FileDescriptor memory_file(const std::string& content) {
    FileDescriptor file(::memfd_create("carom", MFD_CLOEXEC));
    if (!file.is_open() || !write_all(file.get(), std::as_bytes(std::span(content)))) {
        throw Error("cannot create a file in memory: " + reason_of(errno));
    }
    ::lseek(file.get(), 0, SEEK_SET);
    return file;
}

std::string content_of(const FileDescriptor& file) {
    std::string text;
    std::array<char, 1 << 12> block{};
    for (off_t at = 0;;) {
        const ssize_t size = ::pread(file.get(), block.data(), block.size(), at);
        if (size <= 0) {
            return text;
        }
        text.append(block.data(), static_cast<std::size_t>(size));
        at += size;
    }
}

/// The variables of this process, but messages in English, since one of them is looked for.
std::vector<std::string> english_environment() {
    std::vector<std::string> variables{"LC_ALL=C"};
    for (char** variable = environ; *variable != nullptr; ++variable) {
        if (std::strncmp(*variable, "LC_ALL=", 7) != 0) {
            variables.emplace_back(*variable);
        }
    }
    return variables;
}

/// The words as a program receives them. They must outlive the result.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

/// Starts rsync with these three streams.
pid_t start(const RsyncCall& call, const FileDescriptor& in, const FileDescriptor& out,
            const FileDescriptor& errors) {
    std::vector<std::string> words{"rsync", "-s"};  // -s: no shell there splits names of files
    words.insert(words.end(), call.options.begin(), call.options.end());
    words.emplace_back("--");
    words.insert(words.end(), call.places.begin(), call.places.end());
    std::vector<std::string> variables = english_environment();
    const std::vector<char*> arguments = pointers_to(words);
    const std::vector<char*> environment = pointers_to(variables);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, in.get(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, out.get(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, errors.get(), STDERR_FILENO);
    pid_t process = 0;
    const int failure =
        ::posix_spawnp(&process, "rsync", &files, nullptr, arguments.data(), environment.data());
    ::posix_spawn_file_actions_destroy(&files);
    if (failure == ENOENT) {
        throw Error(
            "rsync is not installed; it copies files between caches (on Debian 'apt install "
            "rsync')");
    }
    if (failure != 0) {
        throw Error("rsync cannot be started: " + reason_of(failure));
    }
    return process;
}

/// Passes on whole lines until the other end is closed.
void read_lines(const FileDescriptor& out, const std::function<void(const std::string&)>& on_line,
                const std::function<void()>& on_pause) {
    std::string text;
    std::array<char, 1 << 12> block{};
    while (true) {
        on_pause();
        pollfd ready{out.get(), POLLIN, 0};
        if (::poll(&ready, 1, kPollMilliseconds) <= 0) {
            continue;
        }
        const ssize_t size = ::read(out.get(), block.data(), block.size());
        if (size < 0 && errno == EINTR) {
            continue;
        }
        if (size <= 0) {
            return;
        }
        text.append(block.data(), static_cast<std::size_t>(size));
        for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
            if (on_line) {
                on_line(text.substr(0, end));
            }
            text.erase(0, end + 1);
        }
    }
}

int wait_for(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

RsyncResult run_rsync(const RsyncCall& call,
                      const std::function<void(const std::string& line)>& on_line,
                      const std::stop_token& stop) {
    const FileDescriptor in = memory_file(call.input);
    const FileDescriptor errors = memory_file("");
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw Error("cannot create a pipe: " + reason_of(errno));
    }
    const FileDescriptor out(ends[0]);
    FileDescriptor inlet(ends[1]);
    const pid_t process = start(call, in, inlet, errors);
    inlet.reset();  // so that the end of rsync is the end of its output
    bool is_stopped = false;
    try {
        read_lines(out, on_line, [&] {
            if (stop.stop_requested() && !is_stopped) {
                is_stopped = true;
                ::kill(process, SIGTERM);
            }
        });
    } catch (...) {
        ::kill(process, SIGTERM);
        (void)wait_for(process);
        throw;
    }
    const int code = wait_for(process);
    if (stop.stop_requested()) {
        throw Stopped();
    }
    return {code, content_of(errors)};
}

void throw_rsync_error(const std::string& what, const RsyncResult& result) {
    std::string text;
    std::istringstream in(result.errors);
    for (std::string line; std::getline(in, line);) {
        text += (text.empty() ? "" : "; ") + line;
    }
    throw Error(fmt::format("{}: rsync ended with exit code {}{}{}", what, result.exit_code,
                            text.empty() ? "" : ": ", text));
}

bool is_remote(const std::string& place) {
    const std::size_t colon = place.find(':');
    return colon != std::string::npos && colon < place.find('/');
}

std::string rsync_place(const std::string& folder) {
    if (folder.empty()) {
        throw Error("the name of a cache is empty");
    }
    if (!is_remote(folder)) {
        const std::string path = folder.starts_with('-') ? "./" + folder : folder;
        return path + "/";
    }
    if (folder.starts_with('-')) {
        throw Error("'" + folder + "' is not the name of a machine: it begins with a dash");
    }
    return folder + (folder.ends_with(':') ? "./" : "/");  // "host:" is the user's home there
}

}  // namespace carom::transfer
