#include "pipeline/job/frame_grace.h"

#include <condition_variable>
#include <mutex>
#include <system_error>

namespace carom::pipeline {
namespace {

constexpr std::chrono::seconds kGrace{2};

/// Waits for `time` or until `done` is requested. Returns whether the whole time has passed.
bool wait_for(std::chrono::seconds time, const std::stop_token& done) {
    std::mutex mutex;
    std::condition_variable_any never_notified;
    std::unique_lock lock(mutex);
    never_notified.wait_for(lock, done, time, [] { return false; });
    return !done.stop_requested();
}

}  // namespace

FrameGrace::FrameGrace(const std::stop_token& stop, double expected)
    : expected_(expected), callback_(stop, [this] { job_stopped(); }) {}

void FrameGrace::job_stopped() {
    const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
    const double fraction = fraction_;
    const double whole = fraction > 0 ? elapsed / fraction : expected_;
    if (whole <= 0 || whole - elapsed >= std::chrono::duration<double>(kGrace).count()) {
        frame_stop_.request_stop();
        return;
    }
    try {
        watchdog_ = std::jthread([this](const std::stop_token& frame_done) {
            if (wait_for(kGrace, frame_done)) {
                frame_stop_.request_stop();
            }
        });
    } catch (const std::system_error&) {  // no thread can be started, and no caller to report it to
        frame_stop_.request_stop();
    }
}

void FrameGrace::progress(double fraction) {
    fraction_ = fraction;
}

}  // namespace carom::pipeline
