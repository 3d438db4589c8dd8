#include <optional>
#include <string>

#include <fmt/core.h>

#include "pipeline/config/conditions.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"

namespace carom::pipeline::config {

namespace {

using sim::BallBall;
using sim::BallCloth;
using sim::BallCushion;
using sim::PairContact;
using World = sim::WorldDescription;

constexpr double kLargestFriction = 10;

const MapSpec<BallCloth>& ball_cloth_spec() {
    static const MapSpec<BallCloth> spec = [] {
        MapSpec<BallCloth> s("ball_cloth",
                             "Friction and restitution between a ball and the cloth.");
        s.key("sliding_friction", &BallCloth::sliding_friction,
              number(between(0, kLargestFriction)),
              "coefficient of friction while the ball slides on the cloth");
        s.key("rolling_friction", &BallCloth::rolling_friction, number(between(0, 1)),
              "deceleration of a rolling ball as a fraction of gravity");
        s.key("spinning_friction", &BallCloth::spinning_friction, number(between(0, 1)),
              "mu in 5/2 mu g / R, the rate at which spin about the vertical axis decays");
        s.key("restitution", &BallCloth::restitution, number(between(0, 1)),
              "coefficient of restitution of a ball that falls on the slate");
        return s;
    }();
    return spec;
}

/// A coefficient of friction, or the name of a law for it.
ValueType<BallBall> ball_friction() {
    const auto constant = convert<BallBall>(number(between(0, kLargestFriction)), [](double value) {
        BallBall law;
        law.friction = value;
        law.friction_model = sim::BallFriction::constant;
        return law;
    });
    const auto by_speed =
        convert<BallBall>(choice<sim::BallFriction>({{"alciatore", sim::BallFriction::alciatore}}),
                          [](sim::BallFriction model) {
                              BallBall law;
                              law.friction_model = model;
                              return law;
                          });
    return any_of<BallBall>({{is_number, constant}, {is_scalar, by_speed}});
}

const MapSpec<BallBall>& ball_ball_spec() {
    static const MapSpec<BallBall> spec = [] {
        MapSpec<BallBall> s("ball_ball", "Friction and restitution between two balls.");
        s.key("restitution", &BallBall::restitution, number(between(0, 1)),
              "coefficient of restitution along the line of centres");
        s.set(
            "friction", ball_friction(),
            [](BallBall& law, const BallBall& value) {
                law.friction = value.friction;
                law.friction_model = value.friction_model;
            },
            "coefficient of Coulomb friction, or `alciatore`: a coefficient that falls with the "
            "relative speed (Alciatore, TP A-14)",
            "alciatore");
        s.key("friction_factor", &BallBall::friction_factor, number(between(0, kLargestFriction)),
              "multiplies the friction, according to the state of the balls: 1 for used ones, more "
              "for dirty ones");
        return s;
    }();
    return spec;
}

/// Restitution of a slow ball, and how it falls with speed.
struct Restitution {
    double slow = BallCushion{}.restitution;
    sim::RestitutionFall fall = sim::usual_cushion(BallCushion{}.model).fall;
};

const MapSpec<Restitution>& restitution_spec() {
    static const MapSpec<Restitution> spec = [] {
        MapSpec<Restitution> s(
            "cushion_restitution",
            "A restitution that falls with the speed at which the ball approaches the cushion, "
            "perpendicular to it.");
        s.key("slow", &Restitution::slow, number(between(0, 1)),
              "coefficient of restitution of a slow ball")
            .required();
        s.key(
            "falls_above", [](Restitution& r) -> double& { return r.fall.above; },
            quantity(Dimension::speed, between(0, 100)), "speed up to which it is constant");
        s.key(
            "by", [](Restitution& r) -> double& { return r.fall.slope; }, number(between(0, 10)),
            "decrease for each m/s above that speed");
        s.key(
            "least", [](Restitution& r) -> double& { return r.fall.least; }, number(between(0, 1)),
            "it falls no further than this");
        return s;
    }();
    return spec;
}

/// One number, which holds at all speeds, or a restitution that falls with speed.
ValueType<Restitution> cushion_restitution() {
    const auto constant = convert<Restitution>(number(between(0, 1)), [](double value) {
        return Restitution{value, sim::RestitutionFall{}};
    });
    return any_of<Restitution>({{is_scalar, constant}, {is_map, record(restitution_spec())}});
}

/// The values have a different meaning in each model, so each model has its own, and those of a
/// ball set remain valid when a shot changes the model.
struct CushionNumbers {
    std::optional<Restitution> restitution;
    std::optional<double> friction;
};

struct CushionEntry {
    sim::CushionModel model = BallCushion{}.model;
    CushionNumbers chosen;  // has precedence over those below
    CushionNumbers mirror, han2005, mathavan2010;

