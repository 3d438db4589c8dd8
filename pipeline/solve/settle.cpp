#include "pipeline/solve/settle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <ImathMatrix.h>

#include "core/elementary.h"
#include "pipeline/solve/route.h"
#include "sim/stick/strike.h"

namespace carom::pipeline::solve {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// What a setting is worth, whose aim meets the wants but places at rest.
struct Candidate {
    Setting setting;
    double miss = std::numeric_limits<double>::infinity();      // StrikeTrials::miss()
    double distance = std::numeric_limits<double>::infinity();  // StrikeTrials::distance()
    double cost = std::numeric_limits<double>::infinity();
    std::vector<double> offsets{};  // StrikeTrials::offsets()

    /// Nothing is to be gained by moving on.
    [[nodiscard]] bool is_good() const { return miss == 0 && distance < 0.5; }
};

double length(const Vec2& v) {
    return std::sqrt(v.dot(v));
}

/// The setting with the direction in which the happenings are as wanted, found from where the seed
/// or a neighbour met them, and what comes of it. The seed has a pass.
std::optional<Played> aim(const StrikeTrials& trials, const Seed& seed, const Setting& setting) {
    constexpr int kMaxTries = 7;
    Setting tried = setting;
    double slope = seed.slope;
    double last_direction = 0;
    double last_miss = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < kMaxTries; ++i) {
        sim::Outcome outcome = trials.play(tried, StrikeTrials::Depth::chance, &*seed.pass);
        const Sample found = trials.sample_of(tried, outcome);
        if (found.is_met) {
            return Played{tried, std::move(outcome)};
        }
        const Leg* leg = leg_with(found.legs[seed.pass->target], seed.pass->cause);
        const double passed = leg != nullptr ? leg->miss(trials.targets()[seed.pass->target].point)
                                             : std::numeric_limits<double>::quiet_NaN();
        if (!std::isfinite(passed)) {
            return std::nullopt;
        }
        if (std::isfinite(last_miss) && tried.direction != last_direction && passed != last_miss) {
            slope = (passed - last_miss) / (tried.direction - last_direction);
        }
        last_direction = tried.direction;
        last_miss = passed;
        tried.direction -= std::clamp(passed / slope, -3 * kDegree, 3 * kDegree);
    }
    return std::nullopt;
}

/// How well a setting with that chance agrees with the preferences, the first of which counts most.
double liking(const StrikeTrials& trials, const Setting& setting, double chance) {
    constexpr double kFastest = 8;  // m/s
    double sum = 1e-3 * chance;
    double weight = 1;
    for (const Preference preference : trials.problem().prefer) {
        const double value = preference == Preference::likely ? chance
                             : preference == Preference::slow
                                 ? 1 - setting.speed / kFastest
                                 : 1 - length(setting.tip) / sim::kMiscueOffset;
        sum += weight * value;
        weight *= 0.5;
    }
    return sum;
}

Candidate rated(const StrikeTrials& trials, const Played& played) {
    const double missed = trials.miss(played.outcome);
    const double distance = trials.distance(played.outcome);
    return {played.setting, missed, distance,
            missed + 0.02 * distance - 1e-3 * liking(trials, played.setting, 0),
            trials.offsets(played.outcome)};
}

/// What comes of a setting, aimed where an aim leads.
std::optional<Played> play(const StrikeTrials& trials, const Seed& seed, const Setting& setting) {
    if (trials.problem().finds_direction && seed.pass) {
        return aim(trials, seed, setting);
    }
    return Played{setting, trials.play(setting, StrikeTrials::Depth::whole)};
}

std::vector<Setting> grid_around(const StrikeTrials& trials, const Seed& seed, bool is_fine) {
    static const std::vector kFineSpeeds{0.6, 0.8, 1.05, 1.4, 1.8, 2.3, 3.0, 3.9, 5.0, 6.5};
    static const std::vector<Vec2> kFineTips{{0, 0},      {0, 0.25},   {0, -0.25},  {0, 0.45},
                                             {0, -0.45},  {0.3, 0},    {-0.3, 0},   {0.3, 0.3},
                                             {-0.3, 0.3}, {0.3, -0.3}, {-0.3, -0.3}};
    static const std::vector kSpeeds{0.8, 1.3, 2.1, 3.4, 5.5};
    static const std::vector<Vec2> kTips{{0, 0}, {0, 0.4}, {0, -0.4}, {0.35, 0}, {-0.35, 0}};
    std::vector<double> speeds{seed.setting.speed};
    if (trials.problem().finds_speed) {
        speeds = is_fine ? kFineSpeeds : kSpeeds;
    }
    std::vector<Vec2> tips{seed.setting.tip};
    if (trials.problem().finds_tip) {
        tips = is_fine ? kFineTips : kTips;
    }
    std::vector<Setting> grid;
    for (const Vec2& tip : tips) {
        for (const double speed : speeds) {
            Setting each = seed.setting;
            each.speed = speed;
            each.tip = tip;
            grid.push_back(each);
        }
    }
    return grid;
}

