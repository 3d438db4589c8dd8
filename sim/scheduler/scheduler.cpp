#include "sim/scheduler/scheduler.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/error.h"

namespace carom::sim {
namespace {

constexpr double kEnergyInterval = 1.0 / 60;  // s
/// Of a window in which nothing is stepped and no energies are kept.
constexpr double kLongestWindow = 1;  // s
/// ODE steps bodies in contact at a quarter of the world's step, or of this (s) if that is less.
constexpr double kLongestCoarseStep = 1.0 / 240;
/// More impacts than this per ball in one window mean that balls are caught in a corner that the
/// impact laws do not resolve. A break has about ten, a spinning ball pressed against a cushion
/// some hundreds.
constexpr std::size_t kMaxEventsPerBall = 2000;

/// The first of the times at which energies are sampled that is later.
double energy_time_after(double time) {
    double number = std::floor(time / kEnergyInterval + 0.5);
    if (number * kEnergyInterval <= time) {
        ++number;
    }
    return number * kEnergyInterval;
}

std::string cap_warning(std::size_t most, const PredictedEvent& event, const MovingBody& ball) {
    const Vec3 p = ball.segment.position_at(event.time);
    return fmt::format(
        "more than {} impacts at {:.6f} s near '{}' at ({:.4f}, {:.4f}, {:.4f}): "
        "impacts are ignored for up to 1/60 s",
        most, event.time, ball.name(), p.x, p.y, p.z);
}

}  // namespace

Scheduler::Scheduler(const WorldDescription& world, const StaticEnvironment& environment,
                     Record record)
    : world_(world),
      environment_(environment),
      recorder_(world, record),
      bodies_(world, environment_, recorder_),
      stepper_(environment_, bodies_, recorder_),
      predictor_(environment_, bodies_),
      resolver_(environment_, bodies_, predictor_, recorder_),
      schedule_(world.events),
      placer_(world, bodies_, recorder_),
      respotting_(world, bodies_, recorder_, placer_),
      force_applier_(world, environment_, bodies_, recorder_, placer_),
      path_triggers_(world.events, bodies_.all()) {}

bool Scheduler::run(const WorkContext& context, std::uint64_t max_steps) {
    bodies_.start(0);
    double reported = 0;
    while (now_ < world_.duration && !was_stopped_) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        if (steps_ > max_steps) {
            return false;
        }
        run_window();
        if (!recorder_.keeps_all() && is_over()) {
            now_ = world_.duration;
        }
        const double fraction = now_ / world_.duration;
        if (context.progress && fraction >= reported + 0.01) {
            reported = fraction;
            context.progress(std::min(fraction, 1.0));
        }
    }
    finish();
    if (context.progress && reported < 1) {
        context.progress(1.0);
    }
    return true;
}

/// Everything rests, and nothing is left that could change that.
bool Scheduler::is_over() const {
    return bodies_.are_all_at_rest() && std::isinf(schedule_.next_time()) &&
           std::isinf(bodies_.next_key_time(now_)) && !placer_.has_waiting() &&
           !bodies_.is_return_due() && !is_respotting_due();
}

void Scheduler::run_window() {
    ++window_number_;
    reset_event_count();
    sample_energy();
    bodies_.move_kinematic_bodies(now_);
    apply_due_actions();
    if (was_stopped_) {
        return;
    }
    if (bodies_.is_solver_active()) {
        const double fine = std::min(world_.step, kLongestCoarseStep) / 4;
        // Equal parts, so that the last one is not mere rounding error.
        const double parts = std::ceil((window_end_ - now_) / fine * (1 - 1e-9));
        window_end_ = stepper_.try_step(now_, now_ + (window_end_ - now_) / std::max(parts, 1.0));
        check_triggers();  // of impacts at the step's start
    }
    predict();
    predict_solid_impacts();
    predict_solid_path_triggers();
    const std::optional<PredictedEvent> last = process_events();
    if (stepper_.has_trial_step()) {
        steps_ += stepper_.step_size();
        stepper_.commit(window_end_);
    }
    now_ = window_end_;
    if (last) {
        resolver_.resolve(*last);
    }
    return_balls();
    check_triggers();
}

/// Between two steps of ODE, because a ball that leaves may be part of one.
void Scheduler::return_balls() {
    for (const BallReturn::Leaving& leaving : bodies_.take_returned()) {
        bodies_.wake_around(leaving.ball, now_);
        bodies_.leave_table(leaving, now_);
    }
}

/// Processes the events up to the window's end in order. Where a ball hits a body that ODE steps,
/// the window ends: that event is returned, to be resolved when ODE has stepped up to it.
std::optional<PredictedEvent> Scheduler::process_events() {
    while (!queue_.empty() && queue_.top().time <= window_end_) {
        const PredictedEvent event = queue_.top();
        queue_.pop();
        if (!is_valid(event)) {
            continue;
        }
        count_window_of(event);
        ++steps_;
        if (event.kind == PredictedEventKind::cell_crossing ||
            event.kind == PredictedEventKind::search_again) {
            extend_search(event);
            continue;
        }
        if (event.kind == PredictedEventKind::path) {
            count_on_path(event);
            continue;
        }
        if (needs_step(event)) {
            window_end_ = event.time;
            return event;
        }
        process(event);
    }
    return std::nullopt;
}

