#include "pipeline/farm/program.h"

#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "pipeline/store/file_descriptor.h"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace carom::farm {
namespace {

using pipeline::FileDescriptor;

constexpr int kNotStarted = 127;  // as in a shell

/// Unlike a pipe, a file in memory never blocks the program that writes.
FileDescriptor memory_file() {
    return FileDescriptor(::memfd_create("carom", MFD_CLOEXEC));
}

std::string content(const FileDescriptor& file) {
    std::string text;
    std::array<char, 1 << 16> block{};
    off_t at = 0;
    while (true) {
        const ssize_t size = ::pread(file.get(), block.data(), block.size(), at);
        if (size <= 0) {
            return text;
        }
        text.append(block.data(), static_cast<std::size_t>(size));
        at += size;
    }
}

/// The pointers to the texts and, as the system wants it, a null pointer at the end.
std::vector<char*> pointers_to(const std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (const std::string& text : texts) {
        pointers.push_back(const_cast<char*>(text.c_str()));  // the system does not change them
    }
    pointers.push_back(nullptr);
    return pointers;
}

int wait_for(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Starts a program that prints into these files. Returns the system's error number, or 0.
int start(const std::vector<std::string>& words,
          const std::optional<std::vector<std::string>>& variables, int output, int errors,
          pid_t& process) {
    const std::vector<char*> arguments = pointers_to(words);
    const std::vector<char*> given = variables ? pointers_to(*variables) : std::vector<char*>();
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
    const int failure = ::posix_spawnp(&process, arguments[0], &files, nullptr, arguments.data(),
                                       variables ? given.data() : environ);
    ::posix_spawn_file_actions_destroy(&files);
    return failure;
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& words,
                          const std::optional<std::vector<std::string>>& variables) {
    const FileDescriptor output = memory_file();
    const FileDescriptor errors = memory_file();
    pid_t process = 0;
    if (const int failure = start(words, variables, output.get(), errors.get(), process)) {
        return {
            kNotStarted, "",
            "'" + words[0] + "' cannot be started: " + std::generic_category().message(failure)};
    }
    const int code = wait_for(process);
    return {code, content(output), content(errors)};
}

int run_program_into(int file, const std::vector<std::string>& words,
                     const std::vector<std::string>& variables) {
    pid_t process = 0;
    return start(words, variables, file, file, process) == 0 ? wait_for(process) : kNotStarted;
}

}  // namespace carom::farm
