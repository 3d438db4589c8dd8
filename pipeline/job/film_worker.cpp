#include "pipeline/job/film_worker.h"

#include <algorithm>
#include <bit>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <numeric>

#include "core/error.h"
#include "pipeline/job/cached_renderer.h"
#include "pipeline/job/job_frames.h"

namespace carom::pipeline {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPollInterval{1};

/// Of the order every `of`th from `number` on, then the rest.
std::deque<std::size_t> own_share_first(const std::vector<std::size_t>& order, std::size_t number,
                                        std::size_t of) {
    std::deque<std::size_t> own;
    std::deque<std::size_t> others;
    for (std::size_t i = 0; i < order.size(); ++i) {
        // The rest is begun elsewhere, too.
        (i % of == number ? own : others).push_back(order[i]);
    }
    const std::size_t first = others.empty() ? 0 : number * others.size() / of;
    std::rotate(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(first), others.end());
    own.insert(own.end(), others.begin(), others.end());
    return own;
}

void wait(std::chrono::milliseconds time, const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    wake.wait_for(lock, stop, time, [] { return false; });
}

class Worker {
  public:
    Worker(const FilmPlan& plan, CachedRenderer& renderer, const WorkerOptions& options,
           const std::function<void(const WorkerState&)>& on_state)
        : plan_(plan),
          renderer_(renderer),
          end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(options.budget)),
          on_state_(on_state),
          waiting_(own_share_first(bit_reversed_order(plan.pictures.size()), options.number,
                                   options.of)) {
        state_.pictures = std::ssize(plan.pictures);
    }

    WorkerResult run(const std::stop_token& stop) {
        while (!waiting_.empty() && Clock::now() < end_) {
            if (!pass(stop) && Clock::now() < end_) {
                tell(-1, 0);
                wait(kPollInterval, stop);
            }
            if (stop.stop_requested()) {
                throw Stopped();
            }
        }
        tell(-1, 0);
        return {state_, waiting_.empty()};
    }

  private:
    /// Tries each waiting picture once. Returns whether any is there now.
    bool pass(const std::stop_token& stop) {
        std::deque<std::size_t> left;
        bool is_any = false;
        while (!waiting_.empty() && Clock::now() < end_) {
            if (stop.stop_requested()) {
                throw Stopped();
            }
            const std::size_t picture = waiting_.front();
            if (render(picture, stop)) {
                is_any = true;
            } else {
                left.push_back(picture);
            }
            waiting_.pop_front();
        }
        waiting_.insert(waiting_.begin(), left.begin(), left.end());
        return is_any;
    }

    bool render(std::size_t picture, const std::stop_token& stop) {
        const std::int64_t frame = plan_.pictures[picture].frame;
        WorkContext context;
        context.stop = stop;
        context.progress = [this, frame](double fraction) {
            const std::lock_guard lock(mutex_);
            const auto now = Clock::now();
            if (now - told_ >= kPollInterval) {
                tell(frame, fraction);
            }
        };
        const CachedRender result = renderer_.render(plan_.pictures[picture], context);
        if (result.origin == RenderOrigin::claimed_elsewhere) {
            return false;
        }
        ++state_.finished;
        if (result.origin == RenderOrigin::rendered) {
            ++state_.rendered;
            state_.twice += result.twice ? 1 : 0;
            state_.continued += result.continued ? 1 : 0;
            tell(frame, 1);
        }
        return true;
    }

    void tell(std::int64_t frame, double fraction) {
        told_ = Clock::now();
        state_.frame = frame;
        state_.fraction = fraction;
        state_.seconds_left = std::max(0.0, std::chrono::duration<double>(end_ - told_).count());
        if (on_state_) {
            on_state_(state_);
        }
    }

    const FilmPlan& plan_;
    CachedRenderer& renderer_;
    Clock::time_point end_;
    const std::function<void(const WorkerState&)>& on_state_;
    std::deque<std::size_t> waiting_;
    std::mutex mutex_;  // progress is told by any thread
    WorkerState state_;
    Clock::time_point told_{};
};

}  // namespace

std::vector<std::size_t> bit_reversed_order(std::size_t count) {
    std::vector<std::size_t> order;
    const std::size_t whole = std::bit_ceil(count);
    std::size_t reversed = 0;
    for (std::size_t i = 0; i < whole; ++i) {
        if (reversed < count) {
            order.push_back(reversed);
        }
        // Adds one at the left end, with the carry to the right.
        std::size_t bit = whole / 2;
        while (bit != 0 && (reversed & bit) != 0) {
            reversed ^= bit;
            bit /= 2;
        }
        reversed |= bit;
    }
    return order;
}

WorkerResult work_on_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                          const WorkerOptions& worker, const JobObserver& observer,
                          const std::function<void(const WorkerState&)>& on_state,
                          const std::stop_token& stop) {
    ThreadSafeObserver safe_observer(observer);
    DamageReport damages(safe_observer);
    const FrameStore store = open_store(options, damages);
    const FilmSource source(shot, bake.timeline, options.tier);
    const FilmPlan plan = plan_film(source, job_frames(shot, options), stop);
    CachedRenderer renderer(source, store, renderer_of(shot, options), options.keeps_sums,
                            options.threads);
    return Worker(plan, renderer, worker, on_state).run(stop);
}

}  // namespace carom::pipeline
