// Trials of one strike with other settings, and what a search reads from them.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/solve/legs.h"
#include "pipeline/solve/player.h"
#include "pipeline/solve/route.h"
#include "pipeline/solve/wants.h"

namespace carom::pipeline::solve {

/// A leg may end this far (m) before the point that it was to reach: in a pocket's jaws.
inline constexpr double kMouth = 0.16;

/// A point that a ball is to come to.
struct Target {
    std::string ball;
    Vec2 point;
    bool is_pocket = false;
};

/// A ball's leg that is to lead to a target: StrikeTrials::targets()[target].
struct Pass {
    std::size_t target = 0;
    std::uint64_t cause = 0;
};

/// What a search reads from a trial.
struct Sample {
    double direction = 0;
    bool is_met = false;                 // all wants but places at rest
    Route route;                         // then
    double distance = 0;                 // then, if no ball has a target: StrikeTrials::distance()
    std::vector<std::vector<Leg>> legs;  // of each target's ball
};

class StrikeTrials {
  public:
    /// Throws Error if the strike never comes.
    StrikeTrials(const sim::Trials& trials, const SolveProblem& problem, const PartsWork& work);

    enum class Depth {
        scan,    // until the wants but places at rest are met or hopeless
        whole,   // to the end, unless a happening has failed
        chance,  // likewise, unless they are hopeless
    };
    /// `pass`: the trial also ends when it is decided on which side this leg passes its target.
    [[nodiscard]] sim::Outcome play(const Setting& setting, Depth depth,
                                    const Pass* pass = nullptr) const;
    /// What a search reads from a trial of that setting.
    [[nodiscard]] Sample sample_of(const Setting& setting, const sim::Outcome& outcome) const;
    /// Of a trial of a scan.
    [[nodiscard]] Sample sample(const Setting& setting) const {
        return sample_of(setting, play(setting, Depth::scan));
    }
    [[nodiscard]] Trial trial_of(const sim::Outcome& outcome) const {
        return {trials_.world(), trials_.names(), outcome, strike_};
    }
    /// Whether all wants but places at rest are met.
    [[nodiscard]] bool is_met(const sim::Outcome& outcome) const;
    /// The sum of miss_of() over the wants, those of happenings as 10 m each.
    [[nodiscard]] double miss(const sim::Outcome& outcome) const;

    /// How far balls rest from the middles of their places: the sum over the wants, each as a
    /// fraction of `within`. A setting whose balls come to the edge succeeds by luck.
    [[nodiscard]] double distance(const sim::Outcome& outcome) const;

    /// Where balls rest, seen from the middles of their places: both coordinates of each wanted
    /// one; and how far measures are from the middles of their ranges, by their `per_unit`. Empty
    /// if a ball is off the table, or what is measured does not happen.
    [[nodiscard]] std::vector<double> offsets(const sim::Outcome& outcome) const;

    [[nodiscard]] const SolveProblem& problem() const { return problem_; }
    [[nodiscard]] const PartsWork& work() const { return work_; }
    [[nodiscard]] const sim::WorldDescription& world() const { return trials_.world(); }
    /// The world at the strike as a shot of its own, in which the strike is the first event, so
    /// that no trial repeats what comes before; empty if the strike is the first one, or something
    /// moves, happens later or is moved by keys.
    [[nodiscard]] std::optional<sim::WorldDescription> world_at_strike() const;
    /// As the shot gives it.
    [[nodiscard]] const sim::Strike& strike() const { return base_; }
    [[nodiscard]] Setting given() const { return setting_of(base_); }
    /// The setting, what is found of it in numbers that a text has exactly.
    [[nodiscard]] Setting rounded_where_found(const Setting& setting) const;
    [[nodiscard]] const std::string& ball() const { return ball_; }
    [[nodiscard]] double radius() const { return radii_.at(ball_); }
    [[nodiscard]] double radius_of(const std::string& ball) const { return radii_.at(ball); }
    /// Of the balls, when the strike comes.
    [[nodiscard]] const std::map<std::string, Vec2>& places() const { return places_; }
    [[nodiscard]] const std::vector<Target>& targets() const { return targets_; }
    /// Or measures.
    [[nodiscard]] bool has_places_wanted() const {
        return std::ranges::any_of(problem_.wants, is_of_end);
    }
    /// Whether a measure needs the motion of outcomes.
    [[nodiscard]] bool needs_motion() const;
    [[nodiscard]] bool has_flights_wanted() const { return has<Clearing>(); }
    [[nodiscard]] std::size_t simulations() const { return simulations_; }

  private:
    template <class Kind>
    [[nodiscard]] bool has() const {
        return std::ranges::any_of(
            problem_.wants, [](const Want& want) { return std::holds_alternative<Kind>(want); });
    }
    void find_start();
    void find_targets();
    [[nodiscard]] bool shall_be_potted(const std::string& ball) const;

    const sim::Trials& trials_;
    const SolveProblem& problem_;
    const PartsWork& work_;
    sim::Strike base_;
    std::string ball_;
    Radii radii_;
    std::size_t strike_ = 0;  // which of the log's
    std::map<std::string, Vec2> places_;
    sim::Outcome start_;  // up to the strike
    std::vector<Target> targets_;
    mutable std::atomic<std::size_t> simulations_{0};
};

}  // namespace carom::pipeline::solve