    [[nodiscard]] BallCushion law() const;
};

BallCushion CushionEntry::law() const {
    const CushionNumbers& own = model == sim::CushionModel::mirror    ? mirror
                                : model == sim::CushionModel::han2005 ? han2005
                                                                      : mathavan2010;
    BallCushion law = sim::usual_cushion(model);
    for (const CushionNumbers* numbers : {&own, &chosen}) {
        if (numbers->restitution) {
            law.restitution = numbers->restitution->slow;
            law.fall = numbers->restitution->fall;
        }
        law.friction = numbers->friction.value_or(law.friction);
    }
    return law;
}

/// The restitution of a model as a user would type it.
std::string show_restitution(const BallCushion& law) {
    return law.fall == sim::RestitutionFall{}
               ? show(law.restitution)
               : fmt::format("{{slow: {}, falls_above: {}, by: {}, least: {}}}",
                             show(law.restitution), show(law.fall.above, Dimension::speed),
                             show(law.fall.slope), show(law.fall.least));
}

MapSpec<CushionNumbers> cushion_numbers_spec(const std::string& name, sim::CushionModel model) {
    const BallCushion usual = sim::usual_cushion(model);
    MapSpec<CushionNumbers> s(name, "The values that the cushion model `" + name + "` uses.");
    s.set(
        "restitution", cushion_restitution(),
        [](CushionNumbers& numbers, const Restitution& value) { numbers.restitution = value; },
        "one number for all speeds, or a map for a restitution that falls with speed",
        show_restitution(usual));
    s.set(
        "friction", number(between(0, kLargestFriction)),
        [](CushionNumbers& numbers, double value) { numbers.friction = value; },
        std::string("coefficient of friction between ball and cushion") +
            (model == sim::CushionModel::mirror ? "; this model has none and ignores it" : ""),
        show(usual.friction));
    return s;
}

const MapSpec<CushionNumbers>& mirror_spec() {
    static const MapSpec<CushionNumbers> spec =
        cushion_numbers_spec("mirror", sim::CushionModel::mirror);
    return spec;
}

const MapSpec<CushionNumbers>& han_spec() {
    static const MapSpec<CushionNumbers> spec =
        cushion_numbers_spec("han2005", sim::CushionModel::han2005);
    return spec;
}

const MapSpec<CushionNumbers>& mathavan_spec() {
    static const MapSpec<CushionNumbers> spec =
        cushion_numbers_spec("mathavan2010", sim::CushionModel::mathavan2010);
    return spec;
}

const MapSpec<CushionEntry>& ball_cushion_spec() {
    static const MapSpec<CushionEntry> spec = [] {
        MapSpec<CushionEntry> s("ball_cushion", "The impact of a ball on a cushion.");
        s.key("model", &CushionEntry::model,
              choice<sim::CushionModel>({{"mirror", sim::CushionModel::mirror},
                                         {"han2005", sim::CushionModel::han2005},
                                         {"mathavan2010", sim::CushionModel::mathavan2010}}),
              "the published model that gives the impulse. `mirror` is for tests: it reverses the "
              "velocity perpendicular to the cushion, times a restitution of " +
                  show(sim::usual_cushion(sim::CushionModel::mirror).restitution) +
                  " unless another is given, and leaves the rest");
        s.key(
            "restitution",
            [](CushionEntry& e) -> std::optional<Restitution>& { return e.chosen.restitution; },
            cushion_restitution(),
            "coefficient of restitution as the model defines it: one number for all speeds, or a "
            "map for one that falls with speed. The default is the value of the model's own "
            "section below");
        s.key(
            "friction", [](CushionEntry& e) -> std::optional<double>& { return e.chosen.friction; },
            number(between(0, kLargestFriction)),
            "coefficient of friction between ball and cushion. The default is the value of the "
            "model's own section below");
        s.map("mirror", &CushionEntry::mirror, mirror_spec(), "used with the model `mirror`");
        s.map("han2005", &CushionEntry::han2005, han_spec(), "used with the model `han2005`");
        s.map("mathavan2010", &CushionEntry::mathavan2010, mathavan_spec(),
              "used with the model `mathavan2010`");
        return s;
    }();
    return spec;
}

constexpr const char* kRollingFriction =
    "deceleration of a rolling body as a fraction of gravity; if it is not given, balls roll "
    "without resistance, and cylinders and capsules with 0.003";

void add_pair_keys(MapSpec<PairContact>& s) {
    s.key("restitution", &PairContact::restitution, number(between(0, 1)),
          "coefficient of restitution along the normal");
    s.key("friction", &PairContact::friction, number(between(0, kLargestFriction)),
          "coefficient of Coulomb friction");
    s.key("rolling_friction", &PairContact::rolling_friction, number(between(0, 1)),
          kRollingFriction);
}

const MapSpec<PairContact>& otherwise_spec() {
    static const MapSpec<PairContact> spec = [] {
        MapSpec<PairContact> s("otherwise",
                               "Contact of any two materials that no other entry names.");
        add_pair_keys(s);
        return s;
    }();
    return spec;
}

struct PairEntry {
    std::vector<std::string> between;
    PairContact contact;
};

const MapSpec<PairEntry>& pair_spec() {
    static const MapSpec<PairEntry> spec = [] {
        MapSpec<PairEntry> s("pair", "The contact law of two physical materials.");
        s.key("between", &PairEntry::between, list_of(text("a physical material"), 2, 2),
              "the two materials, in any order: `ball`, `cloth`, `cushion`, `rail`, `floor` or an "
              "object's own. Or the names of two balls, which then follow this law instead of "
              "`ball_ball` when they hit each other")
            .required();
        const auto add = [&s](const char* name, double PairContact::*field, Range range,
                              const char* description) {
            s.key(
                name, [field](PairEntry& e) -> double& { return e.contact.*field; }, number(range),
                description);
        };
        add("restitution", &PairContact::restitution, between(0, 1),
            "coefficient of restitution along the normal");
        add("friction", &PairContact::friction, between(0, kLargestFriction),
            "coefficient of Coulomb friction");
        s.key(
            "rolling_friction",
            [](PairEntry& e) -> std::optional<double>& { return e.contact.rolling_friction; },
            number(between(0, 1)), kRollingFriction);
        return s;
    }();
    return spec;
}

void set_pairs(World& world, const std::vector<PairEntry>& entries) {
    for (const PairEntry& entry : entries) {
        if (entry.between.size() == 2) {
            const auto [low, high] = std::minmax(entry.between[0], entry.between[1]);
            world.contact_law.pairs[{low, high}] = entry.contact;
        }
    }
}

ValueType<Vec3> gravity() {
    const auto downwards = convert<Vec3>(quantity(Dimension::acceleration, between(0, 1000)),
                                         [](double value) { return Vec3(0, 0, -value); });
    return any_of<Vec3>({{is_scalar, downwards},
                         {is_list, vector3(Dimension::acceleration, between(-1000, 1000))}});
}

/// Adds the keys whose values depend on the condition of the table, the balls and the stick.
void add_conditional_keys(MapSpec<World>& s) {
    s.map(
        "ball_cloth", [](World& w) -> BallCloth& { return w.contact_law.ball_cloth; },
        ball_cloth_spec(), "contact of a ball with the cloth");
    s.map(
        "ball_ball", [](World& w) -> BallBall& { return w.contact_law.ball_ball; },
        ball_ball_spec(), "contact of a ball with a ball");
    s.set(
         "ball_cushion", record(ball_cushion_spec()),
         [](World& w, const CushionEntry& e) { w.contact_law.ball_cushion = e.law(); },
         "contact of a ball with a cushion")
        .always_there();
    s.set(
         "stick", record(stick_spec()), [](World&, const sim::Strike&) {},
         "what the strikes use that do not give their own values")
        .always_there();
}

/// Adds the words for conditions. They have been replaced by numbers (conditions.h).
void add_words(MapSpec<World>& s) {
    for (const ConditionKey& key : condition_keys()) {
        s.set(
            key.name, word(key.words, "conditions." + key.name), [](World&, const std::string&) {},
            "condition of " + key.description +
                ": a word for the numbers that `conditions` has for it. Keys that a file gives "
                "beside it have precedence");
    }
}

const MapSpec<World>& condition_spec() {
    static const MapSpec<World> spec = [] {
        MapSpec<World> s("condition", "The numbers of a word, with the keys that `physics` has.");
        add_conditional_keys(s);
        return s;
    }();
    return spec;
}

}  // namespace

const MapSpec<sim::Strike>& stick_spec() {
    using sim::Strike;
    static const MapSpec<Strike> spec = [] {
        MapSpec<Strike> s("stick", "The stick of every strike that does not give its own values.");
        s.key("tip_restitution", &Strike::tip_restitution, number(between(0, 1)),
              "restitution of the tip");
        s.key("end_mass_ratio", &Strike::end_mass_ratio, number(above_up_to(0, 1)),
              "effective end mass of the stick divided by the mass of the ball, which determines "
              "the squirt");
        s.key("mass", &Strike::stick_mass, quantity(Dimension::mass, above_up_to(0, 10)),
              "mass of the whole stick");
        return s;
    }();
    return spec;
}

const MapSpec<NotStored>& conditions_spec() {
    static const MapSpec<NotStored> spec = [] {
        MapSpec<NotStored> s(
            "conditions",
            "The words for the condition of the table, the balls and the stick, and their numbers: "
            "below each word is a part of a `physics` section. configs/balls/ has the words of "
            "each kind of ball with their sources; a shot that uses a word without including one "
            "of its files gets the numbers for its kind of ball. A shot may add words of its own.");
        for (const ConditionKey& key : condition_keys()) {
            s.set(
                key.name, named("condition", condition_spec()),
                [](NotStored&, const std::vector<Named<World>>&) {},
                "the words for the condition of " + key.description);
        }
        return s;
    }();
    return spec;
}

const MapSpec<World>& physics_spec() {
    static const MapSpec<World> spec = [] {
        MapSpec<World> s("physics", "Gravity, and the contact laws of pairs of materials.");
        s.set(
            "gravity", gravity(), [](World& world, const Vec3& value) { world.gravity = value; },
            "one number (downwards) or a vector", show(9.81, Dimension::acceleration));
        add_words(s);
        add_conditional_keys(s);
        s.map(
            "otherwise", [](World& w) -> PairContact& { return w.contact_law.otherwise; },
            otherwise_spec(), "contact of any other two materials");
        s.set("pairs", numbered("pair", pair_spec()), set_pairs,
              "contact laws of further pairs of physical materials");
        s.key(
            "hop", [](World& w) -> bool& { return w.contact_law.hop; }, boolean(),
            "keeps the vertical part of impulses between balls and at cushions");
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
