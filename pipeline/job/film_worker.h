// One of several workers on any number of machines that render the frames of a film together.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

/// What somebody wants of the frames while they are rendered, by the numbers that are told.
struct FrameWishes {
    std::int64_t revision = 0;         // another one for others
    std::set<std::int64_t> preferred;  // before all others
    std::set<std::int64_t> skipped;    // not at all
};

/// What became of a picture that a worker began.
struct FrameAttempt {
    enum class End { rendered, stopped, failed };
    End end = End::rendered;
    std::int64_t frame = 0;  // that shows it
    std::size_t layer = 0;   // of that frame (FilmPlan::Picture)
    double seconds = 0;
    bool twice = false;      // another worker had rendered it, too
    bool continued = false;  // another attempt had begun it
    std::string problem{};   // of one that failed
};

struct WorkerOptions {
    std::size_t number = 0;  // of this worker: where it begins, so that few want the same frame
    std::size_t of = 1;
    std::chrono::duration<double> budget{600};  // no frame is begun afterwards
    /// Asked at most once a second. When the revision has changed the worker looks at all pictures
    /// again, since some may have been taken out of the store.
    std::function<FrameWishes()> wishes{};
    std::function<void(const FrameAttempt&)> on_attempt{};
};

/// What a worker does now.
struct WorkerState {
    std::int64_t frame = -1;     // that it renders; -1: it waits for frames of others
    double fraction = 0;         // of that frame
    double seconds_left = 0;     // of its budget
    std::int64_t rendered = 0;   // pictures
    std::int64_t twice = 0;      // of these, pictures that another worker had rendered, too
    std::int64_t continued = 0;  // of these, pictures that another attempt had begun
    std::int64_t finished = 0;   // pictures of the film that are known to be in the store
    std::int64_t pictures = 0;   // of the film
};

struct WorkerResult {
    WorkerState state;
    bool is_complete = false;  // all pictures but the skipped ones are in the store
};

/// The numbers 0 to count - 1 in bit-reversed order: 0, 4, 2, 6, 1, 5, 3, 7. The first few are
/// spread over the whole film, wherever one stops.
[[nodiscard]] std::vector<std::size_t> bit_reversed_order(std::size_t count);

/// A shot whose frames a worker renders: a whole film, or a part of one of several shots.
struct WorkerFilm {
    const Shot& shot;
    const sim::Bake& bake;
    FilmJobOptions options;  // of which the frames, the cache's folder and how to render are used
    std::int64_t shift = 0;  // from the frames of the shot's own film to those that are told
};

/// Renders pictures that nobody has rendered or claimed, one after the other, until all are there
/// that are wanted or the budget is over. A worker begins with its own share of the bit-reversed
/// order of the first film, goes on with what is left of the others' share, and then with the next
/// film. It waits for pictures that others have claimed when nothing else is left, and renders
/// those whose workers have died. `on_state` is called when the state changes, and every second at
/// least. Throws Error, Stopped.
WorkerResult work_on_films(const std::vector<WorkerFilm>& films, const WorkerOptions& worker,
                           const JobObserver& observer,
                           const std::function<void(const WorkerState&)>& on_state,
                           const std::stop_token& stop);

/// The same with one film.
WorkerResult work_on_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                          const WorkerOptions& worker, const JobObserver& observer,
                          const std::function<void(const WorkerState&)>& on_state,
                          const std::stop_token& stop);

}  // namespace carom::pipeline
