#include "sim/aim/strike_trials.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom::sim {
namespace {

/// An impulse (N s) so small that it changes no velocity. It marks a moment in a trial's log.
Impulse mark(std::size_t number) {
    return Impulse{Vec3(1e-100 * (1 + static_cast<double>(number)), 0, 0)};
}

bool is_mark(const Event& event, std::size_t number) {
    return event.kind == EventKind::impulse && event.vector == mark(number).newton_seconds;
}

bool is_impact_of(const Event& event, const std::string& name) {
    return event.kind == EventKind::impact && (event.a == name || event.b == name);
}

bool is_end_of(const Event& event, const std::string& name) {
    return event.a == name &&
           (event.kind == EventKind::potted || event.kind == EventKind::off_table ||
            event.kind == EventKind::resting);
}

Vec2 level(const Vec3& v) {
    return {v.x, v.y};
}

double distance(const Vec2& a, const Vec2& b) {
    return std::sqrt((a - b).dot(a - b));
}

const MotionState& state_of(const Trials& trials, const Outcome& outcome, const std::string& name) {
    const auto found = std::find(trials.names().begin(), trials.names().end(), name);
    return outcome.states[static_cast<std::size_t>(found - trials.names().begin())];
}

std::string in_quotes(const std::string& name) {
    return "'" + name + "'";
}

std::string partner_text(const Event& impact, const std::string& partner) {
    const Surface surface = impact.surface();
    return surface == Surface::none      ? in_quotes(partner)
           : surface == Surface::cushion ? "a cushion"
                                         : "the " + partner;
}

}  // namespace

const billiards::LyingBall* Setting::find(const std::string& name) const {
    const auto found = std::find_if(balls.begin(), balls.end(),
                                    [&](const auto& ball) { return ball.name == name; });
    return found == balls.end() ? nullptr : &*found;
}

double radius_of(const WorldDescription& world, const std::string& ball) {
    for (const Body& body : world.bodies) {
        if (body.name == ball) {
            return std::get<Sphere>(body.shape).radius;
        }
    }
    return 0;
}

NextStrikeSearch next_strike(const Trials& trials, const std::vector<ForceEvent>& events,
                             const std::vector<std::size_t>& strikes) {
    std::vector<ForceEvent> marked = events;
    for (const std::size_t event : strikes) {
        marked[event].action = mark(event);
    }
    std::optional<NextStrike> next;
    TrialLimits limits;
    limits.is_answered = [&](const Event& event) {
        for (std::size_t i = 0; !next && i < strikes.size(); ++i) {
            if (is_mark(event, strikes[i])) {
                next = NextStrike{i, {event.time, {}}};
            }
        }
        return next.has_value();
    };
    limits.max_steps = kMostTrialSteps;
    const std::optional<Outcome> outcome = trials.run(std::move(marked), limits);
    for (const Body& body : trials.world().bodies) {
        const auto* sphere = std::get_if<Sphere>(&body.shape);
        if (!next || !outcome || sphere == nullptr) {
            continue;
        }
        const Vec3 place = body.kind == BodyKind::dynamic
                               ? state_of(trials, *outcome, body.name).position
                               : body.pose.position;
        if (place.z > 0) {
            next->setting.balls.push_back({body.name, level(place), sphere->radius});
        }
    }
    return outcome ? NextStrikeSearch{std::move(next)} : NextStrikeSearch{std::nullopt, true};
}

StrikeTrials::StrikeTrials(const Trials& trials, const std::vector<ForceEvent>& events,
                           std::size_t event, const Setting& setting)
    : trials_(trials),
      events_(events),
      event_(event),
      setting_(setting),
      ball_(events[event].object),
      radius_(radius_of(trials.world(), ball_)) {
    if (const billiards::LyingBall* struck = setting.find(ball_)) {
        start_ = struck->place;
    }
}

std::vector<ForceEvent> StrikeTrials::events_at(double direction) const {
    std::vector<ForceEvent> events = events_;
    std::get<Strike>(events[event_].action).direction = direction;
    return events;
}

std::optional<Outcome> StrikeTrials::run(std::vector<ForceEvent> events,
                                         std::function<bool(const Event&)> is_answered) {
    ++count_;
    TrialLimits limits;
    limits.is_answered = std::move(is_answered);
    limits.max_steps = kMostTrialSteps;
    return trials_.run(std::move(events), limits);
}

