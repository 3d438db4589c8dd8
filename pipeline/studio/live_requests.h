// The texts of a live shot that wait for an answer.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>

#include "pipeline/studio/live_bake.h"
#include "pipeline/studio/live_shot.h"

namespace carom::studio {

struct LiveRequest {
    TextsOfVersion texts;
    bool unlimited = false;  // the user asked for the simulation
};

/// Keeps the newest request only. One thread answers; all functions may be called from any thread.
class LiveRequests {
  public:
    /// Its mutex is taken after the one of the requests.
    explicit LiveRequests(LiveBake& bake) : bake_(bake) {}

    // As in LiveShot.
    void offer(TextsOfVersion texts);
    void set_dragging(bool on);
    void simulate();

    /// Waits for the next request, or for the time of a deferred one. Empty: `end` was requested,
    /// or the simulations have ended.
    [[nodiscard]] std::optional<LiveRequest> next(const std::stop_token& end);

    /// Whether another request waits, or nothing is wanted any more.
    [[nodiscard]] bool has_newer();

    /// The texts that wait; empty if there are none, or if they are of that version.
    [[nodiscard]] std::optional<TextsOfVersion> other_than(std::int64_t v);

    /// Whether a slow shot has to wait during a drag: until its end, or for half a second, so that
    /// every drag is answered. `has_motion`: the page shows one.
    [[nodiscard]] bool defer(bool has_motion);

  private:
    LiveBake& bake_;

    std::mutex mutex_;  // of the members below
    std::condition_variable_any wake_;
    std::optional<LiveRequest> waiting_;
    TextsOfVersion newest_;
    bool dragging_ = false;
    /// Until when the newest texts wait during the drag; empty: they do not.
    std::optional<LiveBake::Clock::time_point> deferred_;
};

}  // namespace carom::studio
