// Triggers that fire where the path of a body crosses a line or is highest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "sim/path_detectors.h"
#include "sim/scheduler/moving_body.h"
#include "sim/scheduler/predicted_event.h"
#include "sim/world.h"

namespace carom::sim {

/// The crossing and apex triggers of a world (LineDetector, ApexDetector).
class PathTriggers {
  public:
    PathTriggers(const std::vector<ForceEvent>& events, const std::vector<MovingBody>& bodies);

    [[nodiscard]] bool is_empty() const { return waiting_ == 0; }
    /// Adds to the queue the occurrences for which triggers wait on the path of a body in
    /// [now, until]. `number`: its index; `window_number`: of the scheduler's window.
    void predict(std::uint32_t number, const MovingBody& body, double now, double until,
                 std::uint32_t window_number, PredictedEventQueue& queue);

    /// What `trigger` waits for has occurred. Returns the index of the world's event whose trigger
    /// it is; empty if it comes before the time of that event, or if it is counted already.
    [[nodiscard]] std::optional<std::size_t> count(std::uint32_t trigger, double time);

  private:
    struct Watch {
        std::size_t event = 0;
        std::uint32_t body = 0;
        double since = 0;  // scene time from which occurrences count
        int left = 1;      // occurrences until the trigger fires
        double last = -1;  // scene time of the last one
        std::variant<ApexDetector, LineDetector> detector;

        [[nodiscard]] bool is_waiting() const { return left > 0; }
    };

    std::vector<Watch> watches_;
    std::size_t waiting_ = 0;
};

}  // namespace carom::sim
