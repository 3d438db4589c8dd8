// Short pieces of work of a session that its callers must not wait for.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace carom::studio {

/// Does them one after the other in a thread of its own. They must not throw.
class Errands {
  public:
    Errands() : thread_([this](const std::stop_token& end) { run(end); }) {}

    /// Returns false, and drops the work, if too much waits already. May be called from any thread.
    bool post(std::function<void()> work) {
        const std::lock_guard lock(mutex_);
        if (waiting_.size() >= kMost) {
            return false;
        }
        waiting_.push_back(std::move(work));
        wake_.notify_one();
        return true;
    }

    /// As post(), however much waits.
    void post_always(std::function<void()> work) {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(work));
        wake_.notify_one();
    }

    /// Waits for the end of the work under way and drops the rest. There will be no other.
    void end() {
        thread_.request_stop();
        if (thread_.joinable()) {
            thread_.join();
        }
        std::deque<std::function<void()>> dropped;  // what they hold may take a while to end
        {
            const std::lock_guard lock(mutex_);
            dropped.swap(waiting_);
        }
    }

  private:
    static constexpr std::size_t kMost = 16;

    void run(const std::stop_token& end) {
        for (;;) {
            std::function<void()> work;
            {
                std::unique_lock lock(mutex_);
                if (!wake_.wait(lock, end, [&] { return !waiting_.empty(); }) ||
                    end.stop_requested()) {
                    return;
                }
                work = std::move(waiting_.front());
                waiting_.pop_front();
            }
            work();
        }
    }

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::deque<std::function<void()>> waiting_;
    std::jthread thread_;  // ends first
};

}  // namespace carom::studio
