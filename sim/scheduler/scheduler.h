// Runs a world from its start to its end: one window of time after the other, and within each one
// touch after the other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "sim/ode/process.h"
#include "sim/scheduler/actions.h"
#include "sim/scheduler/balls.h"
#include "sim/scheduler/event_predictor.h"
#include "sim/scheduler/force_schedule.h"
#include "sim/scheduler/impact_resolver.h"
#include "sim/scheduler/line_watch.h"
#include "sim/scheduler/predicted_event.h"
#include "sim/scheduler/recording.h"
#include "sim/scheduler/static_environment.h"
#include "sim/scheduler/stepped_bodies.h"

namespace carom::sim {

/// Use once: run, then take the results. The world must outlive it and have no problems.
class Scheduler {
  public:
    explicit Scheduler(const WorldDescription& world);

    /// False if it would have taken more than `most_steps` (see bake_within); then there are no
    /// results. Throws Stopped when asked to stop.
    [[nodiscard]] bool run(const WorkContext& context, std::uint64_t most_steps);

    [[nodiscard]] Timeline take_timeline() { return recording_.take_timeline(world_.duration); }

  private:
    void run_window();
    [[nodiscard]] std::optional<PredictedEvent> meet_all();
    void act();
    void meet(const PredictedEvent& event);
    void search_on(const PredictedEvent& event);
    void predict();
    void find_boxes();
    void find_lines(const std::vector<std::uint32_t>& changed);
    void find_lines_of_boxes();
    void cross_line(const PredictedEvent& event);
    void begin_count();
    [[nodiscard]] SearchHorizon horizon() const;
    void notice_events();
    void notice_rest();
    void measure_energy();
    void add_energy();
    [[nodiscard]] bool needs_step(const PredictedEvent& event) const;
    void conclude();
    [[nodiscard]] bool is_valid(const PredictedEvent& event) const;
    [[nodiscard]] double window_end_from(double now) const;
    [[nodiscard]] bool is_resting(const std::string& name) const;
    [[nodiscard]] bool is_moving(const std::string& name) const;

    ode::ThreadGuard guard_;
    const WorldDescription& world_;
    StaticEnvironment environment_;
    Recording recording_;
    Balls balls_;
    SteppedBodies stepped_;
    EventPredictor finder_;
    ImpactResolver resolver_;
    ForceSchedule schedule_;
    Actions actions_;
    LineWatch lines_;
    PredictedEventQueue queue_;
    double now_ = 0;
    double window_end_ = 0;
    double next_energy_time_ = 0;
    std::size_t noticed_events_ = 0;
    std::size_t events_in_window_ = 0;
    std::uint64_t steps_ = 0;   // as bake_within counts them
    std::uint32_t round_ = 0;   // counts the windows
    bool is_capped_ = false;    // for the rest of this window
    bool was_stepping_ = true;  // in the last window, or there was none
};

}  // namespace carom::sim
