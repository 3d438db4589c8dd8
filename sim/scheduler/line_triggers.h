// Triggers that fire when a body crosses a line.
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

/// The lines of a world's crossing triggers. A body crosses a line when its centre, seen from
/// above, passes through the line segment from one side to the other. A body that starts on the
/// line does not cross it by leaving.
class LineTriggers {
  public:
    LineTriggers(const std::vector<ForceEvent>& events, const std::vector<StepBody>& bodies);

    [[nodiscard]] bool is_empty() const { return waiting_ == 0; }
    /// Adds to the queue the crossings of waiting lines by a ball, or by a body that ODE steps, in
    /// [now, until]. `number`: index of the ball or body.
    void predict_crossings(std::uint32_t number, const Ball& ball, double now, double until,
                           PredictedEventQueue& queue);
    void predict_crossings(std::uint32_t number, const StepBody& body, double now, double until,
                           std::uint32_t window_number, PredictedEventQueue& queue);

    /// The line has been crossed and waits no longer. Returns the index of the world's event that
    /// it triggers; empty if the line was crossed before.
    [[nodiscard]] std::optional<std::size_t> trigger(std::uint32_t line);

  private:
    void predict_crossings(const PredictedEvent& event, const MotionSegment& path, double now,
                           double until, PredictedEventQueue& queue);

    struct Line {
        std::size_t event = 0;
        std::uint32_t body = 0;
        Vec2 from{0, 0}, along{1, 0}, across{0, 1};  // `along` and `across` are unit
        double length = 0;
        double since = 0;  // scene time from which crossings count
        int side = 0;      // side on which the body last was clearly; 0: neither yet
        bool is_waiting = true;
    };
    [[nodiscard]] static std::optional<double> first_crossing(Line& line, const MotionSegment& path,
                                                              double now, double until);

    std::vector<Line> lines_;
    std::size_t waiting_ = 0;
};

}  // namespace carom::sim