bool Scheduler::needs_step(const PredictedEvent& event) const {
    return event.kind == PredictedEventKind::solid ||
           (event.kind == PredictedEventKind::ball && resolver_.involves_solver(event));
}

double Scheduler::window_end_from(double now) const {
    const double next_key = bodies_.next_key_time(now);
    double end = std::min(world_.duration, next_key);
    // Without a step of ODE or something that waits, all is known from event to event.
    const bool is_short = recorder_.keeps_all() || bodies_.is_solver_active() ||
                          std::isfinite(next_key) || placer_.has_waiting() ||
                          bodies_.is_return_due() || !path_triggers_.is_empty();
    end = std::min(end, is_short ? next_energy_time_ : now + kLongestWindow);
    const double next_action = schedule_.next_time();
    return next_action > now ? std::min(end, next_action) : end;
}

void Scheduler::apply_due_actions() {
    for (;;) {
        put_balls_down();
        check_rest_triggers();
        const std::vector<DueAction> due = schedule_.take_due(now_);
        if (due.empty()) {
            break;
        }
        const bool begins_event = std::any_of(
            due.begin(), due.end(), [](const DueAction& a) { return a.impulse_step < 0; });
        if (begins_event) {
            add_energy();
        }
        for (DueAction action : due) {
            action.time = now_;
            force_applier_.apply(action);
        }
        note_placed_balls();
        if (begins_event) {
            add_energy();
        }
        check_triggers();
    }
    window_end_ = window_end_from(now_);
}

/// Between two steps of ODE: the balls that wait for their places, and those that the game's rule
/// puts back.
void Scheduler::put_balls_down() {
    if (placer_.has_waiting() && placer_.can_place_waiting(now_)) {
        add_energy();
        placer_.place_waiting(now_);
        add_energy();
        note_placed_balls();
    }
    if (is_respotting_due()) {
        add_energy();
        respotting_.act(now_);
        add_energy();
    }
}

void Scheduler::note_placed_balls() {
    for (const std::size_t event : placer_.take_done()) {
        schedule_.note_placed(event);
    }
}

/// Actions due at this instant come first: they belong to the shot.
bool Scheduler::is_respotting_due() const {
    return respotting_.has_news() && !schedule_.is_due(now_) && is_resting("");
}

SearchHorizon Scheduler::horizon() const {
    return {now_, world_.duration, stepper_.has_trial_step() ? window_end_ : world_.duration};
}

void Scheduler::predict() {
    const std::vector<std::uint32_t> changed = bodies_.take_changed();
    predictor_.predict(changed, horizon(), queue_);
    if (!path_triggers_.is_empty()) {
        predict_path_triggers(changed);
    }
}

void Scheduler::predict_path_triggers(const std::vector<std::uint32_t>& changed) {
    const SearchHorizon limits = horizon();
    for (const std::uint32_t index : changed) {
        const MovingBody& ball = bodies_[index];
        path_triggers_.predict(index, ball, now_,
                               ball.is_in_solver() ? limits.step_end : limits.end, window_number_,
                               queue_);
    }
}

/// Bodies other than balls move only while ODE steps them.
void Scheduler::predict_solid_path_triggers() {
    if (path_triggers_.is_empty() || !stepper_.has_trial_step()) {
        return;
    }
    for (std::size_t i = bodies_.balls().size(); i < bodies_.all().size(); ++i) {
        path_triggers_.predict(static_cast<std::uint32_t>(i), bodies_.all()[i], now_, window_end_,
                               window_number_, queue_);
    }
}

void Scheduler::count_on_path(const PredictedEvent& event) {
    now_ = std::max(now_, event.time);
    if (const auto waiting = path_triggers_.count(event.second, event.time)) {
        schedule_.count_on_path(*waiting, event.time);
    }
    if (event.first < bodies_.balls().size()) {  // the ball may cross the same line again
        predict_path_triggers({event.first});
    }
    window_end_ = std::max(now_, std::min(window_end_, schedule_.next_time()));
}

void Scheduler::extend_search(const PredictedEvent& event) {
    now_ = std::max(now_, event.time);
    if (event.kind == PredictedEventKind::cell_crossing) {
        predictor_.enter_cell(event, horizon(), queue_);
    } else {
        predictor_.search_again(event, horizon(), queue_);
    }
}

/// The known motion of solids is valid for ODE's current step; at rest it is valid indefinitely.
void Scheduler::predict_solid_impacts() {
    const bool has_solids = !bodies_.solids().empty();
    if (has_solids && (stepper_.has_trial_step() || was_stepping_)) {
        predictor_.predict_all_solid_impacts(horizon(), queue_);
    }
    was_stepping_ = stepper_.has_trial_step();
}

