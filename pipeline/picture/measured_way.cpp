#include "pipeline/picture/measured_way.h"

#include <algorithm>
#include <cmath>

#include "sim/force_event.h"

namespace carom::pipeline {
namespace {

constexpr double kJustBefore = 1e-6;  // s
constexpr double kResting = 1e-3;     // m/s

std::optional<Vec3> level_direction(const Vec3& velocity) {
    const double speed = std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y);
    if (speed < kResting) {
        return std::nullopt;
    }
    return Vec3(velocity.x / speed, velocity.y / speed, 0);
}

/// The end that an event is for the way of an object which touched `other` at `contact`; none: the
/// event does not end it.
WayEnd end_of(const sim::Event& event, const std::string& object, const std::string& other,
              double contact) {
    using enum sim::EventKind;
    const bool is_first = event.a == object;
    if (!is_first && (event.kind != impact || event.b != object)) {
        return WayEnd::none;
    }
    switch (event.kind) {
        case impact: {
            const std::string& touched = is_first ? event.b : event.a;
            const bool is_same = touched == other && event.time - contact < sim::kOneContact;
            return event.surface() == sim::Surface::cloth || is_same ? WayEnd::none
                                                                     : WayEnd::contact;
        }
        case potted:
            return WayEnd::potted;
        case off_table:
            return WayEnd::off_table;
        case resting:
            return WayEnd::resting;
        case force:
        case torque:
        case impulse:
        case velocity:
        case strike:
        case placed:
        case removed:
            return WayEnd::moved;
        case sliding:
        case rolling:
        case spinning:
        case airborne:
            break;
    }
    return WayEnd::none;
}

/// Events after the contact up to a time, in order.
class Following {
  public:
    Following(const sim::Timeline& timeline, double contact)
        : begin_(std::ranges::lower_bound(timeline.events, contact, {}, &sim::Event::time)),
          end_(timeline.events.end()) {}

    [[nodiscard]] auto begin() const { return begin_; }
    [[nodiscard]] auto end() const { return end_; }

  private:
    std::vector<sim::Event>::const_iterator begin_, end_;
};

/// How the object moves at a time, by its last event before or at it: rolling, sliding or airborne.
sim::EventKind motion_at(const sim::Timeline& timeline, const std::string& object, double time) {
    using enum sim::EventKind;
    sim::EventKind motion = resting;
    for (const sim::Event& event : timeline.events) {
        if (event.time > time) {
            break;
        }
        const bool is_motion = event.kind == sliding || event.kind == rolling ||
                               event.kind == spinning || event.kind == airborne ||
                               event.kind == resting;
        if (event.a == object && is_motion) {
            motion = event.kind;
        }
    }
    return motion;
}

/// The time at which the object rolls first after the contact; empty if it does not before `end`.
std::optional<double> rolling_time(const sim::Timeline& timeline, const std::string& object,
                                   double contact, double end) {
    if (motion_at(timeline, object, contact + kJustBefore) == sim::EventKind::rolling) {
        return contact;
    }
    for (const sim::Event& event : Following(timeline, contact)) {
        if (event.time >= end) {
            break;
        }
        if (event.a == object && event.kind == sim::EventKind::rolling) {
            return event.time;
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<MeasuredWay> measured_way(const sim::Timeline& timeline, const std::string& object,
                                        const Contact& contact, const std::string& other,
                                        const MeasuringTime& asked) {
    const sim::Track* track = timeline.find(object);
    if (track == nullptr) {
        return std::nullopt;
    }
    MeasuredWay way;
    way.end_time = timeline.end_time;
    for (const sim::Event& event : Following(timeline, contact.time)) {
        const bool is_later = event.time > contact.time || event.kind != sim::EventKind::impact;
        way.end = is_later ? end_of(event, object, other, contact.time) : WayEnd::none;
        if (way.end != WayEnd::none) {
            const bool is_impact = event.kind == sim::EventKind::impact;
            way.other = is_impact && event.b == object ? event.a : event.b;
            way.end_time = event.time;
            break;
        }
    }
    const double last = std::max(contact.time, way.end_time - kJustBefore);
    way.end_place = track->sample(last).position;
    const std::optional<double> rolls =
        asked.is_rolling ? rolling_time(timeline, object, contact.time, way.end_time)
                         : std::optional(contact.time + asked.seconds);
    way.is_cut = !rolls || *rolls > last;
    way.measured = way.is_cut ? last : *rolls;
    way.direction = level_direction(track->sample(way.measured).velocity);
    // A ball that has come to rest by then has the direction in which it rolled before.
    for (double before = kJustBefore; !way.direction && way.is_cut; before *= 2) {
        if (!(way.measured - before > contact.time)) {
            break;
        }
        way.direction = level_direction(track->sample(way.measured - before).velocity);
    }
    const sim::EventKind motion = motion_at(timeline, object, way.measured);
    way.is_rolling = motion == sim::EventKind::rolling;
    way.is_flying = motion == sim::EventKind::airborne;
    return way;
}

}  // namespace carom::pipeline
