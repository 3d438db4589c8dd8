#include "pipeline/config/sections/occurrences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "sim/timeline/surface.h"

namespace carom::pipeline::config {

namespace {

using sim::EventTime;
using sim::Trigger;

constexpr double kLongest = 3600;  // s
constexpr int kMostCounted = 100'000;
constexpr std::array<std::string_view, 7> kKinds{"contact",  "cushion", "potted", "resting",
                                                 "crossing", "strike",  "apex"};

const MapSpec<Trigger>& crossing_spec() {
    static const MapSpec<Trigger> spec = [] {
        Trigger prototype;
        prototype.kind = Trigger::Kind::crossing;
        // A point that could not be read is NaN, so that it differs from the other one.
        prototype.from = prototype.to = Vec2(std::numeric_limits<double>::quiet_NaN());
        MapSpec<Trigger> s("crossing",
                           "The centre of an object, seen from above, crosses the line between two "
                           "points in either direction.",
                           prototype);
        s.key("object", &Trigger::a, name_of(ReferenceKind::simulated), "the ball or object")
            .required();
        s.key("from", &Trigger::from, vector2(Dimension::length), "one end point of the line")
            .required();
        s.key("to", &Trigger::to, vector2(Dimension::length), "the other end point of the line")
            .required();
        s.check([](Reader& reader, const Node& node, Trigger& trigger) {
            if (trigger.from == trigger.to) {
                reader.error(node.find("to")->value.place,
                             "'from' and 'to' are the same point: a line needs two");
            }
        });
        return s;
    }();
    return spec;
}

/// `all`, as an empty name, or the name of an object.
ValueType<std::string> everything_or_name() {
    const auto everything =
        convert<std::string>(choice<bool>({{"all", true}}), [](bool) { return std::string(); });
    return any_of<std::string>(
        {{[](const Node& node) { return node.is_scalar() && node.text == "all"; }, everything},
         {is_scalar, name_of(ReferenceKind::simulated)}});
}

/// Adds a key whose value is the name of the object to which something happens.
void add_kind(MapSpec<EventTime>& s, std::string_view key, Trigger::Kind kind,
              const ValueType<std::string>& name, std::string_view description) {
    s.set(
        key, name,
        [kind](EventTime& moment, std::string object) {
            moment.trigger.kind = kind;
            moment.trigger.a = std::move(object);
        },
        description);
}

/// The object of a contact comes first; the two names may be given in any order.
void check_contact(Reader& reader, const Node& node, EventTime& moment) {
    Trigger& trigger = moment.trigger;
    if (trigger.kind != Trigger::Kind::contact || !sim::is_surface(trigger.a)) {
        return;
    }
    std::swap(trigger.a, trigger.b);
    if (sim::is_surface(trigger.a)) {
        reader.error(node.find("contact")->value.place,
                     "'" + trigger.b + "' and '" + trigger.a +
                         "' are parts of the table; one of the two has to be an object");
    }
}

/// Adds what can happen, without delays.
void add_kinds(MapSpec<EventTime>& s) {
    s.set(
        "contact", list_of(name_of(ReferenceKind::touchable), 2, 2),
        [](EventTime& moment, const std::vector<std::string>& names) {
            moment.trigger.kind = Trigger::Kind::contact;
            moment.trigger.a = names[0];
            moment.trigger.b = names[1];
        },
        "two objects, or an object and a surface such as `cushion`, touch. Impacts within 10 ms of "
        "each other are one contact");
    s.set(
        "cushion", name_of(ReferenceKind::body),
        [](EventTime& moment, std::string name) {
            moment.trigger.kind = Trigger::Kind::contact;
            moment.trigger.a = std::move(name);
            moment.trigger.b = "cushion";
        },
        "an object touches a cushion");
    add_kind(s, "potted", Trigger::Kind::potted, name_of(ReferenceKind::body),
             "an object falls into a pocket");
    add_kind(s, "resting", Trigger::Kind::resting, everything_or_name(),
             "an object, or `all`, comes to rest after it has moved since the start of the shot. "
             "Several events that wait for the same object happen one after the other, in the "
             "order of the list: each waits for a motion that begins after the previous event");
    s.set(
        "crossing", record(crossing_spec()),
        [](EventTime& moment, Trigger crossing) { moment.trigger = std::move(crossing); },
        "an object crosses a line");
    add_kind(s, "strike", Trigger::Kind::strike, name_of(ReferenceKind::ball),
             "a stick strikes a ball");
    add_kind(s, "apex", Trigger::Kind::apex, name_of(ReferenceKind::simulated),
             "an object is at the highest point of a flight, after it rose by 1 mm or more");
    s.key(
        "nth", [](EventTime& moment) -> int& { return moment.trigger.nth; },
        integer(1, kMostCounted), "which occurrence is meant: 2 is the second one");
    s.check(check_contact);
    s.exactly_one_of({kKinds.begin(), kKinds.end()});
}

const MapSpec<EventTime>& condition_spec() {
    static const MapSpec<EventTime> spec = [] {
        MapSpec<EventTime> s("when", "A condition in the shot that starts an event.");
        add_kinds(s);
        s.key("after", &EventTime::delay, time(between(0, kLongest)),
              "delay; the same as the event's own `after`");
        s.refuse("before",
                 "asks for an effect ahead of its cause: the event cannot happen before "
                 "what it waits for");
        return s;
    }();
    return spec;
}

const MapSpec<EventTime>& moment_spec() {
    static const MapSpec<EventTime> spec = [] {
        MapSpec<EventTime> s("moment",
                             "A scene time that is named by what happens in the shot. 'carom plan' "
                             "and 'carom info --resolved' show it in seconds.");
        add_kinds(s);
        const auto delay = time(between(0, kLongest));
        s.set(
            "before", delay, [](EventTime& moment, double time) { moment.delay = -time; },
            "time by which the moment is before that");
        s.set(
            "after", delay, [](EventTime& moment, double time) { moment.delay = time; },
            "time by which the moment is after that");
        s.at_most_one_of({"before", "after"});
        return s;
    }();
    return spec;
}

/// A number, or a moment as the number that `from_seconds` makes of its time.
template <class V, class FromSeconds>
ValueType<V> number_or_moment(const ValueType<V>& number, FromSeconds from_seconds) {
    const ValueType<EventTime> moment = record(moment_spec());
    ValueType<V> at_moment;
    at_moment.info = moment.info;
    at_moment.read = [read = moment.read, from_seconds](Reader& reader,
                                                        const Node& node) -> std::optional<V> {
        const std::optional<EventTime> named = read(reader, node);
        const std::optional<double> time =
            named ? reader.time_of(*named, node) : std::optional<double>();
        return time ? std::optional<V>(from_seconds(*time)) : std::nullopt;
    };
    ValueType<V> result =
        any_of<V>({{[](const Node& node) { return !node.is_map(); }, number}, {is_map, at_moment}});
    result.show = number.show;
    return result;
}

}  // namespace

ValueType<EventTime> condition() {
    return record(condition_spec());
}

ValueType<EventTime> moment() {
    return record(moment_spec());
}

ValueType<double> scene_time() {
    return number_or_moment(time(between(0, kLongest)), [](double time) { return time; });
}

ValueType<Rational> exact_scene_time() {
    return number_or_moment(exact(Dimension::time, between(0, kLongest)), [](double time) {
        return Rational(std::llround(time * kMomentTicks), kMomentTicks);
    });
}

bool is_moment(const Node& node) {
    return std::any_of(kKinds.begin(), kKinds.end(),
                       [&](std::string_view kind) { return node.find(kind) != nullptr; });
}

}  // namespace carom::pipeline::config
