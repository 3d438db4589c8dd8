#include "pipeline/config/measures/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "core/length.h"
#include "core/text.h"
#include "pipeline/config/measures/measure_reader.h"
#include "pipeline/config/text.h"
#include "pipeline/report/event_motion.h"
#include "pipeline/report/shot_report.h"

namespace carom::pipeline::measures {

namespace {

using sim::Event;
using sim::EventKind;

constexpr double kDegrees = 180 / std::numbers::pi;

using ValueOf = std::function<Value(const Played&)>;

/// What a kind of measure makes of its arguments.
struct Made {
    ValueOf value;
    bool needs_motion = false;
};

struct Kind {
    MeasureInfo info;
    Made (*make)(Arguments& arguments);
};

Value number_or_nothing(const std::optional<double>& number) {
    return number ? Value(*number) : Value();
}

const sim::Track& track_of(const Played& played, const std::string& name) {
    return *played.outcome.motion->find(name);
}

Vec2 flat(const Vec3& v) {
    return {v.x, v.y};
}

double size(const Vec2& v) {
    return std::sqrt(v.dot(v));
}

/// The angle from `from` to `to`, counter-clockwise, in degrees; nothing if one of them is zero.
std::optional<double> angle_between(const Vec2& from, const Vec2& to) {
    if (from == Vec2(0, 0) || to == Vec2(0, 0)) {
        return std::nullopt;
    }
    return kDegrees * arctangent2(from.cross(to), from.dot(to));
}

// When and how often

Made time(Arguments& arguments) {
    const sim::EventTime moment = arguments.moment();
    return {[moment](const Played& played) { return number_or_nothing(time_of(moment, played)); },
            needs_motion(moment)};
}

Made potted(Arguments& arguments) {
    const std::string ball = arguments.ball();
    const std::string pocket = arguments.has_more() ? arguments.pocket() : std::string();
    arguments.end();
    return {[=](const Played& played) {
        const bool is_potted = std::ranges::any_of(played.outcome.events, [&](const Event& event) {
            return event.kind == EventKind::potted && event.a == ball &&
                   (pocket.empty() || event.b == pocket);
        });
        return Value(is_potted ? 1.0 : 0.0);
    }};
}

Made pocket(Arguments& arguments) {
    sim::Trigger trigger;
    trigger.kind = sim::Trigger::Kind::potted;
    trigger.a = arguments.ball();
    arguments.end();
    return {[trigger](const Played& played) {
        const Event* event = find_event(trigger, played);
        return event != nullptr ? Value(event->b) : Value();
    }};
}

Made contacts(Arguments& arguments) {
    const std::string a = arguments.ball();
    const std::string b = arguments.partner();
    arguments.end();
    return {[trigger = contact_of(a, b, 1)](const Played& played) {
        return Value(static_cast<double>(count_events(trigger, played)));
    }};
}

Made cushions(Arguments& arguments) {
    const std::string ball = arguments.ball();
    std::optional<sim::Trigger> before;
    if (arguments.has_more()) {
        const std::string other = arguments.partner();
        before = contact_of(ball, other, arguments.number());
    }
    arguments.end();
    return {[=](const Played& played) {
        const Event* last = before ? find_event(*before, played) : nullptr;
        if (before && last == nullptr) {
            return Value();
        }
        int count = 0;
        for (const Event& event : played.outcome.events) {
            if (&event == last) {
                break;
            }
            count += event.surface() == sim::Surface::cushion && event.a == ball ? 1 : 0;
        }
        return Value(static_cast<double>(count));
    }};
}

Made impulse(Arguments& arguments) {
    const std::string a = arguments.ball();
    const std::string b = arguments.partner();
    const sim::Trigger trigger = contact_of(a, b, arguments.number());
    arguments.end();
    return {[trigger](const Played& played) {
        const Event* event = find_event(trigger, played);
        return event != nullptr ? Value(event->normal_impulse) : Value();
    }};
}

// Motion at a moment

/// `of` makes a number of the velocities of the moment's object.
template <class Of>
Made at_moment(Arguments& arguments, Of of) {
    const sim::EventTime moment = arguments.moment();
    return {[moment, of](const Played& played) {
                const std::optional<double> when = time_of(moment, played);
                const std::string& name = moment.trigger.a;
                const sim::Track* track = played.outcome.motion->find(name);
                return when && track != nullptr ? number_or_nothing(of(*track, *when)) : Value();
            },
            true};
}

std::optional<double> direction_of(const Vec3& velocity) {
    return angle_between({1, 0}, flat(velocity));
}

Made speed_before(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return std::optional(length(velocities_at(track, when).before));
    });
}

