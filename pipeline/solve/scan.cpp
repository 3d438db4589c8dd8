#include "pipeline/solve/scan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "core/elementary.h"
#include "pipeline/solve/route.h"
#include "pipeline/variants/variants.h"

namespace carom::pipeline::solve {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kDegree = std::numbers::pi / 180;
/// Directions of a scan all around.
constexpr int kAround = 240;
/// Directions at which a ball is met directly, and off cushions.
constexpr int kDirect = 16;
constexpr int kByCushion = 9;
/// And at which the ball flies over another one.
constexpr int kOver = 32;
/// A leg may end this far (m) before the point that it was to reach: in a pocket's jaws.
constexpr double kMouth = 0.16;

/// Two directions between which a ball passes a target on the other side.
struct Bracket {
    std::size_t target;
    std::uint64_t cause;
    double low, high;
    double low_miss, high_miss;
};

/// The speeds, and for flights the elevations, at which directions are scanned.
std::vector<Setting> scan_settings(const StrikeTrials& trials) {
    const Setting given = trials.given();
    std::vector<double> speeds{given.speed};
    if (trials.problem().finds_speed) {
        speeds = trials.has_flights_wanted() ? std::vector<double>{2, 2.6, 3.4, 4.4, 5.8}
                                             : std::vector<double>{1.6, 2.8, 5.5};
    }
    std::vector<double> elevations{given.elevation};
    if (trials.problem().finds_elevation) {
        elevations = {25 * kDegree, 35 * kDegree, 45 * kDegree, 55 * kDegree};
    }
    std::vector<Setting> settings;
    for (const double elevation : elevations) {
        for (const double speed : speeds) {
            Setting each = given;
            each.speed = speed;
            each.elevation = elevation;
            if (trials.problem().finds_tip) {
                each.tip = Vec2(0, 0);
            }
            settings.push_back(each);
        }
    }
    return settings;
}

void add_interval(const StrikeTrials& trials, const Vec2& place, double reach, int count,
                  std::vector<double>& directions) {
    const Vec2 d = place - trials.places().at(trials.ball());
    const double distance = std::sqrt(d.dot(d));
    if (distance <= reach) {
        return;
    }
    const double bearing = arctangent2(d.y, d.x);
    const double half = arcsine(reach / distance);
    for (int i = 0; i < count; ++i) {
        directions.push_back(bearing + half * (2 * (i + 0.5) / count - 1));
    }
}

/// All around, and more closely where the ball would meet another one, directly or off cushions
/// that were mirrors.
std::vector<double> scan_directions(const StrikeTrials& trials) {
    std::vector<double> directions;
    const double radius = trials.radius();
    for (const Want& want : trials.problem().wants) {
        const auto* clearing = std::get_if<Clearing>(&want);
        if (clearing != nullptr && trials.places().contains(clearing->blocker)) {
            add_interval(trials, trials.places().at(clearing->blocker), 1.5 * radius, kOver,
                         directions);
        }
    }
    if (!directions.empty()) {
        return directions;
    }
    for (int i = 0; i < kAround; ++i) {
        directions.push_back(kTurn * (i + 0.5) / kAround);
    }
    const auto& table = trials.world().table;
    const bool has_cushions = table && table->has_cushions;
    const Vec2 half =
        has_cushions ? Vec2(0.5 * table->length - radius, 0.5 * table->width - radius) : Vec2(0, 0);
    const auto mirrored = [](double x, int times, double at) {
        return times % 2 == 0 ? x + 2 * times * at : -x + 2 * times * at;
    };
    int wanted_cushions = 2;
    for (const Want& want : trials.problem().wants) {
        const auto* happening = std::get_if<Happening>(&want);
        if (happening != nullptr && happening->trigger.b == "cushion" && !happening->is_avoided()) {
            wanted_cushions = std::clamp(happening->at_least, wanted_cushions, 4);
        }
    }
    for (const auto& [name, place] : trials.places()) {
        if (name == trials.ball()) {
            continue;
        }
        const double reach = radius + trials.radius_of(name);
        add_interval(trials, place, reach, kDirect, directions);
        const bool is_target =
            std::ranges::any_of(trials.targets(), [&, &known = name](const Target& t) {
                return t.ball == known || (!t.is_pocket && t.point == trials.places().at(known));
            });
        if (!has_cushions || !is_target) {
            continue;
        }
        for (int i = -wanted_cushions; i <= wanted_cushions; ++i) {
            for (int k = -wanted_cushions; k <= wanted_cushions; ++k) {
                const int count = std::abs(i) + std::abs(k);
                if (count > 0 && count <= wanted_cushions) {
                    add_interval(trials,
                                 {mirrored(place.x, i, half.x), mirrored(place.y, k, half.y)},
                                 reach * (1 + 0.5 * count), kByCushion, directions);
                }
            }
        }
    }
    for (double& direction : directions) {
        direction -= kTurn * std::floor(direction / kTurn);
    }
    std::ranges::sort(directions);
    return directions;
}

std::vector<Bracket> brackets_of(const StrikeTrials& trials, const std::vector<Sample>& samples) {
    constexpr double kMaxMiss = 0.8;  // m
    std::vector<Bracket> brackets;
    const auto reaches = [](const Leg& leg, const Vec2& point) {
        const Vec2 d = point - leg.from;
        return leg.length > std::sqrt(d.dot(d)) - kMouth;
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& low = samples[i];
        const Sample& high = samples[(i + 1) % samples.size()];
        for (std::size_t t = 0; t < trials.targets().size(); ++t) {
            for (const Leg& leg : low.legs[t]) {
                const Leg* other = leg_with(high.legs[t], leg.cause);
                if (other == nullptr) {
                    continue;
                }
                const Vec2& point = trials.targets()[t].point;
                const double a = leg.miss(point);
                const double b = other->miss(point);
                if (a * b <= 0 && std::abs(a) + std::abs(b) < kMaxMiss &&
                    (reaches(leg, point) || reaches(*other, point))) {
                    const double end = high.direction + (i + 1 == samples.size() ? kTurn : 0);
                    brackets.push_back({t, leg.cause, low.direction, end, a, b});
                }
            }
        }
    }
    return brackets;
}

/// The direction in the bracket in which the wants are met, by the secant method kept inside it.
std::optional<Seed> follow(const StrikeTrials& trials, const Setting& setting,
                           const Bracket& bracket) {
    Bracket at = bracket;
    const Target& target = trials.targets()[at.target];
    for (int i = 0; i < 10; ++i) {
        const double slope = (at.high_miss - at.low_miss) / (at.high - at.low);
        double next = at.low - at.low_miss / slope;
        if (!(next > at.low && next < at.high) || i % 4 == 3) {
            next = 0.5 * (at.low + at.high);
        }
        Setting tried = setting;
        tried.direction = next;
        const Sample found = trials.sample(tried);
        if (found.is_met) {
            return Seed{tried, at.target, at.cause, slope};
        }
        const Leg* leg = leg_with(found.legs[at.target], at.cause);
        if (leg == nullptr) {
            return std::nullopt;
        }
        const double passed = leg->miss(target.point);
        if (!std::isfinite(passed) || at.high - at.low < 1e-7) {
            return std::nullopt;
        }
        const bool is_low = (passed < 0) == (at.low_miss < 0);
        (is_low ? at.low : at.high) = next;
        (is_low ? at.low_miss : at.high_miss) = passed;
    }
    return std::nullopt;
}

/// Of neighbours that all meet the wants, the middle ones.
std::vector<Seed> met_directly(const Setting& setting, const std::vector<Sample>& samples) {
    std::vector<Seed> seeds;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::size_t end = i;
        while (end < samples.size() && samples[end].is_met) {
            ++end;
        }
        if (end > i) {
            Setting met = setting;
            met.direction = samples[(i + end) / 2].direction;
            seeds.push_back({met, 0, 0, 0});
            i = end;
        }
    }
    return seeds;
}

