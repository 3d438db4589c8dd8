#include "pipeline/solve/wants.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "pipeline/solve/legs.h"
#include "sim/occurrence.h"

namespace carom::pipeline::solve {
namespace {

using sim::Event;
using sim::EventKind;

/// The part of the log from that strike on.
std::span<const Event> since(const std::vector<Event>& events, std::size_t strike) {
    std::size_t seen = 0;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (events[i].kind == EventKind::strike && seen++ == strike) {
            return std::span(events).subspan(i);
        }
    }
    return {};
}

const sim::Body* body_of(const sim::WorldDescription& world, const std::string& name) {
    const auto found = std::ranges::find(world.bodies, name, &sim::Body::name);
    return found != world.bodies.end() ? &*found : nullptr;
}

double radius_of(const sim::WorldDescription& world, const std::string& name) {
    const sim::Body* body = body_of(world, name);
    const auto* sphere = body != nullptr ? std::get_if<sim::Sphere>(&body->shape) : nullptr;
    return sphere != nullptr ? sphere->radius : 0;
}

double distance_to_segment(const Vec2& from, const Vec2& to, const Vec2& point) {
    const Vec2 along = to - from;
    const double square = along.dot(along);
    const double part = square > 0 ? std::clamp((point - from).dot(along) / square, 0.0, 1.0) : 0;
    const Vec2 d = point - from - along * part;
    return std::sqrt(d.dot(d));
}

/// The distance (m) by which no flight of the ball passes over the blocker.
double miss_of_flight(const Clearing& want, const Trial& trial) {
    const double radius = radius_of(trial.world, want.ball);
    const sim::Body* blocker = body_of(trial.world, want.blocker);
    if (blocker == nullptr) {
        return 1;
    }
    Vec2 over(blocker->pose.position.x, blocker->pose.position.y);
    double least = 1;
    std::optional<Vec2> left;
    for (const Event& event : trial.events()) {
        const bool is_contact =
            event.kind == EventKind::impact && ((event.a == want.ball && event.b == want.blocker) ||
                                                (event.b == want.ball && event.a == want.blocker));
        if (is_contact) {
            break;
        }
        if (event.a != want.ball) {
            continue;
        }
        const Vec2 place(event.place.x, event.place.y);
        if (event.kind == EventKind::airborne) {
            left = place;
        } else if (left) {
            least = std::min(least, distance_to_segment(*left, place, over) - 0.5 * radius);
            left.reset();
        }
    }
    return std::max(least, 0.0);
}

/// Farther than any place on a table, m.
constexpr double kNever = 10;

std::optional<double> value_of(const MeasuredRange& want, const Trial& trial) {
    return trial.outcome.is_stopped ? std::nullopt : want.value(trial);
}

double miss_of_measure(const MeasuredRange& want, const Trial& trial) {
    const std::optional<double> value = value_of(want, trial);
    return value ? want.per_unit * std::max({want.low - *value, *value - want.high, 0.0}) : kNever;
}

double miss_of_rest(const RestPlace& want, const Trial& trial) {
    const std::optional<Vec2> place = trial.place_of(want.ball);
    if (!place || trial.outcome.is_stopped) {
        return kNever;
    }
    const Vec2 d = *place - want.near;
    return std::max(std::sqrt(d.dot(d)) - want.within, 0.0);
}

double miss_of_happening(const Happening& want, const Trial& trial) {
    sim::OccurrenceCounter counter(want.trigger);
    std::optional<sim::OccurrenceCounter> before;
    if (want.before) {
        before.emplace(*want.before);
    }
    int count = 0;
    bool is_closed = false;
    const std::span<const Event> events = trial.events();
    for (const Event& event : events) {
        if (event.time - events.front().time > want.by || (before && before->counts(event))) {
            is_closed = true;
            break;
        }
        count += may_count(want, event) && counter.counts(event) ? 1 : 0;
    }
    const bool lacks_end = want.before && !is_closed;
    return std::max({want.at_least - count, count - want.at_most, 0}) + (lacks_end ? 1 : 0);
}

}  // namespace

