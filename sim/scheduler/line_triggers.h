// Triggers that wait for a body to cross a line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/motion/motion_segment.h"
#include "sim/scheduler/ball_state.h"
#include "sim/scheduler/predicted_event.h"
#include "sim/scheduler/step_body.h"
#include "sim/world.h"

namespace carom::sim {

/// The lines of a world's crossing triggers. A body crosses when its centre, seen from above, goes
/// from one side of the segment to the other through it; one that starts on the line has not
/// crossed it by leaving.
class LineWatch {
  public:
    LineWatch(const std::vector<ForceEvent>& events, const std::vector<StepBody>& bodies);

    [[nodiscard]] bool is_empty() const { return waiting_ == 0; }
    /// Puts the lines into the queue that a ball (its number) or a body that ODE carries crosses in
    /// [now, until] and that wait for it.
    void find(std::uint32_t number, const Ball& ball, double now, double until,
              PredictedEventQueue& queue);
    void find(std::uint32_t number, const StepBody& body, double now, double until,
              std::uint32_t round, PredictedEventQueue& queue);

    /// The line has been crossed, and waits no longer. The event that it triggers: an index into
    /// the world's; none if it has been crossed before.
    [[nodiscard]] std::optional<std::size_t> take(std::uint32_t line);

  private:
    void find(const PredictedEvent& found, const MotionSegment& path, double now, double until,
              PredictedEventQueue& queue);

    struct Line {
        std::size_t event = 0;
        std::uint32_t body = 0;
        Vec2 from{0, 0}, along{1, 0}, across{0, 1};  // `along` and `across` are unit
        double length = 0;
        double since = 0;  // scene time from which on it counts
        int side = 0;      // on which the body was last seen clearly; 0: on none yet
        bool is_waiting = true;
    };
    [[nodiscard]] static std::optional<double> first_crossing(Line& line, const MotionSegment& path,
                                                              double now, double until);

    std::vector<Line> lines_;
    std::size_t waiting_ = 0;
};

}  // namespace carom::sim
