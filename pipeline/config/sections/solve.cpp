#include "pipeline/config/sections/solve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "core/assert.h"
#include "pipeline/config/measures/measures.h"
#include "pipeline/config/quantity.h"
#include "pipeline/config/sections/occurrences.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/text.h"
#include "sim/occurrence.h"

namespace carom::pipeline::config {
namespace {

using solve::Clearing;
using solve::Happening;
using solve::MeasuredRange;
using solve::PlayerError;
using solve::Preference;
using solve::RestPlace;
using solve::Want;

constexpr int kMostCounted = 100;
constexpr double kLongest = 3600;  // s

/// A want with all the keys that it may have.
struct WantKeys {
    std::optional<std::string> potted, cushions, rest, clears, in, measure;
    std::vector<std::string> contact;
    std::optional<int> at_least, at_most;
    std::optional<sim::EventTime> before;
    std::optional<double> by;
    std::optional<Vec2> near;
    double within = 0.1;
    MeasuredRange measured;  // of `measure`
};

/// What a measure's unit measures, and how far (m) a ball would be from its place that is as wrong
/// as one of that unit.
struct MeasureScale {
    std::string_view unit;
    Dimension dimension;
    double per_unit;
};

constexpr std::array kScales{MeasureScale{"", Dimension::none, 1},
                             MeasureScale{"m", Dimension::length, 1},
                             MeasureScale{"deg", Dimension::angle, 0.02},
                             MeasureScale{"m/s", Dimension::speed, 0.5},
                             MeasureScale{"rad/s", Dimension::angular_speed, 0.01},
                             MeasureScale{"s", Dimension::time, 0.5},
                             MeasureScale{"N s", Dimension::impulse, 2}};

/// A bound: how often something happens, or a quantity in the unit of a measure. It is read with
/// bound() when the whole want is known.
ValueType<Node> bound_type() {
    ValueType<Node> type;
    type.info.kind = TypeInfo::Kind::any_of;
    for (const MeasureScale& scale : kScales) {
        type.info.elements.push_back(quantity_info(scale.dimension, {}));
    }
    type.info.noun = "a number, with the unit of what it bounds";
    type.read = [](Reader&, const Node& node) { return std::optional(node); };
    return type;
}

template <class V>
std::optional<V> bound(Reader& reader, const Node& want, const char* key,
                       const ValueType<V>& type) {
    const Entry* entry = want.find(key);
    if (entry == nullptr) {
        return std::nullopt;
    }
    const Reader::Scope scope(reader, key, entry->key_place);
    return type.read(reader, entry->value);
}

const MeasureScale& scale_of(std::string_view unit) {
    const auto* found = std::ranges::find(kScales, unit, &MeasureScale::unit);
    CAROM_ASSERT(found != kScales.end());
    return *found;
}

/// The kind of the measure; nullptr after a problem.
const measures::MeasureInfo* kind_of(Reader& reader, const Node& node) {
    const std::string name = node.text.substr(0, node.text.find(':'));
    const auto list = measures::measure_list();
    const auto known = std::ranges::find(list, name, &measures::MeasureInfo::name);
    if (known == list.end()) {
        reader.error(node.place, measures::unknown_measure(name));
        return nullptr;
    }
    if (known->unit == "name") {
        reader.error(node.place, quote(name) +
                                     " is a name, not a number; write '{potted: BALL, in: "
                                     "POCKET}'");
        return nullptr;
    }
    return &*known;
}

/// Reads the range of a measure.
void read_measure(Reader& reader, const Node& node, WantKeys& want) {
    const Entry& entry = *node.find("measure");
    const measures::MeasureInfo* kind = kind_of(reader, entry.value);
    if (kind == nullptr) {
        return;
    }
    const MeasureScale& scale = scale_of(kind->unit);
    const ValueType<double> value = quantity(scale.dimension);
    const double unit =
        kind->unit.empty()
            ? 1
            : std::get<Quantity>(parse_quantity(fmt::format("1 {}", kind->unit))).value;
    const auto low = bound(reader, node, "at_least", value);
    const auto high = bound(reader, node, "at_most", value);
    const auto about = bound(reader, node, "about", value);
    const auto within = bound(reader, node, "within", quantity(scale.dimension, more_than(0)));
    const auto given = [&](const char* key) { return node.find(key) != nullptr; };
    if (reader.has_error()) {
        return;
    }
    if (given("about") != given("within")) {
        reader.error(entry.key_place, given("about")
                                          ? "'about' needs 'within', which says how far from it "
                                            "the measure may be"
                                          : "'within' needs 'about'");
    } else if (given("about") == (given("at_least") || given("at_most"))) {
        reader.error(entry.key_place,
                     "a measure is wanted 'at_least', 'at_most' or both, or 'about' a value and "
                     "'within' a distance from it");
    } else if (low && high && (*low > *high || (*low == *high && !kind->unit.empty()))) {
        reader.error(node.find("at_most")->value.place,
                     *low > *high ? "'at_most' must not be less than 'at_least'"
                                  : "'at_least' and 'at_most' are equal: no strike meets one value "
                                    "exactly");
    }
    MeasuredRange& range = want.measured;
    range.measure = *want.measure;
    range.per_unit = scale.per_unit;
    range.low = low ? *low / unit : about ? (*about - *within) / unit : range.low;
    range.high = high ? *high / unit : about ? (*about + *within) / unit : range.high;
}

const MapSpec<WantKeys>& want_spec() {
    static const MapSpec<WantKeys> spec = [] {
        MapSpec<WantKeys> s("want", "What the strike shall bring about.");
        const auto skip = [](WantKeys&, const Node&) {};
        s.key("potted", &WantKeys::potted, name_of(ReferenceKind::ball), "a ball that is potted");
        s.key("in", &WantKeys::in, name_of(ReferenceKind::pocket),
              "the pocket; by default any of them")
            .goes_with({"potted"});
        s.set(
            "contact", list_of(name_of(ReferenceKind::touchable), 2, 2),
            [](WantKeys& want, std::vector<std::string> names) { want.contact = std::move(names); },
            "two objects, or an object and a surface, that touch");
        s.key("cushions", &WantKeys::cushions, name_of(ReferenceKind::ball),
              "a ball that touches cushions, with `at_least` or `at_most`; the jaws of pockets do "
              "not "
              "count");
        s.key("rest", &WantKeys::rest, name_of(ReferenceKind::ball),
              "a ball that comes to rest near a place");
        s.key("near", &WantKeys::near, vector2(Dimension::length), "the place").needed_by("rest");
        s.set("within", bound_type(), skip,
              "how far from it the ball's centre may be; of a measure, "
              "how far from `about`",
              "0.1 m")
            .goes_with({"rest", "measure"});
        s.key("clears", &WantKeys::clears, name_of(ReferenceKind::ball),
              "a ball over which the struck ball flies without touching it");
        s.key("measure", &WantKeys::measure, text("a measure such as rebound_angle:cue,1"),
              "a measure of the whole shot that lies in a range; `carom sweep --measures` lists "
              "all");
        s.set("about", bound_type(), skip, "the middle of the range").goes_with({"measure"});
        s.set("at_least", bound_type(), skip,
              "how often, once by default; or the least value of a measure")
            .goes_with({"contact", "cushions", "measure"});
        s.set("at_most", bound_type(), skip, "how often at most; or the largest value of a measure")
            .goes_with({"contact", "cushions", "measure"});
        s.key("before", &WantKeys::before, condition(), "only what happens before this counts")
            .goes_with({"contact", "cushions", "potted"});
        s.key("by", &WantKeys::by, time(above_up_to(0, kLongest)),
              "only what happens within this time after the strike counts")
            .goes_with({"contact", "cushions", "potted"});
        s.exactly_one_of({"potted", "contact", "cushions", "rest", "clears", "measure"});
        s.check([](Reader& reader, const Node& node, WantKeys& want) {
            const Entry* before = node.find("before");
            if (want.before && (!sim::is_logged(want.before->trigger.kind) ||
                                want.before->trigger.nth != 1 || want.before->delay != 0)) {
                reader.error(before->value.place,
                             "'before' takes a contact, a cushion or a pot, without 'nth' and "
                             "'after'");
            }
            if (want.measure) {
                return read_measure(reader, node, want);
            }
            want.at_least = bound(reader, node, "at_least", integer(1, kMostCounted));
            want.at_most = bound(reader, node, "at_most", integer(0, kMostCounted));
            want.within = bound(reader, node, "within", length(above_up_to(0, 10))).value_or(0.1);
            if (want.at_least && want.at_most && *want.at_least > *want.at_most) {
                reader.error(node.find("at_most")->value.place,
                             "'at_most' must not be less than 'at_least'");
            }
        });
        return s;
    }();
    return spec;
}

/// What happens, and how often; `is_avoided`: that it does not.
Happening happening_of(const WantKeys& keys, bool is_avoided) {
    Happening want;
    want.trigger.kind = keys.potted ? sim::Trigger::Kind::potted : sim::Trigger::Kind::contact;
    if (keys.potted) {
        want.trigger.a = *keys.potted;
        want.pocket = keys.in.value_or("");
    } else if (keys.cushions) {
        want.trigger.a = *keys.cushions;
        want.trigger.b = "cushion";
        want.skips_jaws = true;
    } else {
        want.trigger.a = keys.contact.at(0);
        want.trigger.b = keys.contact.at(1);
    }
    want.at_least = is_avoided ? 0 : keys.at_least.value_or(keys.at_most ? 0 : 1);
    want.at_most = is_avoided ? keys.at_least.value_or(1) - 1 : keys.at_most.value_or(want.at_most);
    if (keys.before) {
        want.before = keys.before->trigger;
    }
    want.by = keys.by.value_or(want.by);
    return want;
}

WantSection section_of(const WantKeys& keys, bool is_avoided) {
    if (keys.rest) {
        return {RestPlace{*keys.rest, keys.near.value_or(Vec2(0, 0)), keys.within}, {}};
    }
    if (keys.measure) {
        return {keys.measured, {}};
    }
    if (keys.clears) {
        return {Clearing{"", *keys.clears}, {}};
    }
    return {happening_of(keys, is_avoided), {}};
}

/// A want of `want`, or of `avoid`.
ValueType<WantSection> want_type(bool is_avoided) {
    ValueType<WantSection> type;
    const ValueType<WantKeys> keys = record(want_spec());
    type.info = keys.info;
    type.read = [read = keys.read, is_avoided](Reader& reader,
                                               const Node& node) -> std::optional<WantSection> {
        const std::optional<WantKeys> want = read(reader, node);
        if (!want) {
            return std::nullopt;
        }
        const bool is_other = want->rest || want->clears || want->measure;
        if (is_avoided && (is_other || want->at_most)) {
            const char* key = want->rest      ? "rest"
                              : want->clears  ? "clears"
                              : want->measure ? "measure"
                                              : "at_most";
            reader.error(node.find(key)->key_place,
                         "'avoid' takes 'potted', 'contact' and 'cushions', without 'at_most'");
            return std::nullopt;
        }
        const bool is_whole =
            want->potted || want->cushions || is_other || want->contact.size() == 2;
        if (!is_whole) {
            return std::nullopt;
        }
        WantSection section = section_of(*want, is_avoided);
        section.place = want->measure ? node.find("measure")->value.place : node.place;
        return section;
    };
    return type;
}

/// Whether a happening that is to be avoided forbids the wanted one.
bool forbids(const Happening& avoided, const Happening& wanted) {
    const auto is_limited = [](const Happening& each) {
        return each.before.has_value() || std::isfinite(each.by);
    };
    const bool is_same =
        avoided.trigger.a == wanted.trigger.a && avoided.trigger.b == wanted.trigger.b;
    const bool is_swapped =
        avoided.trigger.a == wanted.trigger.b && avoided.trigger.b == wanted.trigger.a;
    return avoided.trigger.kind == wanted.trigger.kind && (is_same || is_swapped) &&
           (avoided.pocket.empty() || avoided.pocket == wanted.pocket) &&
           (wanted.skips_jaws || !avoided.skips_jaws) && wanted.at_least > avoided.at_most &&
           !is_limited(avoided) && !is_limited(wanted);
}

/// Reports what can never be met together.
void report_contradictions(Reader& reader, const SolveSection& section) {
    for (const WantSection& want : section.wants) {
        if (const auto* rest = std::get_if<RestPlace>(&want.want)) {
            const bool is_potted =
                std::ranges::any_of(section.wants, [&](const WantSection& other) {
                    const auto* pot = std::get_if<Happening>(&other.want);
                    return pot != nullptr && pot->trigger.kind == sim::Trigger::Kind::potted &&
                           pot->trigger.a == rest->ball;
                });
            if (is_potted) {
                reader.error(want.place,
                             quote(rest->ball) + " cannot be potted and come to rest on the table");
            }
            continue;
        }
        const auto* wanted = std::get_if<Happening>(&want.want);
        const bool is_avoided = wanted != nullptr &&
                                std::ranges::any_of(section.avoided, [&](const WantSection& other) {
                                    const auto* avoided = std::get_if<Happening>(&other.want);
                                    return avoided != nullptr && forbids(*avoided, *wanted);
                                });
        if (is_avoided) {
            reader.error(want.place,
                         wanted->trigger.kind == sim::Trigger::Kind::potted
                             ? "the pot of " + quote(wanted->trigger.a) + " is wanted and avoided"
                             : "the contact of " + quote(wanted->trigger.a) + " and " +
                                   quote(wanted->trigger.b) + " is wanted and avoided");
        }
    }
}

/// A word, or the standard deviations.
ValueType<PlayerError> player() {
    static const MapSpec<PlayerError> spec = [] {
        MapSpec<PlayerError> s("player",
                               "Standard deviations of what the player does from what is wanted.");
        s.key("direction", &PlayerError::direction, angle(between(0, std::numbers::pi / 2)),
              "of the direction");
        s.key("elevation", &PlayerError::elevation, angle(between(0, std::numbers::pi / 2)),
              "of the elevation");
        s.key("speed", &PlayerError::speed, number(between(0, 1)), "of the speed, as a part of it");
        s.key("tip", &PlayerError::tip, number(between(0, 1)),
              "of the tip's offset, each way, in ball radii");
        return s;
    }();
    std::vector<std::pair<std::string, PlayerError>> levels;
    for (const char* level : {"beginner", "club", "professional"}) {
        levels.emplace_back(level, *solve::player_error(level));
    }
    return any_of<PlayerError>({{is_scalar, choice<PlayerError>(levels)}, {is_map, record(spec)}});
}

}  // namespace

const MapSpec<SolveSection>& solve_spec() {
    static const MapSpec<SolveSection> spec = [] {
        MapSpec<SolveSection> s(
            "solve",
            "A strike is found by what it shall bring about. Of direction, speed and tip those are "
            "found that the strike does not give; its elevation is 0 unless it is given, a ball is "
            "to be cleared or no level strike does what is wanted.");
        s.key("strike", &SolveSection::event, integer(0, 10'000),
              "which of the `events` is the strike, from 0 on");
        s.key("want", &SolveSection::wants, list_of(want_type(false), 1), "what shall happen")
            .required();
        s.key("avoid", &SolveSection::avoided, list_of(want_type(true)),
              "what must not happen. Unless it is wanted, the struck ball is not potted");
        s.key("prefer", &SolveSection::prefer,
              list_of(choice<Preference>({{"likely", Preference::likely},
                                          {"slow", Preference::slow},
                                          {"little_spin", Preference::little_spin}})),
              "what makes one solution better than another; the first counts most. By default "
              "`[likely]`: the one that succeeds most often under the player's error");
        s.key("player", &SolveSection::player, player(),
              "whose errors count: `beginner`, `club` (the default), `professional`, or their "
              "standard deviations");
        s.check([](Reader& reader, const Node& /*node*/, SolveSection& section) {
            section.place = reader.key_place();
            report_contradictions(reader, section);
        });
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
