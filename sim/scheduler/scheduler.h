// Runs a world from start to end in windows of time, processing the events of each window in order.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "sim/ode/process.h"
#include "sim/scheduler/ball_placer.h"
#include "sim/scheduler/bodies.h"
#include "sim/scheduler/event_predictor.h"
#include "sim/scheduler/force_applier.h"
#include "sim/scheduler/force_schedule.h"
#include "sim/scheduler/impact_resolver.h"
#include "sim/scheduler/path_triggers.h"
#include "sim/scheduler/predicted_event.h"
#include "sim/scheduler/recorder.h"
#include "sim/scheduler/respotting.h"
#include "sim/scheduler/static_environment.h"
#include "sim/scheduler/stepper.h"

namespace carom::sim {

/// For a single use: run it, then take the results. The world and its environment must outlive the
/// scheduler; the world has no problems and nothing overlaps at its start.
class Scheduler {
  public:
    Scheduler(const WorldDescription& world, const StaticEnvironment& environment, Record record);

    /// Ends the run at the first event for which it is true.
    void stop_at(const std::function<bool(const Event&)>* is_last) { is_last_ = is_last; }

    /// Returns false, without results, if the run would take more than `max_steps` (see
    /// bake_within). Throws Stopped if a stop is requested.
    [[nodiscard]] bool run(const WorkContext& context, std::uint64_t max_steps);

    [[nodiscard]] Timeline take_timeline() { return recorder_.take_timeline(now_); }
    [[nodiscard]] const std::vector<MotionState>& last_states() const {
        return recorder_.last_states();
    }
    [[nodiscard]] bool was_stopped() const { return was_stopped_; }

  private:
    void run_window();
    [[nodiscard]] std::optional<PredictedEvent> process_events();
    void apply_due_actions();
    void process(const PredictedEvent& event);
    void extend_search(const PredictedEvent& event);
    void predict();
    void predict_solid_impacts();
    void predict_path_triggers(const std::vector<std::uint32_t>& changed);
    void predict_solid_path_triggers();
    void count_on_path(const PredictedEvent& event);
    void reset_event_count();
    [[nodiscard]] SearchHorizon horizon() const;
    void return_balls();
    void put_balls_down();
    void note_placed_balls();
    [[nodiscard]] bool is_respotting_due() const;
    void check_triggers();
    void check_rest_triggers();
    [[nodiscard]] bool is_over() const;
    void sample_energy();
    void count_window_of(const PredictedEvent& event);
    void add_energy();
    [[nodiscard]] bool needs_step(const PredictedEvent& event) const;
    void finish();
    [[nodiscard]] bool is_valid(const PredictedEvent& event) const;
    [[nodiscard]] double window_end_from(double now) const;
    [[nodiscard]] bool is_resting(const std::string& name) const;
    [[nodiscard]] bool is_moving(const std::string& name) const;

    ode::ThreadGuard guard_;
    const WorldDescription& world_;
    const StaticEnvironment& environment_;
    Recorder recorder_;
    Bodies bodies_;
    Stepper stepper_;
    EventPredictor predictor_;
    ImpactResolver resolver_;
    ForceSchedule schedule_;
    BallPlacer placer_;
    Respotting respotting_;
    ForceApplier force_applier_;
    PathTriggers path_triggers_;
    PredictedEventQueue queue_;
    double now_ = 0;
    double window_end_ = 0;
    double next_energy_time_ = 0;
    std::size_t checked_events_ = 0;
    std::size_t events_in_window_ = 0;
    std::uint64_t steps_ = 0;  // counted as in bake_within
    std::uint32_t window_number_ = 0;
    bool is_capped_ = false;  // too many events: the rest of this window ignores impacts
    const std::function<bool(const Event&)>* is_last_ = nullptr;
    bool was_stopped_ = false;
    bool was_stepping_ = true;  // whether ODE stepped in the last window; true before the first
};

}  // namespace carom::sim
