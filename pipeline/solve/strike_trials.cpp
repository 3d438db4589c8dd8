#include "pipeline/solve/strike_trials.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/error.h"

namespace carom::pipeline::solve {
namespace {

using sim::Event;
using sim::EventKind;
using sim::Outcome;

/// A ball that has met more cushions than this will not do what is wanted.
constexpr int kMaxCushions = 5;

/// Whether the leg has ended and the ball has come away from its target.
bool has_passed(const std::vector<Leg>& legs, const Pass& pass, const Vec2& point) {
    auto leg = std::ranges::find(legs, pass.cause, &Leg::cause);
    return std::any_of(leg, legs.end(), [&](const Leg& each) {
        const Vec2 d = each.end() - point;
        return d.dot(d) > kMouth * kMouth;
    });
}

}  // namespace

StrikeTrials::StrikeTrials(const sim::Trials& trials, const SolveProblem& problem,
                           const PartsWork& work)
    : trials_(trials),
      problem_(problem),
      work_(work),
      base_(std::get<sim::Strike>(trials.world().events.at(problem.event).action)),
      ball_(trials.world().events[problem.event].object),
      radii_(radii_of(trials.world())) {
    for (std::size_t i = 0; i < problem.event; ++i) {
        strike_ += std::holds_alternative<sim::Strike>(trials.world().events[i].action) ? 1 : 0;
    }
    find_start();
    find_targets();
}

Setting StrikeTrials::rounded_where_found(const Setting& setting) const {
    Setting result = rounded(setting);
    if (!problem_.finds_direction) {
        result.direction = setting.direction;
    }
    if (!problem_.finds_speed) {
        result.speed = setting.speed;
    }
    if (!problem_.finds_tip) {
        result.tip = setting.tip;
    }
    if (!problem_.finds_elevation) {
        result.elevation = setting.elevation;
    }
    return result;
}

/// Whether it is wanted that the ball is potted.
bool StrikeTrials::shall_be_potted(const std::string& ball) const {
    return std::ranges::any_of(
        targets_, [&](const Target& target) { return target.is_pocket && target.ball == ball; });
}

Outcome StrikeTrials::play(const Setting& setting, Depth depth, const Pass* pass) const {
    ++simulations_;
    std::vector<sim::ForceEvent> events = trials_.world().events;
    events[problem_.event].action = with_setting(base_, setting);
    Watch watch(problem_.wants, strike_);
    std::map<std::string, int> cushions;
    bool has_met_ball = false;
    std::optional<LegReader> legs;
    if (pass != nullptr) {
        const std::string& ball = targets_[pass->target].ball;
        legs.emplace(ball, radii_.at(ball));
    }
    sim::TrialLimits limits;
    limits.stop = work_.context.stop;
    limits.keeps_motion = needs_motion() && (depth != Depth::scan || targets_.empty());
    limits.is_answered = [&](const Event& event) {
        watch.see(event);
        const bool is_stopped_early =
            depth == Depth::scan || (depth == Depth::chance && !watch.is_met());
        if (!is_stopped_early || !watch.has_begun()) {
            return watch.has_failed();
        }
        if (legs && !watch.is_met()) {
            legs->see(event);
            if (has_passed(legs->ended(), *pass, targets_[pass->target].point)) {
                return true;
            }
        }
        has_met_ball |= event.kind == EventKind::impact && event.surface() == sim::Surface::none;
        const bool is_lost =
            (event.surface() == sim::Surface::cushion && ++cushions[event.a] > kMaxCushions) ||
            (event.kind == EventKind::resting &&
             (event.a == ball_ ? !has_met_ball : shall_be_potted(event.a)));
        return watch.has_failed() || is_lost ||
               (watch.is_met() && !has_places_wanted() && !has<Clearing>()) ||
               (watch.is_met() && !targets_.empty());
    };
    std::optional<Outcome> outcome = trials_.run(std::move(events), limits);
    return outcome ? std::move(*outcome) : Outcome{};
}

bool StrikeTrials::is_met(const Outcome& outcome) const {
    const Trial trial = trial_of(outcome);
    return std::ranges::all_of(problem_.wants, [&](const Want& want) {
        return is_of_end(want) || miss_of(want, trial) == 0;
    });
}

bool StrikeTrials::needs_motion() const {
    return std::ranges::any_of(problem_.wants, [](const Want& want) {
        const auto* measured = std::get_if<MeasuredRange>(&want);
        return measured != nullptr && measured->needs_motion;
    });
}

double StrikeTrials::miss(const Outcome& outcome) const {
    const Trial trial = trial_of(outcome);
    double sum = 0;
    for (const Want& want : problem_.wants) {
        const double each = miss_of(want, trial);
        sum += std::holds_alternative<Happening>(want) ? 10 * each : each;
    }
    return sum;
}

double StrikeTrials::distance(const Outcome& outcome) const {
    const Trial trial = trial_of(outcome);
    double sum = 0;
    for (const Want& want : problem_.wants) {
        sum += distance_of(want, trial);
    }
    return sum;
}

std::vector<double> StrikeTrials::offsets(const Outcome& outcome) const {
    const Trial trial = trial_of(outcome);
    std::vector<double> result;
    for (const Want& want : problem_.wants) {
        if (const auto* rest = std::get_if<RestPlace>(&want)) {
            const std::optional<Vec2> place = trial.place_of(rest->ball);
            if (!place) {
                return {};
            }
            result.push_back(place->x - rest->near.x);
            result.push_back(place->y - rest->near.y);
        } else if (const auto* measured = std::get_if<MeasuredRange>(&want)) {
            const std::optional<double> offset = offset_of(*measured, trial);
            if (!offset) {
                return {};
            }
            result.push_back(*offset);
        }
    }
    return result;
}

/// Where the balls are when the strike comes.
void StrikeTrials::find_start() {
    ++simulations_;
    sim::TrialLimits limits;
    limits.stop = work_.context.stop;
    std::size_t seen = 0;
    limits.is_answered = [&](const Event& event) {
        return event.kind == EventKind::strike && seen++ == strike_;
    };
    std::vector<sim::ForceEvent> events = trials_.world().events;
    events[problem_.event].action = with_setting(base_, {});
    const std::optional<Outcome> outcome = trials_.run(std::move(events), limits);
    if (!outcome || !outcome->is_stopped) {
        throw Error("the strike on '" + ball_ + "' never comes");
    }
    start_ = *outcome;
    for (const auto& [name, radius] : radii_) {
        if (const auto place = trial_of(start_).place_of(name)) {
            places_.emplace(name, *place);
        }
    }
}

std::optional<sim::WorldDescription> StrikeTrials::world_at_strike() const {
    const std::vector<sim::ForceEvent>& events = world().events;
    // Measures are of the whole shot.
    if (strike_ == 0 || problem_.event + 1 != events.size() || has<MeasuredRange>()) {
        return std::nullopt;
    }
    sim::WorldDescription later = world();
    later.events = {events[problem_.event]};
    later.events[0].time = later.events[0].after = 0;
    later.events[0].trigger.reset();
    later.duration -= start_.end_time;
    for (std::size_t i = 0; i < trials_.names().size(); ++i) {
        const std::string& name = trials_.names()[i];
        const MotionState& state = start_.states[i];
        const bool moves = name != ball_ && (state.velocity != Vec3(0, 0, 0) ||
                                             state.angular_velocity != Vec3(0, 0, 0));
        const auto body = std::ranges::find(later.bodies, name, &sim::Body::name);
        if (moves || body == later.bodies.end()) {
            return std::nullopt;
        }
        if (state.position.z < 0) {  // in a pocket
            later.bodies.erase(body);
            continue;
        }
        body->pose.position = state.position;
        body->pose.orientation = state.orientation;
        body->velocity = body->angular_velocity = Vec3(0, 0, 0);
    }
    const bool has_keys = std::ranges::any_of(
        later.bodies, [](const sim::Body& body) { return body.kind == sim::BodyKind::kinematic; });
    return has_keys ? std::nullopt : std::optional(std::move(later));
}

void StrikeTrials::find_targets() {
    const auto add_ball = [&](const std::string& ball, const std::string& other) {
        const auto place = places_.find(other);
        if (place != places_.end() && places_.contains(ball)) {
            targets_.push_back({ball, place->second, false});
        }
    };
    const sim::billiards::TableGeometry table =
        trials_.world().table ? build_table(*trials_.world().table, radii_.at(ball_))
                              : sim::billiards::TableGeometry{};
    const auto add = [&](const sim::Trigger& trigger, const std::string& pocket) {
        if (trigger.kind == sim::Trigger::Kind::potted) {
            for (const sim::billiards::Pocket& each : table.pockets) {
                if (pocket.empty() || pocket == each.name) {
                    targets_.push_back({trigger.a, each.centre, true});
                }
            }
        } else {
            add_ball(trigger.a, trigger.b);
            add_ball(trigger.b, trigger.a);
        }
    };
    for (const Want& want : problem_.wants) {
        const auto* happening = std::get_if<Happening>(&want);
        if (happening != nullptr && !happening->is_avoided()) {
            add(happening->trigger, happening->pocket);
            if (happening->before) {
                add(*happening->before, "");
            }
        }
    }
}

Sample StrikeTrials::sample_of(const Setting& setting, const Outcome& outcome) const {
    Sample sample;
    sample.direction = setting.direction;
    sample.is_met = is_met(outcome);
    if (sample.is_met) {
        sample.distance = targets_.empty() ? distance(outcome) : 0;
        sample.route = route_of(problem_.wants, trial_of(outcome));
    }
    const std::span<const Event> events = trial_of(outcome).events();
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        const bool is_same = i > 0 && targets_[i].ball == targets_[i - 1].ball;
        sample.legs.push_back(is_same ? sample.legs.back()
                                      : legs_of(targets_[i].ball, events, radii_));
    }
    return sample;
}

}  // namespace carom::pipeline::solve
