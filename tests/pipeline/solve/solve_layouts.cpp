#include "tests/pipeline/solve/solve_layouts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "sim/billiards/table.h"

namespace carom::pipeline::solve {
namespace {

using sim::billiards::TableKind;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRadius = 0.028575;
constexpr double kHalfLength = 1.27;
constexpr double kHalfWidth = 0.635;

Vec2 unit(const Vec2& v) {
    return v / std::sqrt(v.dot(v));
}
Vec2 turned(const Vec2& v, double angle) {
    return {v.x * std::cos(angle) - v.y * std::sin(angle),
            v.x * std::sin(angle) + v.y * std::cos(angle)};
}

sim::Body ball(const std::string& name, const Vec2& at) {
    sim::Body body;
    body.name = name;
    body.shape = sim::Sphere{kRadius};
    body.pose.position = Vec3(at.x, at.y, kRadius);
    return body;
}

Layout layout(std::string name, const Vec2& cue, const Vec2& one,
              TableKind kind = TableKind::pool) {
    Layout result;
    result.name = std::move(name);
    result.world.duration = 20;
    result.world.table =
        *sim::billiards::standard_table(kind, kind == TableKind::pool ? "9 ft" : "10 ft");
    result.world.bodies = {ball("cue", cue), ball("one", one)};
    sim::Strike strike;
    strike.speed = 2;
    strike.direction = 0;
    result.world.events = {{"cue", 0, {}, 0, strike}};
    result.problem.player = player_error("club").value();
    return result;
}

Happening potted(const std::string& name, const std::string& pocket = "") {
    Happening want;
    want.trigger.kind = sim::Trigger::Kind::potted;
    want.trigger.a = name;
    want.pocket = pocket;
    return want;
}
Happening contact(const std::string& a, const std::string& b) {
    Happening want;
    want.trigger.kind = sim::Trigger::Kind::contact;
    want.trigger.a = a;
    want.trigger.b = b;
    return want;
}
Happening avoided(Happening want) {
    want.at_least = 0;
    want.at_most = 0;
    return want;
}

struct NamedPocket {
    std::string name;
    Vec2 centre;
};
const std::vector<NamedPocket>& pockets() {
    static const std::vector<NamedPocket> list = [] {
        std::vector<NamedPocket> named;
        const auto table = sim::billiards::build_table(
            *sim::billiards::standard_table(TableKind::pool, "9 ft"), kRadius);
        for (const auto& pocket : table.pockets) {
            named.push_back({pocket.name, pocket.centre});
        }
        return named;
    }();
    return list;
}

bool is_on_table(const Vec2& p) {
    return std::abs(p.x) < kHalfLength - 1.5 * kRadius &&
           std::abs(p.y) < kHalfWidth - 1.5 * kRadius;
}

/// The cue ball `far` (m) behind the ghost ball of a cut by that angle, to the side on which it
/// has room; the object ball `near` from the pocket, in the direction of its mouth.
std::optional<Layout> cut(const NamedPocket& pocket, double angle, double near, double far) {
    const bool is_side = std::abs(pocket.centre.x) < 0.1;
    const double sign_x = pocket.centre.x > 0 ? 1 : -1;
    const double sign_y = pocket.centre.y > 0 ? 1 : -1;
    const Vec2 out = is_side ? Vec2(0, sign_y) : unit({sign_x, sign_y});
    const Vec2 one = pocket.centre - out * near;
    const Vec2 ghost = one - out * (2 * kRadius);
    for (const double side : {1.0, -1.0}) {
        const Vec2 cue = ghost - turned(out, side * angle) * far;
        if (is_on_table(cue)) {
            Layout result = layout(fmt::format("{} {:.0f}, {}", angle < 0.01 ? "straight" : "cut",
                                               angle / kDegree, pocket.name),
                                   cue, one);
            result.problem.wants = {potted("one", pocket.name), avoided(potted("cue"))};
            result.route = "cue - one, one in " + pocket.name;
            return result;
        }
    }
    return std::nullopt;
}

void add_pots(std::vector<Layout>& all) {
    const auto add = [&](const std::optional<Layout>& one) {
        if (one) {
            all.push_back(*one);
        }
    };
    for (const NamedPocket& pocket : pockets()) {
        add(cut(pocket, 0, 0.35, 0.5));
    }
    for (std::size_t i = 0; i < 4; ++i) {
        add(cut(pockets()[i], 0, 0.6, 0.35));
    }
    for (int degrees = 5; degrees <= 75; degrees += 5) {
        const auto first = static_cast<std::size_t>(degrees / 5) % pockets().size();
        for (const std::size_t which : {first, first + 3}) {
            add(cut(pockets()[which % pockets().size()], degrees * kDegree, 0.4,
                    degrees > 60 ? 0.25 : 0.45));
        }
    }
}

/// Happens to `name` at least so often before the end.
Happening cushions(const std::string& name, int count, const Happening& before) {
    Happening want = contact(name, "cushion");
    want.at_least = count;
    want.skips_jaws = true;
    want.before = before.trigger;
    return want;
}

void add_banks(std::vector<Layout>& all) {
    struct Bank {
        Vec2 cue, one;
        std::string pocket;
        int count;
    };
    const std::vector<Bank> banks{
        {{-0.4, -0.2}, {0.1, 0.2}, "corner_right_front", 1},
        {{-0.2, 0.3}, {0.3, -0.1}, "corner_right_back", 1},
        {{0.5, 0.1}, {0.1, -0.25}, "corner_left_back", 1},
        {{0.2, -0.3}, {-0.2, 0.1}, "side_front", 1},
        {{-0.8, 0.1}, {-0.5, -0.2}, "side_back", 1},
        {{0.9, -0.2}, {0.6, 0.1}, "corner_left_front", 1},
        {{-0.3, 0}, {0.2, 0.1}, "corner_left_front", 2},
        {{0.3, 0.2}, {-0.1, 0}, "corner_right_front", 2},
        {{-0.6, -0.1}, {-0.2, 0.1}, "corner_left_back", 2},
        {{0.1, -0.2}, {0.4, 0}, "corner_left_back", 2},
    };
    for (const Bank& bank : banks) {
        Layout one =
            layout(fmt::format("bank off {}, {}", bank.count, bank.pocket), bank.cue, bank.one);
        one.problem.wants = {potted("one", bank.pocket), cushions("one", bank.count, potted("one")),
                             avoided(potted("cue"))};
        all.push_back(one);
    }
}

void add_kicks(std::vector<Layout>& all) {
    struct Kick {
        Vec2 cue, one;
    };
    const std::vector<Kick> kicks{{{-0.6, 0.1}, {0.6, 0.1}},   {{-0.8, -0.3}, {0.5, 0.3}},
                                  {{0, -0.4}, {0.1, 0.4}},     {{-0.3, 0.2}, {0.9, -0.2}},
                                  {{0.7, 0.35}, {-0.7, 0.35}}, {{-1, 0}, {1, 0}}};
    for (std::size_t i = 0; i < kicks.size(); ++i) {
        const Kick& kick = kicks[i];
        Layout one = layout(fmt::format("kick {}", i + 1), kick.cue, kick.one);
        one.world.bodies.push_back(ball("eight", (kick.cue + kick.one) * 0.5));
        Happening hit = contact("cue", "one");
        Happening avoid = avoided(contact("cue", "eight"));
        avoid.before = hit.trigger;
        one.problem.wants = {hit, avoid, avoided(potted("cue"))};
        one.route = "cushion, cue - one";
        all.push_back(one);
    }
}

void add_combinations(std::vector<Layout>& all) {
    // The second ball near the pocket, the first one in its line, turned by some degrees.
    struct Combination {
        std::size_t pocket;
        double turn, off;
    };
    for (const Combination& each : {Combination{0, 0, 8}, Combination{2, 10, 0},
                                    Combination{4, -8, 10}, Combination{5, 6, -12}}) {
        const NamedPocket& pocket = pockets()[each.pocket];
        const bool is_side = std::abs(pocket.centre.x) < 0.1;
        const Vec2 out =
            is_side ? Vec2(0, pocket.centre.y > 0 ? 1 : -1)
                    : unit({pocket.centre.x > 0 ? 1.0 : -1.0, pocket.centre.y > 0 ? 1.0 : -1.0});
        const Vec2 two = pocket.centre - out * 0.25;
        const Vec2 into = turned(out, each.turn * kDegree);
        const Vec2 one = two - out * (2 * kRadius) - into * 0.12;
        const Vec2 cue = one - turned(into, each.off * kDegree) * 0.4;
        Layout result = layout("combination, " + pocket.name, cue, one);
        result.world.bodies.push_back(ball("two", two));
        result.problem.wants = {potted("two", pocket.name), contact("cue", "one"),
                                contact("one", "two"), avoided(potted("cue")),
                                avoided(contact("cue", "two"))};
        result.route = "cue - one, one - two, two in " + pocket.name;
        all.push_back(result);
    }
}

void add_caroms(std::vector<Layout>& all) {
    struct Carom {
        Vec2 cue, one, two;
    };
    for (const Carom& each :
         {Carom{{-0.8, 0}, {0.2, 0.05}, {0.9, 0.4}}, Carom{{-0.5, -0.3}, {0.1, 0}, {0.3, 0.45}},
          Carom{{0.9, 0.3}, {0.2, 0.1}, {-0.6, -0.3}}, Carom{{0, -0.4}, {-0.3, 0.2}, {0.5, 0.3}}}) {
        Layout result = layout("carom", each.cue, each.one, TableKind::carom);
        result.world.bodies.push_back(ball("two", each.two));
        result.problem.wants = {contact("cue", "one"), contact("cue", "two")};
        all.push_back(result);
    }
    for (const Carom& each :
         {Carom{{-0.8, -0.3}, {0.3, 0.1}, {1.0, 0.4}}, Carom{{0.2, -0.4}, {-0.6, 0.2}, {0.9, -0.1}},
          Carom{{0.9, 0.45}, {0.7, -0.2}, {-0.9, 0.3}}}) {
        Layout result = layout("three cushions", each.cue, each.one, TableKind::carom);
        result.world.bodies.push_back(ball("two", each.two));
        const Happening last = contact("cue", "two");
        result.problem.wants = {contact("cue", "one"), cushions("cue", 3, last), last};
        result.problem.wants[0] = [&] {
            Happening first = contact("cue", "one");
            first.before = last.trigger;
            return first;
        }();
        all.push_back(result);
    }
}

void add_jumps(std::vector<Layout>& all) {
    for (const double distance : {0.5, 0.6, 0.7}) {
        const NamedPocket& pocket = pockets()[2];
        const Vec2 out = unit({pocket.centre.x > 0 ? 1.0 : -1.0, pocket.centre.y > 0 ? 1.0 : -1.0});
        const Vec2 one = pocket.centre - out * 0.2;
        const Vec2 cue = one - out * (distance + 0.3);
        Layout result = layout(fmt::format("jump, {} m", distance), cue, one);
        result.world.bodies.push_back(ball("eight", cue + out * 0.3));
        result.problem.wants = {Clearing{"cue", "eight"}, potted("one", pocket.name),
                                avoided(contact("cue", "eight"))};
        result.problem.finds_elevation = true;
        all.push_back(result);
    }
}

/// Past a ball in the way without a cushion: by a curve or a jump.
void add_curves(std::vector<Layout>& all) {
    for (const auto& [eight, one] :
         {std::pair(Vec2(-0.2, 0), Vec2(0.1, 0)), std::pair(Vec2(-0.15, 0.02), Vec2(0.3, 0.1))}) {
        Layout result = layout("round or over a ball", {-0.5, 0}, one);
        result.world.bodies.push_back(ball("eight", eight));
        Happening cushions = contact("cue", "cushion");
        cushions.at_least = cushions.at_most = 0;
        cushions.before = contact("cue", "one").trigger;
        result.problem.wants = {contact("cue", "one"), cushions, avoided(contact("cue", "eight"))};
        result.problem.may_raise = true;
        all.push_back(result);
    }
}

void add_positions(std::vector<Layout>& all) {
    const Vec2 one(0.5, 0.3);
    const NamedPocket& pocket =
        *std::ranges::find(pockets(), "corner_right_back", &NamedPocket::name);
    const Vec2 out = unit(pocket.centre - one);
    const Vec2 cue = one - out * 0.45;
    const Vec2 ghost = one - out * (2 * kRadius);
    struct Position {
        std::string name;
        Vec2 place;
        double within;
    };
    for (const Position& each :
         {Position{"stop", ghost, 0.06}, Position{"follow", ghost + out * 0.3, 0.12},
          Position{"draw", ghost - out * 0.35, 0.12}}) {
        Layout result = layout(each.name + " to a place", cue, one);
        result.problem.wants = {potted("one", pocket.name), avoided(potted("cue")),
                                RestPlace{"cue", each.place, each.within}};
        all.push_back(result);
    }
}

void add_cuts_with_position(std::vector<Layout>& all) {
    struct Position {
        std::size_t pocket;
        double degrees;
        Vec2 place;
    };
    for (const Position& each : {Position{0, 25, {0.1, 0}}, Position{2, 40, {-0.3, 0.2}},
                                 Position{3, 30, {0.2, -0.3}}, Position{5, 20, {-0.4, 0}}}) {
        std::optional<Layout> result =
            cut(pockets()[each.pocket], each.degrees * kDegree, 0.4, 0.45);
        result->name += " and a place";
        result->route.clear();
        result->problem.wants.emplace_back(RestPlace{"cue", each.place, 0.2});
        all.push_back(*result);
    }
}

void add_safeties(std::vector<Layout>& all) {
    for (const auto& [cue, one, to] :
         {std::array{Vec2(-0.5, 0), Vec2(0.6, 0.2), Vec2(-1.1, -0.1)},
          std::array{Vec2(0.3, -0.3), Vec2(-0.4, 0.3), Vec2(1.0, 0.3)}}) {
        Layout result = layout("safety", cue, one);
        Happening after = contact("one", "cushion");
        result.problem.wants = {contact("cue", "one"), after, avoided(potted("cue")),
                                avoided(potted("one")), RestPlace{"cue", to, 0.3}};
        all.push_back(result);
    }
}

}  // namespace

std::vector<Layout> make_layouts() {
    std::vector<Layout> all;
    add_pots(all);
    add_banks(all);
    add_kicks(all);
    add_combinations(all);
    add_caroms(all);
    add_jumps(all);
    add_curves(all);
    add_positions(all);
    add_cuts_with_position(all);
    add_safeties(all);
    return all;
}

}  // namespace carom::pipeline::solve
