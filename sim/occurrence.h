// Finds the occurrences that triggers name among the events of a log.
#pragma once

#include <string>

#include "sim/force_event.h"
#include "sim/timeline/event.h"

namespace carom::sim {

/// Whether the log shows the occurrences of this kind of trigger. Those of the others (rest, a line
/// crossed, an apex) are found from the motion.
[[nodiscard]] bool is_logged(Trigger::Kind kind);

/// Counts the occurrences of a logged trigger while events are given to it in order of time.
class OccurrenceCounter {
  public:
    explicit OccurrenceCounter(const Trigger& trigger) : trigger_(&trigger) {}

    /// True if the event is an occurrence that was not counted before: further impacts of the same
    /// contact (kOneContact) are not.
    [[nodiscard]] bool counts(const Event& event);

  private:
    const Trigger* trigger_;
    double last_contact_ = -1;  // scene time of the last impact of the two objects
};

/// "once", "twice", "3 times".
[[nodiscard]] std::string times_text(int count);

/// Why the occurrence that a trigger names has not happened, if there were `count` of its kind:
/// "'cue' never touched 'one'", "'cue' touched 'one' only once". Not for rest.
[[nodiscard]] std::string why_never(const Trigger& trigger, int count);

}  // namespace carom::sim