/// A setting's values apart from its direction, in steps of a search: the logarithm of its speed
/// and both coordinates of the tip.
using Values = Vec3;

/// The setting with other values, in the direction in which squirt lets the ball go the same way;
/// empty if the tip would slip off.
std::optional<Setting> moved(const StrikeTrials& trials, const Setting& from, const Values& by) {
    Setting to = from;
    if (trials.problem().finds_speed) {
        to.speed *= exponential(by.x);
    }
    if (trials.problem().finds_tip) {
        to.tip += Vec2(by.y, by.z);
        if (length(to.tip) > sim::kMiscueOffset) {
            return std::nullopt;
        }
        const double radius = trials.radius();
        to.direction +=
            squirt_of(trials.strike(), from, radius) - squirt_of(trials.strike(), to, radius);
    }
    return to;
}

Candidate tried(const StrikeTrials& trials, const Seed& seed, const std::optional<Setting>& at) {
    const std::optional<Played> played = at ? play(trials, seed, *at) : std::nullopt;
    return played ? rated(trials, *played) : Candidate{};
}

bool is_same(const Setting& a, const Setting& b) {
    return a.direction == b.direction && a.speed == b.speed && a.tip == b.tip;
}

/// How the offsets of balls at rest change with the values: one row for each offset.
class Slopes {
  public:
    Slopes(const StrikeTrials& trials, const Seed& seed, const Candidate& at)
        : rows_(at.offsets.size(), Values(0, 0, 0)) {
        constexpr double kStep = 0.05;
        for (int axis = 0; axis < 3; ++axis) {
            Values by(0, 0, 0);
            by[axis] = axis > 0 && at.setting.tip[axis - 1] > 0 ? -kStep : kStep;
            const std::optional<Setting> next = moved(trials, at.setting, by);
            if (!next || is_same(*next, at.setting)) {
                continue;
            }
            const Candidate other = tried(trials, seed, next);
            if (other.offsets.size() == rows_.size()) {
                set(axis, at, other, by[axis]);
            }
        }
    }

    /// The step that brings the offsets to 0, of those the smallest; the more `damping`, the
    /// smaller (Levenberg 1944).
    [[nodiscard]] Values step(const std::vector<double>& offsets, double damping) const {
        Imath::M33d normal(damping, 0, 0, 0, damping, 0, 0, 0, damping);
        Values right(0, 0, 0);
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            for (int a = 0; a < 3; ++a) {
                right[a] -= rows_[i][a] * offsets[i];
                for (int b = 0; b < 3; ++b) {
                    normal[a][b] += rows_[i][a] * rows_[i][b];
                }
            }
        }
        return right * normal.inverse();
    }

    /// Learns from a step that was taken (Broyden, A class of methods for solving nonlinear
    /// simultaneous equations, 1965).
    void learn(const Values& step, const Candidate& from, const Candidate& to) {
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            const double missed = to.offsets[i] - from.offsets[i] - rows_[i].dot(step);
            rows_[i] += step * (missed / step.dot(step));
        }
    }

  private:
    void set(int axis, const Candidate& at, const Candidate& other, double by) {
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            rows_[i][axis] = (other.offsets[i] - at.offsets[i]) / by;
        }
    }

    std::vector<Values> rows_;
};