std::vector<Seed> scan(const StrikeTrials& trials, const Setting& setting) {
    const PartsWork work{trials.work().threads, {{}, trials.work().context.stop}};
    const std::vector<double> directions =
        trials.problem().finds_direction ? scan_directions(trials) : std::vector{setting.direction};
    std::vector<Sample> samples(directions.size());
    do_parts(
        directions.size(),
        [&](std::size_t i) {
            Setting each = setting;
            each.direction = directions[i];
            samples[i] = trials.sample(each);
        },
        work);
    const std::vector<Bracket> brackets = brackets_of(trials, samples);
    std::vector<std::optional<Seed>> followed(brackets.size());
    do_parts(
        brackets.size(), [&](std::size_t i) { followed[i] = follow(trials, setting, brackets[i]); },
        work);
    std::vector<Seed> seeds;
    for (const std::optional<Seed>& seed : followed) {
        if (seed) {
            seeds.push_back(*seed);
        }
    }
    for (const Seed& seed : met_directly(setting, samples)) {
        seeds.push_back(seed);
    }
    return seeds;
}

}  // namespace

std::vector<std::vector<Seed>> scan_routes(const StrikeTrials& trials) {
    constexpr std::size_t kMaxSeeds = 6;
    struct Found {
        std::vector<Seed> seeds;
        std::size_t steps = 0;
    };
    std::map<std::string, Found> routes;
    for (const Setting& setting : scan_settings(trials)) {
        for (const Seed& seed : scan(trials, setting)) {
            const sim::Outcome outcome = trials.play(seed.setting, StrikeTrials::Depth::scan);
            if (!trials.is_met(outcome)) {
                continue;
            }
            const Route route = route_of(trials.problem().wants, trials.trial_of(outcome));
            Found& found = routes[route.text()];
            found.steps = route.steps.size();
            if (found.seeds.size() < kMaxSeeds) {
                found.seeds.push_back(seed);
            }
        }
    }
    std::vector<Found> sorted;
    sorted.reserve(routes.size());
    for (auto& [text, found] : routes) {
        sorted.push_back(std::move(found));
    }
    std::ranges::stable_sort(sorted, [](const Found& a, const Found& b) {
        return std::pair(a.steps, b.seeds.size()) < std::pair(b.steps, a.seeds.size());
    });
    std::vector<std::vector<Seed>> result;
    result.reserve(sorted.size());
    for (Found& found : sorted) {
        result.push_back(std::move(found.seeds));
    }
    return result;
}

}  // namespace carom::pipeline::solve
