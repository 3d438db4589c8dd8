#include "sim/scheduler/scheduler.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/error.h"
#include "sim/start_overlaps.h"

namespace carom::sim {
namespace {

constexpr double kEnergyInterval = 1.0 / 60;  // s
/// ODE steps what lies in touch at a quarter of the world's step, or of this (s) if that is less.
constexpr double kLongestCoarseStep = 1.0 / 240;
/// More touches than this per ball in one window mean that balls are caught in a corner that the
/// laws do not resolve. A break has some ten, a spinning ball pressed to a cushion some hundreds.
constexpr std::size_t kMostEventsPerBall = 2000;

std::string cap_warning(std::size_t most, const PredictedEvent& event, const Ball& ball) {
    const Vec3 p = ball.segment.position_at(event.time);
    return fmt::format(
        "more than {} touches at {:.6f} s near '{}' at ({:.4f}, {:.4f}, {:.4f}): "
        "touches are ignored for up to 1/60 s",
        most, event.time, ball.name, p.x, p.y, p.z);
}

}  // namespace

Scheduler::Scheduler(const WorldDescription& world)
    : world_(world),
      environment_(world),
      recording_(world),
      balls_(world, environment_, recording_),
      stepped_(world, environment_, balls_, recording_),
      finder_(environment_, balls_.all(), stepped_.all()),
      resolver_(environment_, balls_, stepped_, recording_),
      schedule_(world.events),
      actions_(world, balls_, stepped_, recording_),
      lines_(world.events, stepped_.all()) {}

bool Scheduler::run(const WorkContext& context, std::uint64_t most_steps) {
    const auto overlaps =
        find_start_overlaps(world_, environment_.has_cushions ? &environment_.table : nullptr);
    if (!overlaps.empty()) {
        throw Error("body '" + overlaps[0].ball + "' " + overlaps[0].sentence() + " at the start");
    }
    balls_.start(0);
    stepped_.start(0);
    double reported = 0;
    while (now_ < world_.duration) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        if (steps_ > most_steps) {
            return false;
        }
        run_window();
        const double fraction = now_ / world_.duration;
        if (context.progress && fraction >= reported + 0.01) {
            reported = fraction;
            context.progress(std::min(fraction, 1.0));
        }
    }
    conclude();
    if (context.progress && reported < 1) {
        context.progress(1.0);
    }
    return true;
}

void Scheduler::run_window() {
    ++round_;
    begin_count();
    measure_energy();
    stepped_.follow_paths(now_);
    act();
    if (stepped_.is_active()) {
        const double fine = std::min(world_.step, kLongestCoarseStep) / 4;
        // Equal parts, lest the last one be round-off.
        const double parts = std::ceil((window_end_ - now_) / fine * (1 - 1e-9));
        window_end_ = stepped_.try_step(now_, now_ + (window_end_ - now_) / std::max(parts, 1.0));
    }
    predict();
    find_boxes();
    find_lines_of_boxes();
    const std::optional<PredictedEvent> last = meet_all();
    if (stepped_.is_trying()) {
        steps_ += stepped_.step_size();
        stepped_.commit(window_end_);
    }
    now_ = window_end_;
    if (last) {
        resolver_.resolve(*last);
    }
    notice_events();
}

/// Meets touch after touch up to the window's end. Where a ball meets something that ODE carries,
/// the window ends: that touch is returned, to be resolved when ODE has come so far.
std::optional<PredictedEvent> Scheduler::meet_all() {
    while (!queue_.empty() && queue_.top().time <= window_end_) {
        const PredictedEvent event = queue_.top();
        queue_.pop();
        if (!is_valid(event)) {
            continue;
        }
        ++steps_;
        if (event.kind == PredictedEventKind::cell_crossing ||
            event.kind == PredictedEventKind::search_again) {
            search_on(event);
            continue;
        }
        if (event.kind == PredictedEventKind::line) {
            cross_line(event);
            continue;
        }
        if (needs_step(event)) {
            window_end_ = event.time;
            return event;
        }
        meet(event);
    }
    return std::nullopt;
}

