#include "pipeline/studio/child_program.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"

namespace carom::studio {
namespace {

constexpr std::chrono::seconds kPatience{20};  // with a program that was interrupted
constexpr int kLookEvery = 200;                // ms
constexpr int kNiceness = 5;                   // the page comes first
constexpr int kCannotRun = 127;

std::string reason_of(int error) {
    return std::generic_category().message(error);
}

/// What the new process does before it becomes the program. Only functions that are safe after a
/// fork of a process with threads.
[[noreturn]] void become(char* const* words, int errors, pid_t parent) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGINT);
    if (::getppid() != parent) {
        ::_exit(kCannotRun);
    }
    // The signals are blocked until here, because the studio's own handler must not run in the
    // child.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        ::signal(signal, SIG_DFL);
    }
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(errors, STDERR_FILENO);
    static_cast<void>(::nice(kNiceness));
    ::close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);  // the studio's sockets
    ::execv(words[0], words);
    ::_exit(kCannotRun);
}

}  // namespace

ChildProgram::ChildProgram(const std::string& program, const std::vector<std::string>& arguments) {
    if (::access(program.c_str(), X_OK) != 0) {
        throw Error("cannot start '" + program + "': " + reason_of(errno) +
                    "; is carom installed completely?");
    }
    std::vector<std::string> texts{program};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> words;
    words.reserve(texts.size() + 1);
    for (std::string& text : texts) {
        words.push_back(text.data());
    }
    words.push_back(nullptr);
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
        throw Error("cannot start '" + program + "': " + reason_of(errno));
    }
    const pid_t parent = ::getpid();
    sigset_t all;
    sigset_t before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    process_ = ::fork();
    if (process_ == 0) {
        become(words.data(), pipe[1], parent);
    }
    const int error = errno;
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    ::close(pipe[1]);
    errors_ = pipe[0];
    if (process_ < 0) {
        ::close(errors_);
        throw Error("cannot start '" + program + "': " + reason_of(error));
    }
}

ChildProgram::~ChildProgram() {
    interrupt();
    while (next_line()) {
    }
    wait();
    ::close(errors_);
}

std::optional<std::string> ChildProgram::next_line() {
    for (;;) {
        const std::size_t end = read_.find('\n');
        if (end != std::string::npos) {
            std::string line = read_.substr(0, end);
            read_.erase(0, end + 1);
            return line;
        }
        pollfd wanted{errors_, POLLIN, 0};
        const int ready = ::poll(&wanted, 1, kLookEvery);
        if (is_overdue()) {
            signal(SIGKILL);
        }
        if (ready <= 0) {
            continue;
        }
        std::array<char, 4096> bytes{};
        const ssize_t count = ::read(errors_, bytes.data(), bytes.size());
        if (count == 0 || (count < 0 && errno != EINTR)) {
            return std::nullopt;
        }
        read_.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
}

void ChildProgram::signal(int number) {
    const std::lock_guard lock(mutex_);
    if (!ended_) {
        ::kill(process_, number);
    }
}

bool ChildProgram::is_overdue() {
    const std::lock_guard lock(mutex_);
    return interrupted_ && std::chrono::steady_clock::now() - *interrupted_ > kPatience;
}

// A second interruption would end a renderer at once, without its unfinished files being removed.
void ChildProgram::interrupt() {
    {
        const std::lock_guard lock(mutex_);
        if (interrupted_) {
            return;
        }
        interrupted_ = std::chrono::steady_clock::now();
    }
    signal(SIGINT);
}

int ChildProgram::wait() {
    {
        const std::lock_guard lock(mutex_);
        if (ended_) {
            return result_;
        }
    }
    siginfo_t info{};
    while (::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOWAIT) != 0 &&
           errno == EINTR) {
    }
    const std::lock_guard lock(mutex_);  // nobody signals a process of the same number
    int status = 0;
    ::waitpid(process_, &status, 0);
    ended_ = true;
    result_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return result_;
}

}  // namespace carom::studio