/// Events are counted per window. Impacts that were ignored may be long past, so everything is
/// predicted again.
void Scheduler::reset_event_count() {
    events_in_window_ = 0;
    if (!is_capped_) {
        return;
    }
    is_capped_ = false;
    bodies_.invalidate_predictions();
}

bool Scheduler::is_valid(const PredictedEvent& event) const {
    const std::span<const MovingBody> balls = bodies_.balls();
    if (event.first >= balls.size()) {  // a body other than a ball crosses a line
        return event.second_version == window_number_;
    }
    if (balls[event.first].version != event.first_version) {
        return false;
    }
    if (event.kind == PredictedEventKind::ball) {
        return balls[event.second].version == event.second_version;
    }
    return event.kind != PredictedEventKind::solid ||
           event.second_version == predictor_.solid_version();
}

void Scheduler::process(const PredictedEvent& event) {
    const bool is_segment_end = event.kind == PredictedEventKind::segment_end;
    const std::size_t most = kMaxEventsPerBall * std::max<std::size_t>(bodies_.balls().size(), 10);
    if (++events_in_window_ > most && !is_segment_end) {
        if (!is_capped_) {
            recorder_.warn({{}, "", cap_warning(most, event, bodies_.balls()[event.first])});
        }
        is_capped_ = true;
        window_end_ = std::min(window_end_, next_energy_time_);
        return;
    }
    now_ = event.time;
    const std::size_t in_solver_before = bodies_.solver_count();
    resolver_.resolve(event);
    predict();
    check_triggers();
    // A ball that was just activated is stepped by ODE from here on, in a new window.
    const bool was_activated = bodies_[event.first].is_in_solver() || in_solver_before == 0 ||
                               bodies_.solver_count() > in_solver_before;
    if ((bodies_.solver_count() > 0 && was_activated) || bodies_.is_return_due()) {
        window_end_ = now_;
    }
}

void Scheduler::check_triggers() {
    const std::vector<Event>& events = recorder_.events();
    for (; checked_events_ < events.size(); ++checked_events_) {
        schedule_.check_triggers(events[checked_events_]);
        if (!was_stopped_ && is_last_ != nullptr && *is_last_ &&
            (*is_last_)(events[checked_events_])) {
            was_stopped_ = true;
            window_end_ = now_;
        }
    }
    check_rest_triggers();
    // A trigger may have scheduled an action before this window's end.
    window_end_ = std::max(now_, std::min(window_end_, schedule_.next_time()));
}

/// Actions due at this instant come first: they may set bodies in motion. So does the game's rule,
/// which acts at the start of the next window.
void Scheduler::check_rest_triggers() {
    if (is_respotting_due()) {
        window_end_ = now_;
        return;
    }
    if (!schedule_.waits_for_rest() || schedule_.is_due(now_)) {
        return;
    }
    schedule_.check_rest_triggers(now_,
                                  {[this](const std::string& name) { return is_moving(name); },
                                   [this](const std::string& name) { return is_resting(name); }});
}

bool Scheduler::is_resting(const std::string& name) const {
    if (schedule_.has_impulse_steps_left(name)) {
        return false;
    }
    return name.empty() ? bodies_.are_all_at_rest()
                        : std::ranges::all_of(bodies_.all(), [&](const MovingBody& body) {
                              return body.name() != name || body.is_still();
                          });
}

bool Scheduler::is_moving(const std::string& name) const {
    return std::ranges::any_of(bodies_.all(), [&](const MovingBody& body) {
        return (name.empty() || body.name() == name) && body.has_moved_since_rest();
    });
}

void Scheduler::sample_energy() {
    if (now_ < next_energy_time_) {
        return;
    }
    add_energy();
    next_energy_time_ = energy_time_after(now_);
}

/// Long windows count their events as the short ones of a bake do.
void Scheduler::count_window_of(const PredictedEvent& event) {
    if (event.time > next_energy_time_) {
        events_in_window_ = 0;
        next_energy_time_ = energy_time_after(event.time);
    }
}

void Scheduler::add_energy() {
    if (!recorder_.keeps_all()) {
        return;
    }
    EnergySample sample;
    sample.time = now_;
    bodies_.add_energy(now_, sample);
    recorder_.add_energy(sample);
}

void Scheduler::finish() {
    apply_due_actions();
    add_energy();
    bodies_.finish(now_);
    for (Diagnostic& missed : force_applier_.missed_strikes()) {
        recorder_.warn(std::move(missed));
    }
    for (Diagnostic& waiting : placer_.never_placed(now_)) {
        recorder_.warn(std::move(waiting));
    }
    for (Diagnostic& waiting : respotting_.never_put_back()) {
        recorder_.warn(std::move(waiting));
    }
    for (Diagnostic& unmet : schedule_.triggers_never_met()) {
        recorder_.warn(std::move(unmet));
    }
    bodies_.warn_of_balls_in_pocket_mouths();
    for (const std::string& sentence : guard_.messages()) {
        recorder_.warn({{}, "", sentence});
    }
}

}  // namespace carom::sim