bool Scheduler::needs_step(const PredictedEvent& event) const {
    if (event.kind == PredictedEventKind::box) {
        return true;
    }
    return event.kind == PredictedEventKind::ball &&
           (balls_.all()[event.first].is_stepped() || balls_.all()[event.second].is_stepped());
}

double Scheduler::window_end_from(double now) const {
    double end = std::min(world_.duration, stepped_.next_key(now));
    if (next_energy_time_ > now) {
        end = std::min(end, next_energy_time_);
    }
    const double next_action = schedule_.next_time();
    return next_action > now ? std::min(end, next_action) : end;
}

void Scheduler::act() {
    for (;;) {
        notice_rest();
        const std::vector<DueAction> due = schedule_.take_due(now_);
        if (due.empty()) {
            break;
        }
        const bool begins =
            std::any_of(due.begin(), due.end(), [](const DueAction& a) { return a.kick < 0; });
        if (begins) {
            add_energy();
        }
        for (DueAction action : due) {
            action.time = now_;
            actions_.apply(action);
        }
        if (begins) {
            add_energy();
        }
        notice_events();
    }
    window_end_ = window_end_from(now_);
}

SearchHorizon Scheduler::horizon() const {
    return {now_, world_.duration, stepped_.is_trying() ? window_end_ : world_.duration};
}

void Scheduler::predict() {
    const std::vector<std::uint32_t> changed = balls_.take_changed();
    finder_.find(changed, horizon(), queue_);
    if (!lines_.is_empty()) {
        find_lines(changed);
    }
}

void Scheduler::find_lines(const std::vector<std::uint32_t>& changed) {
    const SearchHorizon ahead = horizon();
    for (const std::uint32_t index : changed) {
        const Ball& ball = balls_.all()[index];
        lines_.find(index, ball, now_, ball.is_stepped() ? ahead.step_end : ahead.end, queue_);
    }
}

/// The same for what is not a ball; it moves only while ODE steps it.
void Scheduler::find_lines_of_boxes() {
    if (lines_.is_empty() || !stepped_.is_trying()) {
        return;
    }
    for (std::size_t i = balls_.all().size(); i < stepped_.all().size(); ++i) {
        lines_.find(static_cast<std::uint32_t>(i), stepped_.all()[i], now_, window_end_, round_,
                    queue_);
    }
}

void Scheduler::cross_line(const PredictedEvent& event) {
    now_ = std::max(now_, event.time);
    if (const auto triggered = lines_.take(event.second)) {
        schedule_.notice_crossing(*triggered, event.time);
    }
    window_end_ = std::max(now_, std::min(window_end_, schedule_.next_time()));
}

void Scheduler::search_on(const PredictedEvent& event) {
    now_ = std::max(now_, event.time);
    if (event.kind == PredictedEventKind::cell_crossing) {
        finder_.cross(event, horizon(), queue_);
    } else {
        finder_.search_again(event, horizon(), queue_);
    }
}

/// Where boxes are known to be holds for as long as ODE's step; at rest, for ever.
void Scheduler::find_boxes() {
    const bool has_boxes = stepped_.all().size() > balls_.all().size();
    if (has_boxes && (stepped_.is_trying() || was_stepping_)) {
        finder_.find_boxes_for_all(horizon(), queue_);
    }
    was_stepping_ = stepped_.is_trying();
}

/// Counts touches anew for every window. Touches that have been ignored may be long past: all balls
/// look ahead again.
void Scheduler::begin_count() {
    events_in_window_ = 0;
    if (!is_capped_) {
        return;
    }
    is_capped_ = false;
    balls_.void_predictions();
}