/// Brings balls at rest to their places by Newton's steps with slopes from differences.
Candidate approach(const StrikeTrials& trials, const Seed& seed, Candidate best) {
    constexpr int kSteps = 6;
    constexpr double kLongest = 0.3;
    if (best.offsets.empty() || best.is_good()) {
        return best;
    }
    Slopes slopes(trials, seed, best);
    double damping = 1e-3;
    for (int i = 0; i < kSteps && !best.is_good(); ++i) {
        Values step = slopes.step(best.offsets, damping);
        const double size = std::sqrt(step.dot(step));
        if (!(size > 1e-6)) {
            break;
        }
        step *= std::min(1.0, kLongest / size);
        std::optional<Setting> next = moved(trials, best.setting, step);
        for (int half = 0; half < 4 && !next; ++half) {
            step *= 0.5;
            next = moved(trials, best.setting, step);
        }
        const Candidate found = tried(trials, seed, next);
        if (found.offsets.size() == best.offsets.size()) {
            slopes.learn(step, best, found);
        }
        if (found.cost < best.cost) {
            best = found;
            damping *= 0.3;
        } else {
            damping = 10 * std::max(damping, 1e-3);
        }
    }
    return best;
}

/// A pattern search over speed, tip and, where no aim follows, direction (Hooke and Jeeves, Direct
/// search solution of numerical and statistical problems, 1961).
Candidate improve(const StrikeTrials& trials, const Seed& seed, Candidate best) {
    double step = 1;
    const bool aims = trials.problem().finds_direction && seed.pass.has_value();
    for (int i = 0; i < 7 && !best.is_good(); step *= i > 0 ? 0.5 : 1, ++i) {
        bool has_improved = true;
        for (int pass = 0; pass < 3 && has_improved && !best.is_good(); ++pass) {
            has_improved = false;
            for (int axis = 0; axis < 4; ++axis) {
                for (const double sign : {1.0, -1.0}) {
                    std::optional<Setting> next = best.setting;
                    if (axis < 3) {
                        Values by(0, 0, 0);
                        by[axis] = sign * step * (axis == 0 ? 0.22 : 0.2);
                        next = moved(trials, best.setting, by);
                    } else if (trials.problem().finds_direction && !aims) {
                        next->direction += 0.5 * kDegree * sign * step;
                    }
                    if (!next || is_same(*next, best.setting)) {
                        continue;
                    }
                    const Candidate found = tried(trials, seed, next);
                    if (found.cost < best.cost) {
                        best = found;
                        has_improved = true;
                        break;
                    }
                }
            }
        }
    }
    return best;
}

double chance(const StrikeTrials& trials, const Setting& setting, std::size_t count) {
    std::size_t hits = 0;
    for (std::size_t i = 0; i < count; ++i) {
        hits += trials.miss(trials.play(disturbed(setting, trials.problem().player, i),
                                        StrikeTrials::Depth::chance)) == 0
                    ? 1
                    : 0;
    }
    return static_cast<double>(hits) / static_cast<double>(count);
}

/// The directions around that of the setting between which the happenings stay as wanted.
Vec2 window(const StrikeTrials& trials, const Setting& setting) {
    const auto edge = [&](double sign) {
        const auto is_met = [&](double offset) {
            Setting tried = setting;
            tried.direction += sign * offset;
            return trials.sample(tried).is_met;
        };
        double inside = 0;
        double outside = 0.02 * kDegree;
        while (outside < 20 * kDegree && is_met(outside)) {
            inside = outside;
            outside *= 2;
        }
        for (int i = 0; i < 6; ++i) {
            const double middle = 0.5 * (inside + outside);
            (is_met(middle) ? inside : outside) = middle;
        }
        return inside;
    };
    return {setting.direction - edge(-1), setting.direction + edge(1)};
}

Solution solution_of(const StrikeTrials& trials, const Played& played) {
    Solution solution;
    solution.strike = with_setting(trials.strike(), played.setting);
    solution.outcome = played.outcome;
    solution.miss = trials.miss(solution.outcome);
    solution.is_solved = solution.miss == 0;
    solution.ball = trials.ball();
    const Trial trial = trials.trial_of(solution.outcome);
    solution.rest = trial.place_of(trials.ball());
    solution.route = route_of(trials.problem().wants, trial).text();
    return solution;
}

Solution judged(const StrikeTrials& trials, const Setting& setting, const Vec2& edges) {
    constexpr std::size_t kTrials = 100;
    Solution solution =
        solution_of(trials, {setting, trials.play(setting, StrikeTrials::Depth::whole)});
    solution.window = edges;
    if (solution.is_solved) {
        solution.chance = chance(trials, setting, kTrials);
        solution.chance_error =
            std::sqrt(solution.chance * (1 - solution.chance) / static_cast<double>(kTrials));
    }
    return solution;
}

