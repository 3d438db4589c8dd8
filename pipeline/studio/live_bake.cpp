#include "pipeline/studio/live_bake.h"

namespace carom::studio {
namespace {

// Of processor time, s.
constexpr double kShortest = 0.1;  // a simulation runs at least so long
constexpr double kSlow = 0.3;  // a simulation that takes longer is not done for each move of a drag

}  // namespace

std::stop_token LiveBake::begin(bool unlimited) {
    const std::lock_guard lock(mutex_);
    running_ = std::stop_source();
    if (has_ended_) {
        running_.request_stop();
    }
    began_ = clock_();
    is_running_ = true;
    may_stop_ = !unlimited && !was_stopped_;
    return running_.get_token();
}

void LiveBake::finish(bool stopped) {
    const std::lock_guard lock(mutex_);
    is_running_ = false;
    was_stopped_ = stopped;
    was_slow_ = seconds() > kSlow;
    last_end_ = Clock::now();
}

void LiveBake::stop() {
    const std::lock_guard lock(mutex_);
    running_.request_stop();
}

void LiveBake::stop_for_newer() {
    const std::lock_guard lock(mutex_);
    if (is_running_ && may_stop_ && seconds() > kShortest) {
        running_.request_stop();
    }
}

void LiveBake::end() {
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    running_.request_stop();
}

bool LiveBake::has_ended() {
    const std::lock_guard lock(mutex_);
    return has_ended_;
}

bool LiveBake::takes_long() {
    const std::lock_guard lock(mutex_);
    return seconds() > kSlow;
}

bool LiveBake::was_slow() {
    const std::lock_guard lock(mutex_);
    return was_slow_;
}

LiveBake::Clock::time_point LiveBake::last_end() {
    const std::lock_guard lock(mutex_);
    return last_end_;
}

}  // namespace carom::studio
