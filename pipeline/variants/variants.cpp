#include "pipeline/variants/variants.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "core/error.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {

namespace {

/// What several threads have done of the parts.
class Parts {
  public:
    Parts(std::size_t count, const PartsWork& work) : count_(count), work_(work) {}

    void run(std::size_t i, const std::function<void(std::size_t)>& part) {
        if (i > first_failed_ || work_.context.stop.stop_requested()) {
            return;
        }
        try {
            part(i);
            note_done();
        } catch (const Stopped&) {
            return;  // finish() says so
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (i < first_failed_) {
                first_failed_ = i;
                failure_ = std::current_exception();
            }
        }
    }

    void finish() const {
        if (work_.context.stop.stop_requested()) {
            throw Stopped();
        }
        if (failure_) {
            std::rethrow_exception(failure_);
        }
    }

  private:
    void note_done() {
        if (work_.context.progress) {
            const std::lock_guard lock(mutex_);
            ++done_;
            work_.context.progress(static_cast<double>(done_) / static_cast<double>(count_));
        }
    }

    std::size_t count_;
    const PartsWork& work_;
    std::atomic<std::size_t> first_failed_{~std::size_t{0}};
    std::mutex mutex_;
    std::size_t done_ = 0;
    std::exception_ptr failure_;
};

}  // namespace

void do_parts(std::size_t count, const std::function<void(std::size_t)>& part,
              const PartsWork& work) {
    Parts parts(count, work);
    // oneTBB prints a warning when it is asked for more.
    const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    render::ThreadArena arena(std::min(work.threads, processors));
    arena.execute([&] { render::parallel_for(count, [&](std::size_t i) { parts.run(i, part); }); });
    parts.finish();
}

std::vector<std::optional<sim::Outcome>> run_variants(const sim::Trials& trials, std::size_t count,
                                                      const VariantOf& variant_of,
                                                      const PartsWork& work) {
    std::vector<std::optional<sim::Outcome>> outcomes(count);
    do_parts(
        count,
        [&](std::size_t i) {
            ShotVariant variant = variant_of(i);
            variant.limits.stop = work.context.stop;
            outcomes[i] = trials.run(std::move(variant.events), variant.limits);
        },
        work);
    return outcomes;
}

}  // namespace carom::pipeline
