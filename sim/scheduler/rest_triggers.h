// Triggers that fire when a body comes to rest.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/force_event.h"
#include "sim/path_detectors.h"

namespace carom::sim {

/// How the objects of the world move at present. An empty name stands for all objects.
struct MotionQuery {
    /// True if at least one of the objects has left the place where it last rested.
    std::function<bool(const std::string&)> is_moving;
    /// True if all of the objects rest. A body that has just been put down neither moves nor rests.
    std::function<bool(const std::string&)> is_resting;
};

/// An event happens when the object that it waits for rests after having moved. Events that wait
/// for the same object happen in the order of the list: each one needs a motion that begins when
/// the previous one acts, or later. An event that waits for the nth rest needs n motions.
class RestTriggers {
  public:
    explicit RestTriggers(const std::vector<ForceEvent>& events);

    [[nodiscard]] bool is_empty() const { return waiting_.empty(); }

    /// Event `event` acts now: the next one that waits for the same object begins its wait.
    void note_action(std::size_t event);

    /// Event `event` has put a ball somewhere, which sets nothing in motion: the next one that
    /// waits for the same object needs no motion after it.
    void note_placed(std::size_t event);

    /// Removes and returns the events whose wait ends at `now`, in the order of the list.
    [[nodiscard]] std::vector<std::size_t> take_rested(double now, const MotionQuery& query);

    /// Why event `event`, which still waits, has not happened: "'cue' never moved, ...".
    [[nodiscard]] std::string reason(std::size_t event) const;

  private:
    struct Wait {
        std::optional<std::size_t> predecessor;  // the previous event that waits for this object
        bool has_begun = true;                   // false: the predecessor has not acted yet
        RestDetector detector;                   // since it began
        int rests = 0;                           // likewise
    };

    const std::vector<ForceEvent>& events_;
    std::map<std::size_t, Wait> waiting_;  // by event
};

}  // namespace carom::sim
