#include "pipeline/solve/scan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
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

/// Whether the way round a ball is sought on which spin bends the ball's path (a massé).
bool seeks_curves(const StrikeTrials& trials) {
    return trials.problem().finds_elevation && !trials.has_flights_wanted();
}

/// Strikes from above beside the middle.
std::vector<Setting> curved_settings(const StrikeTrials& trials) {
    const Setting given = trials.given();
    const auto of = [](bool is_found, auto some, auto value) {
        return is_found ? some : decltype(some){value};
    };
    const std::vector<Vec2> tips =
        of(trials.problem().finds_tip,
           std::vector<Vec2>{{0.4, 0}, {-0.4, 0}, {0.3, -0.3}, {-0.3, -0.3}}, given.tip);
    const std::vector<double> speeds =
        of(trials.problem().finds_speed, std::vector<double>{2, 3, 4.5}, given.speed);
    std::vector<Setting> settings;
    for (const double degrees : {40.0, 55.0, 70.0}) {
        for (const Vec2& tip : tips) {
            for (const double speed : speeds) {
                settings.push_back({given.direction, speed, tip, degrees * kDegree});
            }
        }
    }
    return settings;
}

/// The speeds, and for flights the elevations, at which directions are scanned.
std::vector<Setting> scan_settings(const StrikeTrials& trials) {
    if (seeks_curves(trials)) {
        return curved_settings(trials);
    }
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

/// To both sides of the bearings of what the ball is to come to.
std::vector<double> curved_directions(const StrikeTrials& trials) {
    constexpr int kCount = 30;
    constexpr double kWidest = 45 * kDegree;
    std::set<double> bearings;
    const Vec2 from = trials.places().at(trials.ball());
    for (const Target& target : trials.targets()) {
        const Vec2 to =
            target.ball == trials.ball() ? target.point : trials.places().at(target.ball);
        bearings.insert(arctangent2(to.y - from.y, to.x - from.x));
    }
    std::vector<double> directions;
    for (const double bearing : bearings) {
        for (int i = 0; i < kCount; ++i) {
            directions.push_back(bearing + kWidest * (2 * (i + 0.5) / kCount - 1));
        }
    }
    std::ranges::sort(directions);
    return directions;
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
    if (seeks_curves(trials)) {
        return curved_directions(trials);
    }
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

std::vector<Bracket> brackets_of(const StrikeTrials& trials,
                                 const std::vector<std::optional<Sample>>& samples) {
    constexpr double kMaxMiss = 0.8;  // m
    std::vector<Bracket> brackets;
    const auto reaches = [](const Leg& leg, const Vec2& point) {
        const Vec2 d = point - leg.from;
        return leg.length > std::sqrt(d.dot(d)) - kMouth;
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& low = *samples[i];
        const Sample& high = *samples[(i + 1) % samples.size()];
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
                    brackets.push_back({{t, leg.cause}, low.direction, end, a, b});
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
    const Target& target = trials.targets()[at.pass.target];
    for (int i = 0; i < 10; ++i) {
        const double slope = (at.high_miss - at.low_miss) / (at.high - at.low);
        double next = at.low - at.low_miss / slope;
        if (!(next > at.low && next < at.high) || i % 4 == 3) {
            next = 0.5 * (at.low + at.high);
        }
        Setting tried = setting;
        tried.direction = next;
        Sample found = trials.sample(tried);
        if (found.is_met) {
            return Seed{tried, at.pass, slope, std::move(found.route)};
        }
        const Leg* leg = leg_with(found.legs[at.pass.target], at.pass.cause);
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

/// Of neighbours that all meet the wants, those that come nearest to places and measures; of equal
/// ones the middle.
std::vector<Seed> met_directly(const Scan& scan) {
    std::vector<Seed> seeds;
    const std::size_t count = scan.samples.size();
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t end = i;
        while (end < count && scan.samples[end]->is_met) {
            ++end;
        }
        if (end > i) {
            std::size_t best = (i + end) / 2;
            for (std::size_t k = i; k < end; ++k) {
                best = scan.samples[k]->distance < scan.samples[best]->distance ? k : best;
            }
            Setting met = scan.setting;
            met.direction = scan.directions[best];
            seeds.push_back({met, std::nullopt, 0, scan.samples[best]->route});
            i = end;
        }
    }
    return seeds;
}

/// Calls fill(i) for those of `values` that are empty.
template <class Value, class Fill>
void fill_empty(const StrikeTrials& trials, std::vector<std::optional<Value>>& values,
                const Fill& fill) {
    const PartsWork work{trials.work().threads, {{}, trials.work().context.stop}};
    do_parts(
        values.size(),
        [&](std::size_t i) {
            if (!values[i]) {
                values[i] = fill(i);
            }
        },
        work);
}

std::vector<Seed> seeds_of(const StrikeTrials& trials, Scan& scan) {
    fill_empty(trials, scan.samples, [&](std::size_t i) {
        Setting each = scan.setting;
        each.direction = scan.directions[i];
        return trials.sample(each);
    });
    if (scan.brackets.empty()) {
        scan.brackets = brackets_of(trials, scan.samples);
        scan.followed.resize(scan.brackets.size());
    }
    fill_empty(trials, scan.followed,
               [&](std::size_t i) { return follow(trials, scan.setting, scan.brackets[i]); });
    std::vector<Seed> seeds;
    for (const auto& seed : scan.followed) {
        if (*seed) {
            seeds.push_back(**seed);
        }
    }
    std::ranges::copy(met_directly(scan), std::back_inserter(seeds));
    return seeds;
}

}  // namespace

std::vector<Scan> make_scans(const StrikeTrials& trials) {
    std::vector<Scan> scans;
    for (const Setting& setting : scan_settings(trials)) {
        Scan scan{setting, {setting.direction}, {}, {}, {}};
        if (trials.problem().finds_direction) {
            scan.directions = scan_directions(trials);
        }
        scan.samples.resize(scan.directions.size());
        scans.push_back(std::move(scan));
    }
    return scans;
}

std::vector<std::vector<Seed>> scan_routes(const StrikeTrials& trials, std::vector<Scan>& scans) {
    constexpr std::size_t kMaxSeeds = 6;
    std::map<std::string, std::vector<Seed>> routes;
    for (Scan& scan : scans) {
        for (const Seed& seed : seeds_of(trials, scan)) {
            std::vector<Seed>& known = routes[seed.route.text()];
            if (known.size() < kMaxSeeds) {
                known.push_back(seed);
            }
        }
    }
    std::vector<std::vector<Seed>> sorted;
    sorted.reserve(routes.size());
    for (auto& [text, seeds] : routes) {
        sorted.push_back(std::move(seeds));
    }
    std::ranges::stable_sort(sorted, [](const auto& a, const auto& b) {
        return std::pair(a.front().route.steps.size(), b.size()) <
               std::pair(b.front().route.steps.size(), a.size());
    });
    return sorted;
}

}  // namespace carom::pipeline::solve