bool may_count(const Happening& want, const Event& event) {
    const bool is_jaw = want.skips_jaws && event.kind == EventKind::impact &&
                        event.surface() == sim::Surface::cushion && side_of(event.normal).empty();
    return !is_jaw && (want.pocket.empty() || event.b == want.pocket);
}

std::span<const Event> Trial::events() const {
    return since(outcome.events, strike);
}

std::optional<Vec2> Trial::place_of(const std::string& ball) const {
    const auto found = std::ranges::find(names, ball);
    if (found == names.end()) {
        return std::nullopt;
    }
    const Vec3& place = outcome.states[static_cast<std::size_t>(found - names.begin())].position;
    if (place.z < 0) {
        return std::nullopt;
    }
    return Vec2(place.x, place.y);
}

double miss_of(const Want& want, const Trial& trial) {
    if (const auto* rest = std::get_if<RestPlace>(&want)) {
        return miss_of_rest(*rest, trial);
    }
    if (const auto* measured = std::get_if<MeasuredRange>(&want)) {
        return miss_of_measure(*measured, trial);
    }
    if (const auto* clearing = std::get_if<Clearing>(&want)) {
        return miss_of_flight(*clearing, trial);
    }
    return miss_of_happening(std::get<Happening>(want), trial);
}

double distance_of(const Want& want, const Trial& trial) {
    if (const auto* rest = std::get_if<RestPlace>(&want)) {
        RestPlace exact = *rest;
        exact.within = 0;
        return miss_of(exact, trial) / rest->within;
    }
    const auto* measured = std::get_if<MeasuredRange>(&want);
    if (measured == nullptr) {
        return 0;
    }
    const std::optional<double> offset = offset_of(*measured, trial);
    const double half = 0.5 * measured->per_unit * (measured->high - measured->low);
    constexpr double kOff = 0.1;  // m, of a range without an end, or of a single number
    return std::abs(offset.value_or(kNever)) / (std::isfinite(half) && half > 0 ? half : kOff);
}

std::optional<double> offset_of(const MeasuredRange& want, const Trial& trial) {
    const std::optional<double> value = value_of(want, trial);
    if (!value) {
        return std::nullopt;
    }
    const double half = 0.5 * (want.high - want.low);
    const double nearest =
        std::isfinite(half) ? want.low + half : std::clamp(*value, want.low, want.high);
    return want.per_unit * (*value - nearest);
}

Watch::Watch(const std::vector<Want>& wants, std::size_t strike) : strike_(strike) {
    for (const Want& want : wants) {
        if (const auto* happening = std::get_if<Happening>(&want)) {
            counts_.push_back({happening});
        }
    }
}

void Watch::see(const Event& event) {
    if (event.kind == EventKind::strike) {
        began_ = seen_strikes_++ == strike_ ? event.time : began_;
    }
    if (!has_begun()) {
        return;
    }
    bool is_met = true;
    for (Count& each : counts_) {
        const Happening& want = *each.wanted;
        const auto occurs = [&](const sim::Trigger& trigger) {
            return sim::OccurrenceCounter(trigger).counts(event);
        };
        if (!each.is_closed && event.time - began_ <= want.by) {
            if (want.before && occurs(*want.before)) {
                each.is_closed = true;
            } else if (may_count(want, event) && occurs(want.trigger)) {
                const bool is_new = want.trigger.kind != sim::Trigger::Kind::contact ||
                                    each.last_contact < 0 ||
                                    event.time - each.last_contact > sim::kOneContact;
                each.last_contact = event.time;
                each.count += is_new ? 1 : 0;
            }
        }
        const bool is_over = each.is_closed || event.time - began_ > want.by;
        has_failed_ |= each.count > want.at_most || (is_over && each.count < want.at_least);
        is_met &= each.count >= want.at_least && (!want.before || each.is_closed);
    }
    is_met_ = is_met;
}

}  // namespace carom::pipeline::solve
