#include "tests/pipeline/cli/program_run.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/folders.h"
#include "tests/scratch_folder.h"

namespace carom::testing {

namespace {

std::string temporary_file() {
    std::string name = ::testing::TempDir() + "/carom-run-XXXXXX";
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) {
        throw std::runtime_error("no temporary file");
    }
    ::close(descriptor);
    return name;
}

void redirect(const char* path, int flags, int descriptor) {
    const int opened = ::open(path, flags);
    if (opened < 0 || ::dup2(opened, descriptor) < 0) {
        ::_exit(127);
    }
    ::close(opened);
}

}  // namespace

RunningProgram::RunningProgram(const std::string& program,
                               const std::vector<std::string>& arguments, const RunOptions& options)
    : out_path_(temporary_file()), err_path_(temporary_file()) {
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);

    process_ = ::fork();
    if (process_ == 0) {
        redirect("/dev/null", O_RDONLY, STDIN_FILENO);
        redirect(out_path_.c_str(), O_WRONLY, STDOUT_FILENO);
        redirect(err_path_.c_str(), O_WRONLY, STDERR_FILENO);
        for (const auto& [name, value] : options.environment) {
            ::setenv(name.c_str(), value.c_str(), 1);
        }
        if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) {
            ::_exit(127);
        }
        ::execv(program.c_str(), pointers.data());
        ::_exit(127);
    }
}

RunningProgram::~RunningProgram() {
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    ::unlink(out_path_.c_str());
    ::unlink(err_path_.c_str());
}

void RunningProgram::send(int signal) const {
    ::kill(process_, signal);
}

std::string RunningProgram::err_so_far() const {
    return read_text(err_path_);
}

RunResult RunningProgram::wait() {
    int status = 0;
    rusage usage{};
    while (::wait4(process_, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    process_ = -1;
    RunResult result;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.out = read_text(out_path_);
    result.err = read_text(err_path_);
    result.peak_memory = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
    return result;
}

RunResult run_carom(const std::vector<std::string>& arguments, const RunOptions& options) {
    return RunningProgram(carom_program(), arguments, options).wait();
}

std::string carom_program() {
    return CAROM_BINARY_DIR "/bin/carom";
}

std::string carom_film_program() {
    return CAROM_BINARY_DIR "/libexec/carom/carom-film";
}

std::string carom_draw_program() {
    return CAROM_BINARY_DIR "/libexec/carom/carom-draw";
}

}  // namespace carom::testing
