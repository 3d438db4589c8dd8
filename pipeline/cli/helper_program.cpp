#include "pipeline/cli/helper_program.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "core/write_all.h"

namespace carom::cli {

namespace {

std::string reason_of(int error) {
    return std::generic_category().message(error);
}

/// An anonymous file in memory. Unlike a pipe it never blocks either side.
class MemoryFile {
  public:
    MemoryFile() : descriptor_(::memfd_create("carom", MFD_CLOEXEC)) {
        if (descriptor_ < 0) {
            throw Error("cannot create a file in memory: " + reason_of(errno));
        }
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }

    void fill(std::span<const std::byte> bytes) const {
        if (!write_all(descriptor_, bytes)) {
            throw Error("cannot write to a file in memory: " + reason_of(errno));
        }
        ::lseek(descriptor_, 0, SEEK_SET);
    }

    [[nodiscard]] std::vector<std::byte> content() const {
        std::vector<std::byte> bytes;
        std::array<std::byte, 1 << 16> block{};
        ::lseek(descriptor_, 0, SEEK_SET);
        while (true) {
            const ssize_t size = ::read(descriptor_, block.data(), block.size());
            if (size < 0 && errno == EINTR) {
                continue;
            }
            if (size <= 0) {
                return bytes;
            }
            bytes.insert(bytes.end(), block.begin(), block.begin() + size);
        }
    }

  private:
    int descriptor_;
};

class FileActions {
  public:
    FileActions() { ::posix_spawn_file_actions_init(&actions_); }
    ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    void connect(const MemoryFile& file, int as) {
        ::posix_spawn_file_actions_adddup2(&actions_, file.descriptor(), as);
    }
    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

/// Waits until the process ends and returns its wait status.
int wait_for(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0) {
        if (errno != EINTR) {
            throw Error("cannot wait for a program that was started: " + reason_of(errno));
        }
    }
    return status;
}

std::string cannot_start(const std::string& what, const std::string& path, int reason,
                         const std::string& question) {
    return "cannot start " + what + " '" + path + "': " + reason_of(reason) + "; " + question;
}

}  // namespace

std::string helper_path(const std::string& name) {
    const char* laboratory = std::getenv("CAROM_LAB");
    if (name == "carom-lab" && laboratory != nullptr) {
        return laboratory;
    }
    std::error_code ignored;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::filesystem::path folder = self.parent_path();
    const std::filesystem::path above = folder.parent_path();
    const bool is_helper = above.filename() == "libexec";  // else in bin/
    return ((is_helper ? folder : above / "libexec" / "carom") / name).string();
}

void exec_program(const std::string& name, char** arguments) {
    const std::string path = helper_path(name);
    ::execv(path.c_str(), arguments);
    const int reason = errno;
    if (name == "carom-lab") {
        throw Error(cannot_start("the laboratory", path, reason,
                                 "it is built by the target carom-lab and installed by the package "
                                 "carom-lab"));
    }
    if (name == "carom-studio") {
        throw Error(cannot_start("the studio", path, reason,
                                 "in carom's source tree 'scripts/run studio' builds it"));
    }
    throw Error(cannot_start("the renderer", path, reason, "is carom installed completely?"));
}

std::vector<std::byte> run_helper(const std::string& name, const std::string& what,
                                  const std::string& argument, std::span<const std::byte> input) {
    std::string path = helper_path(name);
    std::string word = argument;
    const std::array<char*, 3> arguments{path.data(), word.data(), nullptr};
    const MemoryFile in;
    const MemoryFile out;
    in.fill(input);
    FileActions actions;
    actions.connect(in, STDIN_FILENO);
    actions.connect(out, STDOUT_FILENO);
    pid_t process = 0;
    const int error =
        ::posix_spawn(&process, path.c_str(), actions.get(), nullptr, arguments.data(), environ);
    if (error != 0) {
        throw Error(cannot_start(what, path, error, "is carom installed completely?"));
    }
    const int status = wait_for(process);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        throw Error(what + " failed");
    }
    return out.content();
}

}  // namespace carom::cli