Made speed_after(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return std::optional(length(velocities_at(track, when).after));
    });
}

Made direction_before(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return direction_of(velocities_at(track, when).before);
    });
}

Made direction_after(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return direction_of(velocities_at(track, when).after);
    });
}

Made spin_before(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return std::optional(length(velocities_at(track, when).spin_before));
    });
}

Made spin_after(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return std::optional(length(velocities_at(track, when).spin_after));
    });
}

Made side_spin_before(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return std::optional(velocities_at(track, when).spin_before.z);
    });
}

Made side_spin_after(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return std::optional(velocities_at(track, when).spin_after.z);
    });
}

Made x_at(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return std::optional(track.sample(when).position.x);
    });
}

Made y_at(Arguments& arguments) {
    return at_moment(arguments, [](const sim::Track& track, double when) {
        return std::optional(track.sample(when).position.y);
    });
}

// At a cushion

double radius_of(const std::string& ball, const sim::WorldDescription& world) {
    const auto body = std::ranges::find(world.bodies, ball, &sim::Body::name);
    const auto* sphere = std::get_if<sim::Sphere>(&body->shape);
    return sphere != nullptr ? sphere->radius : 0;
}

/// The velocity once the ball rolls again: sliding friction leaves 5 v + 2 R (spin x up) unchanged.
Vec2 rolling_velocity(const Vec3& velocity, const Vec3& spin, double radius) {
    return (Vec2(velocity.x, velocity.y) * 5 + Vec2(spin.y, -spin.x) * (2 * radius)) / 7;
}

/// The impact of a ball at a cushion, seen from above.
struct Rebound {
    Vec2 normal;                  // away from the cushion
    Vec2 along;                   // the way in which the ball arrives
    Vec2 before, after, rolling;  // velocities, m/s

    /// From the normal, in degrees; negative: back to where the ball came from.
    [[nodiscard]] double angle(const Vec2& velocity) const {
        return kDegrees * arctangent2(velocity.dot(along), velocity.dot(normal));
    }
};

template <class Of>
Made at_cushion(Arguments& arguments, Of of) {
    const std::string ball = arguments.ball();
    const sim::Trigger trigger = contact_of(ball, "cushion", arguments.number());
    arguments.end();
    return {[trigger, of](const Played& played) {
                const Event* event = find_event(trigger, played);
                if (event == nullptr || flat(event->normal) == Vec2(0, 0)) {
                    return Value();
                }
                const Velocities v = velocities_at(track_of(played, trigger.a), event->time);
                Rebound rebound;
                rebound.normal = flat(event->normal) / size(flat(event->normal));
                rebound.along = {-rebound.normal.y, rebound.normal.x};
                rebound.before = flat(v.before);
                rebound.after = flat(v.after);
                rebound.rolling =
                    rolling_velocity(v.after, v.spin_after, radius_of(trigger.a, played.world));
                if (rebound.before.dot(rebound.along) < 0) {
                    rebound.along = -rebound.along;
                }
                return Value(of(rebound));
            },
            true};
}

Made incidence(Arguments& arguments) {
    return at_cushion(arguments, [](const Rebound& r) {
        return kDegrees * arctangent2(r.before.dot(r.along), -r.before.dot(r.normal));
    });
}

Made rebound_angle(Arguments& arguments) {
    return at_cushion(arguments, [](const Rebound& r) { return r.angle(r.after); });
}

Made rolling_angle(Arguments& arguments) {
    return at_cushion(arguments, [](const Rebound& r) { return r.angle(r.rolling); });
}

Made speed_kept(Arguments& arguments) {
    return at_cushion(arguments, [](const Rebound& r) { return size(r.after) / size(r.before); });
}

Made rolling_kept(Arguments& arguments) {
    return at_cushion(arguments, [](const Rebound& r) { return size(r.rolling) / size(r.before); });
}

// At a contact of two

template <class Of>
Made at_contact(Arguments& arguments, Of of) {
    const std::string a = arguments.ball();
    const std::string b = arguments.ball();
    const sim::Trigger trigger = contact_of(a, b, arguments.number());
    arguments.end();
    return {[trigger, of](const Played& played) {
                const Event* event = find_event(trigger, played);
                return event != nullptr ? number_or_nothing(of(played, trigger, *event)) : Value();
            },
            true};
}