Vec2 StrikeTrials::centre_of(const std::string& name, const Event& event) const {
    if (event.kind != EventKind::impact) {
        return level(event.place);
    }
    const double radius = radius_of(trials_.world(), name);
    return level(event.place + event.normal * (event.a == name ? radius : -radius));
}

bool StrikeTrials::is_this_strike(const Event& event) const {
    return event.kind == EventKind::strike && event.a == ball_ && event.time >= setting_.time;
}

/// What an event of the struck ball says that it does instead of what it should; empty: nothing.
std::string StrikeTrials::what_instead(const Event& event) const {
    if (is_impact_of(event, ball_) && !is_level(event.surface())) {
        const bool is_at_start =
            event.surface() != Surface::none && distance(level(event.place), start_) < 2 * radius_;
        const std::string& partner = event.a == ball_ ? event.b : event.a;
        return is_at_start ? std::string()
                           : in_quotes(ball_) + " hits " + partner_text(event, partner) + " first";
    }
    if (!is_end_of(event, ball_)) {
        return {};
    }
    return in_quotes(ball_) + (event.kind == EventKind::resting ? " comes to rest before that"
                               : event.kind == EventKind::potted
                                   ? " falls into " + event.b
                                   : std::string(" leaves the table"));
}

/// Whether the event ends the free way of `target`, which was hit at `contact`. Where it lies
/// nothing does: it may touch a cushion there, or be hit twice.
bool StrikeTrials::ends_way(const Event& event, const Event& contact,
                            const std::string& target) const {
    if (is_end_of(event, target)) {
        return true;
    }
    const bool is_same_contact =
        is_impact_of(event, ball_) && event.time < contact.time + kOneContact;
    return is_impact_of(event, target) && !is_level(event.surface()) && !is_same_contact &&
           distance(centre_of(target, event), centre_of(target, contact)) >
               radius_of(trials_.world(), target);
}

Played StrikeTrials::play(double direction, const std::string& target, const Line& line,
                          bool follows) {
    std::vector<ForceEvent> events = events_at(direction);
    const std::size_t number = events.size();
    ForceEvent& crossing = events.emplace_back();
    crossing.object = ball_;
    crossing.time = setting_.time;
    crossing.action = mark(number);
    crossing.trigger = Trigger{Trigger::Kind::crossing,
                               ball_,
                               {},
                               line.point - line.across * line.half_length,
                               line.point + line.across * line.half_length};
    Played played;
    bool is_struck = false;
    const std::optional<Outcome> outcome = run(std::move(events), [&](const Event& event) {
        if (!is_struck) {
            is_struck = is_this_strike(event);
            return false;
        }
        if (played.contact) {
            if (ends_way(event, *played.contact, target)) {
                played.end = event;
            }
            return played.end.has_value();
        }
        if (is_mark(event, number)) {
            played.crossing = (level(event.place) - line.point).dot(line.across);
        } else if (!target.empty() && is_impact_of(event, ball_) && is_impact_of(event, target)) {
            played.contact = event;
            return !follows;
        } else {
            played.instead = what_instead(event);
        }
        return played.crossing || !played.instead.empty();
    });
    const bool is_over = follows ? played.end.has_value() : played.contact.has_value();
    if (!outcome) {
        played = Played{};
        played.instead = "that takes too many steps of the simulation";
    } else if (!is_over && !played.crossing && played.instead.empty()) {
        played.instead = "the shot ends before that";
    } else if (played.contact) {
        played.velocity = level(state_of(trials_, *outcome, target).velocity);
    }
    return played;
}

Vec2 StrikeTrials::velocity_before(double direction, double time) {
    std::vector<ForceEvent> events = events_at(direction);
    const std::size_t number = events.size();
    ForceEvent& before = events.emplace_back();
    before.object = ball_;
    // Neither friction nor a curve changes a velocity visibly in so short a time.
    before.time = std::max(setting_.time, time - 1e-8);
    before.action = mark(number);
    const std::optional<Outcome> outcome =
        run(std::move(events), [&](const Event& event) { return is_mark(event, number); });
    return outcome ? level(state_of(trials_, *outcome, ball_).velocity) : Vec2(0);
}

std::optional<Event> StrikeTrials::end_of(double direction, const std::string& ball) {
    std::optional<Event> end;
    bool is_struck = false;
    run(events_at(direction), [&](const Event& event) {
        is_struck = is_struck || is_this_strike(event);
        if (is_struck && is_end_of(event, ball)) {
            end = event;
        }
        return end.has_value();
    });
    return end;
}

}  // namespace carom::sim
