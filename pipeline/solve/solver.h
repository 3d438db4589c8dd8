// Finds strikes that bring about what is wanted.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/solve/wants.h"
#include "pipeline/variants/variants.h"
#include "sim/trials.h"

namespace carom::pipeline::solve {

/// Standard deviations of what a player does from what the player means to do.
struct PlayerError {
    double direction = 0;  // rad
    double elevation = 0;  // rad
    double speed = 0;      // as a fraction of it
    double tip = 0;        // each way, in ball radii

    bool operator==(const PlayerError&) const = default;
};

/// Those of a "beginner", a "club" player or a "professional"; empty for other words. Programs in
/// the computer olympiads' tournaments played with deviations of 0.125 degrees of direction, 0.1
/// degrees of elevation, 0.075 m/s and 0.5 mm each way at the tip (quoted; Smith, PickPocket: a
/// computer billiards shark, 2007, and Archibald, Altman and Shoham, Analysis of a winning
/// computational billiards player, 2009). A club player has these here, with 4 % of speed; a
/// professional half, a beginner three times as much, which nobody has measured.
[[nodiscard]] std::optional<PlayerError> player_error(std::string_view level);

/// What makes one solution better than another that meets the same wants.
enum class Preference { likely, slow, little_spin };

struct SolveProblem {
    std::size_t event = 0;  // of the world: a strike, whose other values are kept
    bool finds_direction = true;
    bool finds_speed = true;
    bool finds_tip = true;
    bool finds_elevation = false;
    bool may_raise = false;  // the elevation is found where no level strike does what is wanted
    std::vector<Want> wants;
    std::vector<Preference> prefer{Preference::likely};
    PlayerError player;
    std::size_t max_routes = 6;  // whose settings are improved
};

struct Solution {
    sim::Strike strike;
    bool is_solved = false;    // all wants are met
    double miss = 0;           // the sum of miss_of(), Happenings counted as 10 m
    std::string route;         // Route::text()
    Vec2 window{0, 0};         // the directions (rad) between which the happenings are as wanted
    double chance = 0;         // that the wants are met under the player's error
    double chance_error = 0;   // standard error
    std::string ball;          // that is struck
    std::optional<Vec2> rest;  // where it is at the end; empty: not on the table
    sim::Outcome outcome;

    [[nodiscard]] double window_width() const { return window.y - window.x; }
};

/// How a search is done.
struct SolveWork {
    PartsWork parts{};
    /// Told of each solution when it is found and of each better one of the same way, by one thread
    /// at a time. Their windows and chances may come from fewer trials than those of the result.
    std::function<void(const Solution&)> found{};
    /// Whether `found` is also told of what misses places at rest less than all before.
    bool tells_nearest = false;
};

struct SolveResult {
    std::vector<Solution> solutions;  // the best one first; those that are solved before others
    std::size_t simulations = 0;
    bool is_complete = true;  // false: the work was stopped, and this is what had been found
};

struct Seed;
class StrikeTrials;

/// Finds strikes, and keeps what it learns of them: the same wants with other places at rest are
/// answered sooner.
///
/// Directions are sampled at several speeds, more closely where the ball would meet others directly
/// or off up to four cushions (mirror images), and signed misses of pockets and balls followed to
/// their zeros. What meets the wants is sorted by its route; the settings of each route are then
/// varied over a grid and by a pattern search, the aim following by the secant method, until places
/// at rest and preferences are met. Chances are shares of trials with the player's error. The
/// result depends on world, problem and places alone, not on what was asked before.
class Solver {
  public:
    /// `trials`: not null.
    Solver(std::shared_ptr<const sim::Trials> trials, SolveProblem problem);
    ~Solver();
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    /// Wants these places at rest instead of those wanted so far. Only where none are wanted after
    /// some may the result be another than that of a new solver.
    void want_places(std::vector<RestPlace> places);

    /// Throws Error if the strike never comes or the trials' world has problems. After a stop it
    /// returns soon with what had been found; what was learned is kept.
    [[nodiscard]] SolveResult solve(const SolveWork& work = {});

    /// What a strike brings about: its route, window and chance. Throws Error likewise, Stopped if
    /// the work is stopped.
    [[nodiscard]] Solution judge(const sim::Strike& strike, const PartsWork& work = {});

  private:
    struct Knowledge;
    struct Strikes;
    [[nodiscard]] std::vector<std::vector<Seed>> find_seeds(const StrikeTrials& sought);
    std::shared_ptr<const sim::Trials> trials_;
    SolveProblem problem_;
    std::unique_ptr<Knowledge> knowledge_;
};

/// The result of a solver that is asked once.
[[nodiscard]] SolveResult solve(const sim::Trials& trials, const SolveProblem& problem,
                                const SolveWork& work = {});

}  // namespace carom::pipeline::solve