Made cut(Arguments& arguments) {
    return at_contact(arguments, [](const Played& played, const sim::Trigger&, const Event& event) {
        const std::optional<double> angle =
            cut_of(event, &track_of(played, event.a), &track_of(played, event.b));
        return angle ? std::optional(kDegrees * *angle) : std::nullopt;
    });
}

Made throw_of(Arguments& arguments) {
    return at_contact(
        arguments, [](const Played& played, const sim::Trigger& trigger, const Event& event) {
            const Vec2 line = flat(event.b == trigger.a ? event.normal : -event.normal);
            return angle_between(
                line, flat(velocities_at(track_of(played, trigger.b), event.time).after));
        });
}

// The end

/// The centre of a ball that rests on the table at the end.
std::optional<Vec2> resting_place(const Played& played, const std::string& ball) {
    bool is_gone = false;
    for (const Event& event : played.outcome.events) {
        if (event.a == ball) {
            is_gone = event.kind == EventKind::potted || event.kind == EventKind::off_table ||
                      event.kind == EventKind::removed ||
                      (is_gone && event.kind != EventKind::placed);
        }
    }
    const auto at = std::ranges::find(played.names, ball) - played.names.begin();
    const MotionState& state = played.outcome.states[static_cast<std::size_t>(at)];
    const Vec3 still(0, 0, 0);
    return is_gone || state.velocity != still || state.angular_velocity != still
               ? std::nullopt
               : std::optional(flat(state.position));
}

template <class Of>
Made at_rest(Arguments& arguments, const std::string& ball, Of of) {
    arguments.end();
    return {[ball, of](const Played& played) {
        const std::optional<Vec2> place = resting_place(played, ball);
        return place ? Value(of(*place)) : Value();
    }};
}

Made rest_x(Arguments& arguments) {
    return at_rest(arguments, arguments.ball(), [](const Vec2& place) { return place.x; });
}

Made rest_y(Arguments& arguments) {
    return at_rest(arguments, arguments.ball(), [](const Vec2& place) { return place.y; });
}

Made rest_distance(Arguments& arguments) {
    const std::string ball = arguments.ball();
    const double x = arguments.length();
    const double y = arguments.length();
    return at_rest(arguments, ball, [=](const Vec2& place) { return size(place - Vec2(x, y)); });
}

// The whole motion

template <class Of>
Made of_motion(Arguments& arguments, Of of) {
    const std::string ball = arguments.ball();
    arguments.end();
    return {[ball, of](const Played& played) {
                return Value(of(report_of(*played.outcome.motion, track_of(played, ball))));
            },
            true};
}

Made distance(Arguments& arguments) {
    return of_motion(arguments, [](const ReportedObject& object) { return object.path; });
}

Made top_speed(Arguments& arguments) {
    return of_motion(arguments, [](const ReportedObject& object) { return object.top_speed; });
}

Made rise(Arguments& arguments) {
    return of_motion(arguments, [](const ReportedObject& object) { return object.rise; });
}

