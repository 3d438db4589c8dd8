// Predicts the next events of the balls.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/scheduler/bodies.h"
#include "sim/scheduler/predicted_event.h"
#include "sim/scheduler/static_environment.h"
#include "sim/spatial/cell_grid.h"

namespace carom::sim {

/// The interval in which events are predicted; scene times, s.
struct SearchHorizon {
    double now = 0;
    double end = 0;       // end of the simulation
    double step_end = 0;  // end of the step that ODE is trying; `end` if there is none
};

/// Predictions are made when a ball begins a segment, up to the end of that segment, and are valid
/// until the version of either ball changes. A ball is tested against those in the neighbouring
/// cells of a grid, and against the new neighbours when it enters another cell: so each pair is
/// tested before it can touch, and most pairs never are.
class EventPredictor {
  public:
    EventPredictor(const StaticEnvironment& environment, const Bodies& bodies);

    /// Predicts all events of the balls in `changed`, which have begun new segments.
    void predict(const std::vector<std::uint32_t>& changed, const SearchHorizon& horizon,
                 PredictedEventQueue& queue);

    /// A ball enters another cell: predicts its impacts with the balls of the new neighbourhood.
    void enter_cell(const PredictedEvent& crossing, const SearchHorizon& horizon,
                    PredictedEventQueue& queue);

    /// Continues the search for obstacles where the last one ended, unless a later one has begun.
    void search_again(const PredictedEvent& search, const SearchHorizon& horizon,
                      PredictedEventQueue& queue);

    /// Predicts all impacts with moving solids again, since they are about to move or have come to
    /// rest.
    void predict_all_solid_impacts(const SearchHorizon& horizon, PredictedEventQueue& queue);

    /// Replaces `found` by the other balls within the cells around ball `index`.
    void find_near(std::uint32_t index, std::vector<std::uint32_t>& found) const {
        grid_.find_near(index, found);
    }

    [[nodiscard]] std::uint32_t solid_version() const { return solid_version_; }

  private:
    void predict_ball(std::uint32_t index, const SearchHorizon& horizon,
                      PredictedEventQueue& queue);
    void predict_cell_crossing(std::uint32_t index, double now, double until,
                               PredictedEventQueue& queue) const;
    void predict_ball_impact(std::uint32_t index, std::uint32_t other, double now, double until,
                             PredictedEventQueue& queue) const;
    void search_obstacles(std::uint32_t index, const SearchHorizon& horizon,
                          PredictedEventQueue& queue);
    void predict_solid_impacts(std::uint32_t index, double now, double until,
                               PredictedEventQueue& queue) const;
    void predict_solid_impact(std::uint32_t index, std::uint32_t solid, double now, double until,
                              PredictedEventQueue& queue) const;
    void predict_scenery_impacts(std::uint32_t index, double now, double until,
                                 PredictedEventQueue& queue) const;
    void predict_fixed_sphere_impacts(std::uint32_t index, double now, double until,
                                      PredictedEventQueue& queue) const;
    void predict_cloth_events(std::uint32_t index, double now, double until,
                              PredictedEventQueue& queue) const;
    void predict_flight_events(std::uint32_t index, double now, double until,
                               PredictedEventQueue& queue) const;

    const StaticEnvironment& environment_;
    std::span<const MovingBody> balls_;
    std::span<const MovingBody> bodies_;
    CellGrid grid_;
    std::vector<std::uint32_t> neighbours_;      // of the ball being handled
    std::vector<double> next_search_;            // per ball: when `search_again` is due
    std::vector<std::uint32_t> last_predicted_;  // per ball: the last call of `predict` for it
    std::uint32_t predict_count_ = 0;
    std::uint32_t solid_version_ = 0;
};

/// Horizontal distance of a ball's centre at height `z` from the line of the nose when they touch;
/// 0 if the ball passes above or below.
[[nodiscard]] double nose_contact_distance(double radius, double z, double nose_height);

}  // namespace carom::sim
