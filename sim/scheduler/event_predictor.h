// Which touches lie ahead of a ball.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scheduler/ball_state.h"
#include "sim/scheduler/predicted_event.h"
#include "sim/scheduler/static_environment.h"
#include "sim/scheduler/step_body.h"
#include "sim/spatial/cell_grid.h"

namespace carom::sim {

/// From when to when touches are looked for.
struct SearchHorizon {
    double now = 0;
    double end = 0;       // of the simulation
    double step_end = 0;  // of what ODE is trying; `end` if it tries nothing
};

/// Predictions are made when a ball begins a segment, as far as that segment goes, and hold until
/// either ball's version changes. Balls are compared with those in the neighbouring cells of a
/// grid, and again with the new neighbours when they cross into another cell: so each pair is
/// looked at before it can touch, and most pairs never are.
class EventPredictor {
  public:
    EventPredictor(const StaticEnvironment& environment, const std::vector<Ball>& balls,
                   const std::vector<StepBody>& bodies);

    /// Everything ahead of the balls in `changed`, which have begun new segments.
    void find(const std::vector<std::uint32_t>& changed, const SearchHorizon& horizon,
              PredictedEventQueue& queue);

    /// A ball passes into another cell.
    void cross(const PredictedEvent& crossing, const SearchHorizon& horizon,
               PredictedEventQueue& queue);

    /// What does not move, from where the last look ended; nothing if there has been a later look.
    void search_again(const PredictedEvent& look, const SearchHorizon& horizon,
                      PredictedEventQueue& queue);

    /// Boxes are about to move, or have come to rest: what was predicted of them is void.
    void find_boxes_for_all(const SearchHorizon& horizon, PredictedEventQueue& queue);

    [[nodiscard]] std::uint32_t box_round() const { return box_round_; }

  private:
    void find_one(std::uint32_t index, const SearchHorizon& horizon, PredictedEventQueue& queue);
    void find_crossing(std::uint32_t index, double now, double until,
                       PredictedEventQueue& queue) const;
    void find_pair(std::uint32_t index, std::uint32_t other, double now, double until,
                   PredictedEventQueue& queue) const;
    void find_unmoving(std::uint32_t index, const SearchHorizon& horizon,
                       PredictedEventQueue& queue);
    void find_boxes(std::uint32_t index, double now, double until,
                    PredictedEventQueue& queue) const;
    void find_scenery(std::uint32_t index, double now, double until,
                      PredictedEventQueue& queue) const;
    void find_fixed_spheres(std::uint32_t index, double now, double until,
                            PredictedEventQueue& queue) const;
    void find_on_cloth(std::uint32_t index, double now, double until,
                       PredictedEventQueue& queue) const;
    void find_in_air(std::uint32_t index, double now, double until,
                     PredictedEventQueue& queue) const;

    const StaticEnvironment& environment_;
    const std::vector<Ball>& balls_;
    const std::vector<StepBody>& bodies_;
    CellGrid grid_;
    std::vector<std::uint32_t> near_;        // of the ball being looked at
    std::vector<double> next_look_;          // per ball: when `search_again` is due
    std::vector<std::uint32_t> last_found_;  // per ball: in which call of `find` it was a `changed`
    std::uint32_t find_count_ = 0;
    std::uint32_t box_round_ = 0;
};

/// How far from the nose's line (horizontally) the centre of a ball at height `z` is when it
/// touches; 0 if it passes above or below.
[[nodiscard]] double nose_reach(double radius, double z, double nose_height);

}  // namespace carom::sim
