#include "pipeline/cli/terminal/interrupts.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include "core/error.h"

namespace carom::cli {

namespace {

constexpr std::array kStopSignals{SIGINT, SIGTERM, SIGHUP};
constexpr int kInterruptedExitCode = 130;

constexpr char kSignalled = 's';
constexpr char kFinished = 'f';

// A signal handler may only use lock-free atomics and the pipe to the watching thread. It must not
// trigger a stop_source, since that runs callbacks and takes locks.
std::atomic<int> signal_count{0};
std::atomic<int> pipe_to_watcher{-1};
static_assert(std::atomic<int>::is_always_lock_free);

void handle_signal(int /*signal*/) {
    const int saved_error = errno;
    if (signal_count.fetch_add(1) > 0) {
        ::_exit(kInterruptedExitCode);
    }
    static_cast<void>(!::write(pipe_to_watcher.load(), &kSignalled, 1));
    errno = saved_error;
}

void install(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    ::sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
    struct sigaction action {};
    return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

Interrupts::Interrupts(std::function<void()> on_interrupt)
    : on_interrupt_(std::move(on_interrupt)) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw Error("cannot create a pipe to handle signals: " +
                    std::generic_category().message(errno));
    }
    signal_count = 0;
    pipe_to_watcher = ends[1];
    watcher_ = std::thread([this, read_end = ends[0]] {
        char what = kFinished;
        while (::read(read_end, &what, 1) < 0 && errno == EINTR) {
        }
        if (what == kSignalled) {
            on_interrupt_();
            source_.request_stop();
            // The destructor will still write its byte.
            while (::read(read_end, &what, 1) < 0 && errno == EINTR) {
            }
        }
        ::close(read_end);
    });
    install(SIGPIPE, SIG_IGN);
    for (const int signal : kStopSignals) {
        if (!is_ignored(signal)) {
            install(signal, handle_signal);
        }
    }
}

Interrupts::~Interrupts() {
    for (const int signal : kStopSignals) {
        if (!is_ignored(signal)) {
            install(signal, SIG_DFL);
        }
    }
    const int write_end = pipe_to_watcher.exchange(-1);
    static_cast<void>(!::write(write_end, &kFinished, 1));
    watcher_.join();
    ::close(write_end);
}

}  // namespace carom::cli