bool Scheduler::is_valid(const PredictedEvent& event) const {
    const std::vector<Ball>& balls = balls_.all();
    if (event.first >= balls.size()) {  // what is not a ball, crossing a line
        return event.second_version == round_;
    }
    if (balls[event.first].version != event.first_version) {
        return false;
    }
    if (event.kind == PredictedEventKind::ball) {
        return balls[event.second].version == event.second_version;
    }
    return event.kind != PredictedEventKind::box || event.second_version == finder_.box_round();
}

void Scheduler::meet(const PredictedEvent& event) {
    const bool is_law_change = event.kind == PredictedEventKind::segment_end;
    const std::size_t most = kMostEventsPerBall * std::max<std::size_t>(balls_.all().size(), 10);
    if (++events_in_window_ > most && !is_law_change) {
        if (!is_capped_) {
            recording_.warn({{}, "", cap_warning(most, event, balls_.all()[event.first])});
        }
        is_capped_ = true;
        return;
    }
    now_ = event.time;
    const bool was_stepping = stepped_.is_active();
    resolver_.resolve(event);
    predict();
    notice_events();
    // What ODE has just been given it steps from here on, in a window of its own.
    const bool is_handed = balls_.all()[event.first].is_stepped() || !was_stepping;
    if (stepped_.is_active() && is_handed) {
        window_end_ = now_;
    }
}

void Scheduler::notice_events() {
    const std::vector<Event>& events = recording_.events();
    for (; noticed_events_ < events.size(); ++noticed_events_) {
        schedule_.notice(events[noticed_events_]);
    }
    notice_rest();
    // A trigger may have called for something before this window's end.
    window_end_ = std::max(now_, std::min(window_end_, schedule_.next_time()));
}

/// What is due at this instant comes first: it may set things in motion.
void Scheduler::notice_rest() {
    if (!schedule_.waits_for_rest() || schedule_.is_due(now_)) {
        return;
    }
    schedule_.notice_rest(now_, {[this](const std::string& name) { return is_moving(name); },
                                 [this](const std::string& name) { return is_resting(name); }});
}

bool Scheduler::is_resting(const std::string& name) const {
    if (schedule_.is_pushing(name)) {
        return false;
    }
    if (name.empty()) {
        return balls_.all_rest() && stepped_.all_rest();
    }
    for (std::size_t i = 0; i < stepped_.all().size(); ++i) {
        if (*stepped_.all()[i].name == name) {
            return i < balls_.all().size() ? balls_.all()[i].is_still()
                                           : !stepped_.all()[i].is_awake;
        }
    }
    return true;  // fixed bodies
}

bool Scheduler::is_moving(const std::string& name) const {
    const std::vector<StepBody>& bodies = stepped_.all();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const bool is_named = name.empty() || *bodies[i].name == name;
        if (is_named &&
            (i < balls_.all().size() ? balls_.all()[i].has_left() : bodies[i].has_left())) {
            return true;
        }
    }
    return false;
}

void Scheduler::measure_energy() {
    if (now_ < next_energy_time_) {
        return;
    }
    add_energy();
    next_energy_time_ = (std::floor(now_ / kEnergyInterval + 0.5) + 1) * kEnergyInterval;
}

void Scheduler::add_energy() {
    EnergySample sample;
    sample.time = now_;
    balls_.add_energy(now_, sample);
    stepped_.add_energy(sample);
    recording_.add_energy(sample);
}

void Scheduler::conclude() {
    act();
    add_energy();
    balls_.finish(now_);
    stepped_.finish(now_);
    for (Diagnostic& missed : actions_.missed_strikes()) {
        recording_.warn(std::move(missed));
    }
    for (Diagnostic& unmet : schedule_.unmet_triggers()) {
        recording_.warn(std::move(unmet));
    }
    balls_.warn_of_jammed();
    for (const std::string& sentence : guard_.messages()) {
        recording_.warn({{}, "", sentence});
    }
}

}  // namespace carom::sim
