// Parallel work: oneTBB, or threads of our own for the thread sanitizer, which cannot see into
// Debian's oneTBB (CAROM_OWN_THREADS).
#pragma once

#include <cstddef>
#include <utility>

#ifdef CAROM_OWN_THREADS
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace carom::render {

#ifndef CAROM_OWN_THREADS

/// Work that runs in the arena uses this number of threads.
class ThreadArena {
  public:
    /// 0: one per processor.
    explicit ThreadArena(int threads)
        : arena_(threads > 0 ? threads : tbb::task_arena::automatic) {}

    /// Returns what the work returns.
    template <class Work>
    decltype(auto) execute(Work&& work) {
        return arena_.execute(std::forward<Work>(work));
    }

  private:
    tbb::task_arena arena_;
};

/// Calls body(i) for every i < count, concurrently and in any order; rethrows an exception of a
/// call.
template <class Body>
void parallel_for(std::size_t count, const Body& body) {
    tbb::parallel_for(std::size_t{0}, count, body, tbb::simple_partitioner());
}

#else

inline thread_local unsigned threads_of_arena = 0;  // 0: one per processor

class ThreadArena {
  public:
    explicit ThreadArena(int threads) : threads_(static_cast<unsigned>(threads)) {}

    template <class Work>
    decltype(auto) execute(Work&& work) {
        struct Restored {
            unsigned before;
            ~Restored() { threads_of_arena = before; }
        };
        const Restored restored{std::exchange(threads_of_arena, threads_)};
        return std::forward<Work>(work)();
    }

  private:
    unsigned threads_;
};

template <class Body>
void parallel_for(std::size_t count, const Body& body) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto run = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                body(i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                failure = std::current_exception();
                next = count;
            }
        }
    };
    const unsigned wanted =
        threads_of_arena > 0 ? threads_of_arena : std::thread::hardware_concurrency();
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < std::min<std::size_t>(wanted, count); ++i) {
            others.emplace_back(run);
        }
        run();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

#endif

}  // namespace carom::render
