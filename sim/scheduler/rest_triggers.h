// Force events that wait until something comes to rest.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/force_event.h"

namespace carom::sim {

/// How the objects of the world move now. An empty name asks for all of them.
struct MotionQuery {
    /// Something that is named has left the place where it last rested.
    std::function<bool(const std::string&)> is_moving;
    /// Everything that is named rests. A body that has only just been put down does neither.
    std::function<bool(const std::string&)> is_resting;
};

/// An event happens when what it waits for rests after having moved. Events that wait for the same
/// thing take turns in the order of the list: each one needs a motion that begins when the one
/// before it acts, or later.
class RestWatch {
  public:
    explicit RestWatch(const std::vector<ForceEvent>& events);

    [[nodiscard]] bool is_empty() const { return waiting_.empty(); }

    /// Event `event` acts now: the next one that waits for the same thing begins to watch.
    void note_action(std::size_t event);

    /// The events whose wait ends at `now`, in their order. They no longer wait.
    [[nodiscard]] std::vector<std::size_t> take_rested(double now, const MotionQuery& query);

    /// Why event `event`, which still waits, has not happened: "'cue' never moved, ...".
    [[nodiscard]] std::string reason(std::size_t event) const;

  private:
    struct Wait {
        std::optional<std::size_t> predecessor;  // waits for the same thing, earlier in the list
        bool has_begun = true;                   // false: the predecessor has not acted yet
        bool has_moved = false;                  // since it began
    };

    const std::vector<ForceEvent>& events_;
    std::map<std::size_t, Wait> waiting_;  // by event
};

}  // namespace carom::sim