constexpr std::array kKinds{
    Kind{{"time", "MOMENT", "s", "When the moment comes."}, time},
    Kind{{"potted", "BALL[,POCKET]", "", "1 if the ball is potted (into that pocket), else 0."},
         potted},
    Kind{{"pocket", "BALL", "name", "The pocket into which the ball falls."}, pocket},
    Kind{{"contacts", "BALL,OTHER", "", "How often the two touch; OTHER may be a surface."},
         contacts},
    Kind{{"cushions", "BALL[,OTHER[,N]]", "",
          "How many cushions the ball meets (before its N-th contact with OTHER)."},
         cushions},
    Kind{{"impulse", "BALL,OTHER[,N]", "N s", "The normal impulse of the N-th contact of the two."},
         impulse},
    Kind{{"speed_before", "MOMENT", "m/s", "The object's speed right before the moment."},
         speed_before},
    Kind{{"speed_after", "MOMENT", "m/s", "The object's speed right after the moment."},
         speed_after},
    Kind{{"direction_before", "MOMENT", "deg",
          "The object's direction right before the moment, counter-clockwise from +x."},
         direction_before},
    Kind{{"direction_after", "MOMENT", "deg",
          "The object's direction right after the moment, counter-clockwise from +x."},
         direction_after},
    Kind{{"spin_before", "MOMENT", "rad/s", "The object's angular speed right before the moment."},
         spin_before},
    Kind{{"spin_after", "MOMENT", "rad/s", "The object's angular speed right after the moment."},
         spin_after},
    Kind{{"side_spin_before", "MOMENT", "rad/s",
          "Its spin about the vertical right before; counter-clockwise from above is positive."},
         side_spin_before},
    Kind{{"side_spin_after", "MOMENT", "rad/s",
          "Its spin about the vertical right after; counter-clockwise from above is positive."},
         side_spin_after},
    Kind{{"x", "MOMENT", "m", "The x coordinate of the object's centre at the moment."}, x_at},
    Kind{{"y", "MOMENT", "m", "The y coordinate of the object's centre at the moment."}, y_at},
    Kind{{"incidence", "BALL[,N]", "deg",
          "The angle from the normal at which the ball arrives at its N-th cushion."},
         incidence},
    Kind{{"rebound_angle", "BALL[,N]", "deg",
          "The angle from the normal at which it leaves; negative: back to where it came from."},
         rebound_angle},
    Kind{{"rolling_angle", "BALL[,N]", "deg",
          "Its angle from the normal once it rolls again, if it meets nothing until then."},
         rolling_angle},
    Kind{{"speed_kept", "BALL[,N]", "", "The speed right after the N-th cushion / that before it."},
         speed_kept},
    Kind{{"rolling_kept", "BALL[,N]", "",
          "The speed once the ball rolls again after the N-th cushion / that before it."},
         rolling_kept},
    Kind{{"cut", "BALL,BALL[,N]", "deg",
          "The cut angle of the N-th contact of the two; 0 is a full hit."},
         cut},
    Kind{{"throw", "BALL,BALL[,N]", "deg",
          "From the line of centres to the second ball's way; counter-clockwise is positive."},
         throw_of},
    Kind{
        {"rest_x", "BALL", "m", "The x coordinate of the ball's centre where it rests at the end."},
        rest_x},
    Kind{
        {"rest_y", "BALL", "m", "The y coordinate of the ball's centre where it rests at the end."},
        rest_y},
    Kind{{"rest_distance", "BALL,X,Y", "m",
          "How far from the point (X, Y) the ball rests at the end."},
         rest_distance},
    Kind{{"distance", "BALL", "m", "The length of the ball's path."}, distance},
    Kind{{"top_speed", "BALL", "m/s", "The ball's highest speed."}, top_speed},
    Kind{{"rise", "BALL", "m", "How far the ball's centre rises above where it starts."}, rise}};

}  // namespace

std::span<const MeasureInfo> measure_list() {
    static const std::vector<MeasureInfo> list = [] {
        std::vector<MeasureInfo> all;
        all.reserve(kKinds.size());
        for (const Kind& kind : kKinds) {
            all.push_back(kind.info);
        }
        return all;
    }();
    return list;
}

std::string unknown_measure(const std::string& name) {
    std::vector<std::string> known;
    known.reserve(kKinds.size());
    for (const Kind& kind : kKinds) {
        known.emplace_back(kind.info.name);
    }
    return "there is no measure " + config::quote(name) + config::hint(name, known).text +
           "; 'carom sweep --measures' lists them";
}

std::string Measure::title() const {
    const bool has_unit = !info->unit.empty() && info->unit != "name";
    return has_unit ? text + " [" + std::string(info->unit) + "]" : text;
}

std::variant<Measure, TextProblem> parse_measure(const std::string& text,
                                                 const sim::WorldDescription& world) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string name = text.substr(0, colon);
    const auto kind = std::ranges::find(kKinds, name, [](const Kind& k) { return k.info.name; });
    if (kind == kKinds.end()) {
        return TextProblem{unknown_measure(name), 0, std::max<std::size_t>(name.size(), 1)};
    }
    const std::string usage = name + ":" + std::string(kind->info.arguments);
    try {
        Arguments arguments(text, colon + (colon < text.size() ? 1 : 0), usage, world);
        Made made = kind->make(arguments);
        return Measure{text, &measure_list()[static_cast<std::size_t>(kind - kKinds.begin())],
                       made.needs_motion, std::move(made.value)};
    } catch (const WrongMeasure& wrong) {
        return wrong.problem;
    }
}

}  // namespace carom::pipeline::measures
