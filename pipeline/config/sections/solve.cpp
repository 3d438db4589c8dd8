#include "pipeline/config/sections/solve.h"

#include <numbers>
#include <utility>

#include "pipeline/config/sections/occurrences.h"
#include "pipeline/config/sections/sections.h"
#include "sim/occurrence.h"

namespace carom::pipeline::config {
namespace {

using solve::Clearing;
using solve::Happening;
using solve::PlayerError;
using solve::Preference;
using solve::RestPlace;
using solve::Want;

constexpr int kMostCounted = 100;
constexpr double kLongest = 3600;  // s

/// A want with all the keys that it may have.
struct WantKeys {
    std::optional<std::string> potted, cushions, rest, clears, in;
    std::vector<std::string> contact;
    std::optional<int> at_least, at_most;
    std::optional<sim::EventTime> before;
    std::optional<double> by;
    std::optional<Vec2> near;
    double within = 0.1;
};

const MapSpec<WantKeys>& want_spec() {
    static const MapSpec<WantKeys> spec = [] {
        MapSpec<WantKeys> s("want", "What the strike shall bring about.");
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
        s.key("within", &WantKeys::within, length(above_up_to(0, 10)),
              "how far from it the ball's centre may be")
            .goes_with({"rest"});
        s.key("clears", &WantKeys::clears, name_of(ReferenceKind::ball),
              "a ball over which the struck ball flies without touching it");
        s.key("at_least", &WantKeys::at_least, integer(1, kMostCounted),
              "how often; once by default")
            .goes_with({"contact", "cushions"});
        s.key("at_most", &WantKeys::at_most, integer(0, kMostCounted), "how often at most")
            .goes_with({"contact", "cushions"});
        s.key("before", &WantKeys::before, condition(), "only what happens before this counts")
            .goes_with({"contact", "cushions", "potted"});
        s.key("by", &WantKeys::by, time(above_up_to(0, kLongest)),
              "only what happens within this time after the strike counts")
            .goes_with({"contact", "cushions", "potted"});
        s.exactly_one_of({"potted", "contact", "cushions", "rest", "clears"});
        s.check([](Reader& reader, const Node& node, WantKeys& want) {
            const Entry* before = node.find("before");
            if (want.before && (!sim::is_logged(want.before->trigger.kind) ||
                                want.before->trigger.nth != 1 || want.before->delay != 0)) {
                reader.error(before->value.place,
                             "'before' takes a contact, a cushion or a pot, without 'nth' and "
                             "'after'");
            }
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
        if (is_avoided && (want->rest || want->clears || want->at_most)) {
            const char* key = want->rest ? "rest" : want->clears ? "clears" : "at_most";
            reader.error(node.find(key)->key_place,
                         "'avoid' takes 'potted', 'contact' and 'cushions', without 'at_most'");
            return std::nullopt;
        }
        const bool is_whole = want->potted || want->cushions || want->rest || want->clears ||
                              want->contact.size() == 2;
        if (!is_whole) {
            return std::nullopt;
        }
        WantSection section = section_of(*want, is_avoided);
        section.place = node.place;
        return section;
    };
    return type;
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
        });
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