/// Around the middle of its window, if places at rest allow.
Solution finish(const StrikeTrials& trials, Setting setting) {
    setting = trials.rounded_where_found(setting);
    if (!trials.problem().finds_direction) {
        return judged(trials, setting, {setting.direction, setting.direction});
    }
    const Vec2 edges = window(trials, setting);
    Setting middle = setting;
    middle.direction = 0.5 * (edges.x + edges.y);
    middle = trials.rounded_where_found(middle);
    if (trials.miss(trials.play(middle, StrikeTrials::Depth::whole)) == 0) {
        setting = middle;
    }
    return judged(trials, setting, edges);
}

/// The setting as it is likely to succeed with other values of speed and tip, from where it
/// succeeds so far; empty if it succeeds nowhere.
std::optional<Setting> aimed_by_neighbours(const StrikeTrials& trials,
                                           const std::vector<Played>& played, Setting setting) {
    const Setting* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Played& known : played) {
        const double apart = std::abs(logarithm(known.setting.speed / setting.speed)) +
                             2 * length(known.setting.tip - setting.tip);
        if (apart < least) {
            least = apart;
            nearest = &known.setting;
        }
    }
    if (nearest == nullptr) {
        return std::nullopt;
    }
    const double radius = trials.radius();
    setting.direction = nearest->direction + squirt_of(trials.strike(), *nearest, radius) -
                        squirt_of(trials.strike(), setting, radius);
    return setting;
}

/// Plays the seeds, and if places are wanted the grid around the first of them.
void explore(const StrikeTrials& trials, KnownRoute& route,
             const std::function<void(const Played&)>& played) {
    const Seed& first = route.seeds.front();
    const std::vector<Setting> grid = trials.has_places_wanted()
                                          ? grid_around(trials, first, route.is_fine)
                                          : std::vector<Setting>{};
    for (; route.tried < route.seeds.size() + grid.size(); ++route.tried) {
        const bool is_seed = route.tried < route.seeds.size();
        const std::optional<Setting> setting =
            is_seed
                ? route.seeds[route.tried].setting
                : aimed_by_neighbours(trials, route.played, grid[route.tried - route.seeds.size()]);
        std::optional<Played> found =
            setting ? play(trials, is_seed ? route.seeds[route.tried] : first, *setting)
                    : std::nullopt;
        if (found) {
            played(*found);
            route.played.push_back(std::move(*found));
        }
    }
}

}  // namespace

Solution settle(const StrikeTrials& trials, KnownRoute& route, bool tells_nearest,
                const std::function<void(const Solution&)>& found) {
    constexpr std::size_t kKept = 4;  // of which the places are approached
    constexpr std::size_t kJudged = 3;
    constexpr std::size_t kFewTrials = 20;
    double least = std::numeric_limits<double>::infinity();
    const auto tell = [&](const Played& played) {
        const Candidate candidate = rated(trials, played);
        if ((candidate.miss == 0 || tells_nearest) && candidate.cost < least) {
            least = candidate.cost;
            found(solution_of(trials, played));
        }
    };
    std::ranges::for_each(route.played, tell);
    explore(trials, route, tell);
    std::vector<Candidate> candidates;
    candidates.reserve(route.played.size());
    for (const Played& played : route.played) {
        candidates.push_back(rated(trials, played));
    }
    std::ranges::stable_sort(candidates, {}, &Candidate::cost);
    if (trials.has_places_wanted()) {
        if (candidates.size() > kKept) {
            candidates.resize(kKept);
        }
        for (Candidate& each : candidates) {
            each = approach(trials, route.seeds.front(), each);
        }
        std::ranges::stable_sort(candidates, {}, &Candidate::cost);
        if (!candidates.empty()) {
            candidates.front() = improve(trials, route.seeds.front(), candidates.front());
        }
        std::ranges::stable_sort(candidates, {}, &Candidate::cost);
        candidates.resize(std::min(candidates.size(), kJudged));
    }
    Setting best = candidates.empty() ? route.seeds.front().setting : candidates.front().setting;
    double best_value = -1;
    for (const Candidate& each : candidates) {
        if (each.miss > 0) {
            continue;
        }
        const double value = liking(trials, each.setting, chance(trials, each.setting, kFewTrials));
        if (value > best_value) {
            best_value = value;
            best = each.setting;
        }
    }
    return finish(trials, best);
}

Solution judge(const StrikeTrials& trials, const Setting& setting) {
    return judged(trials, setting, window(trials, setting));
}

}  // namespace carom::pipeline::solve
