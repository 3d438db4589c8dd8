// Trials of one strike in various directions, in a world with everything that comes before it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/billiards/free_place.h"
#include "sim/trials.h"

namespace carom::sim {

/// Where everything is when a strike happens.
struct Setting {
    double time = 0;                          // s
    std::vector<billiards::LyingBall> balls;  // on the table

    /// nullptr if it is not on the table.
    [[nodiscard]] const billiards::LyingBall* find(const std::string& name) const;
};

/// Steps of a trial as bake_within counts them. More take too long for what a shot says.
inline constexpr std::uint64_t kMostTrialSteps = 15'000'000;

/// The setting of the first of the strikes that happens, whatever its direction, and which it is:
/// an index of `strikes`, which are indices of events.
struct NextStrike {
    std::size_t which = 0;
    Setting setting;
};
struct NextStrikeSearch {
    std::optional<NextStrike> found;  // empty: none happens
    bool is_too_long = false;         // or not within kMostTrialSteps
};
[[nodiscard]] NextStrikeSearch next_strike(const Trials& trials,
                                           const std::vector<ForceEvent>& events,
                                           const std::vector<std::size_t>& strikes);

/// A line that the struck ball may cross.
struct Line {
    Vec2 point{0, 0};
    Vec2 across{0, 0};  // unit, along the line: to the left of the ball's way
    double half_length = 0;
};

/// What a strike did, as far as it was followed.
struct Played {
    std::optional<Event> contact;    // of the struck ball with the one that it shall hit
    Vec2 velocity{0, 0};             // of the latter right after it, if it was followed no further
    std::optional<Event> end;        // of the free way of the latter
    std::optional<double> crossing;  // where the struck ball crosses the line without the contact:
                                     // m from its point, to the left
    std::string instead;             // what it does before either: "'cue' hits 'two' first"
};

class StrikeTrials {
  public:
    /// `events`: those of the world, with any direction of the strike events[event].
    StrikeTrials(const Trials& trials, const std::vector<ForceEvent>& events, std::size_t event,
                 const Setting& setting);

    [[nodiscard]] const std::string& ball() const { return ball_; }
    [[nodiscard]] double radius() const { return radius_; }
    [[nodiscard]] int count() const { return count_; }

    /// Strikes until the ball touches `target` (empty: none), crosses the line or does something
    /// else; with `follows`, until the free way of `target` ends then.
    [[nodiscard]] Played play(double direction, const std::string& target, const Line& line,
                              bool follows);

    /// The velocity of the struck ball right before a contact at that time.
    [[nodiscard]] Vec2 velocity_before(double direction, double time);

    /// How a ball ends on the table: potted, off the table or at rest. Empty if the shot ends
    /// first.
    [[nodiscard]] std::optional<Event> end_of(double direction, const std::string& ball);

    /// The centre of a ball at an event of it.
    [[nodiscard]] Vec2 centre_of(const std::string& name, const Event& event) const;

  private:
    std::optional<Outcome> run(std::vector<ForceEvent> events,
                               std::function<bool(const Event&)> is_answered);
    [[nodiscard]] std::vector<ForceEvent> events_at(double direction) const;
    [[nodiscard]] bool is_this_strike(const Event& event) const;
    [[nodiscard]] std::string what_instead(const Event& event) const;
    [[nodiscard]] bool ends_way(const Event& event, const Event& contact,
                                const std::string& target) const;

    const Trials& trials_;
    const std::vector<ForceEvent>& events_;
    std::size_t event_;
    const Setting& setting_;
    std::string ball_;
    double radius_;
    Vec2 start_{0, 0};
    int count_ = 0;
};

[[nodiscard]] double radius_of(const WorldDescription& world, const std::string& ball);

}  // namespace carom::sim
