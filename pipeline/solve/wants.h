// What a strike shall bring about, and whether it did.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vectors.h"
#include "sim/force_event.h"
#include "sim/trials.h"

namespace carom::pipeline::solve {

/// Something that happens so many times after the strike: a contact of two objects, of an object
/// and a cushion, or a ball that is potted.
struct Happening {
    sim::Trigger trigger;     // contact or potted; its `nth` is not used
    std::string pocket;       // potted only: in this one; empty: in any
    bool skips_jaws = false;  // only the straight parts of cushions count
    int at_least = 1;
    int at_most = std::numeric_limits<int>::max();
    /// Counted until this happens, which it has to.
    std::optional<sim::Trigger> before;
    double by = std::numeric_limits<double>::infinity();  // s after the strike

    /// Whether it is something to avoid.
    [[nodiscard]] bool is_avoided() const { return at_most == 0; }
};

/// Whether an event that the want's trigger names counts for it: by its pocket, and as no jaw.
[[nodiscard]] bool may_count(const Happening& want, const sim::Event& event);

/// A ball comes to rest near a place.
struct RestPlace {
    std::string ball;
    Vec2 near{0, 0};
    double within = 0.1;  // m, from centre to centre, seen from above
};

/// A ball flies over another one, without touching it.
struct Clearing {
    std::string ball, blocker;
};

struct Trial;

/// A measure of the whole shot lies in a range.
struct MeasuredRange {
    std::string measure;  // "rebound_angle:cue,1": which one it is
    std::string title;    // with its unit: "rebound_angle:cue,1 [deg]"
    /// In its unit; empty: what is measured does not happen.
    std::function<std::optional<double>(const Trial&)> value;
    bool needs_motion = false;                              // of the outcome
    double low = -std::numeric_limits<double>::infinity();  // in its unit
    double high = std::numeric_limits<double>::infinity();
    double per_unit = 1;  // m: how far a ball would be from its place that is as wrong as one unit
};

using Want = std::variant<Happening, RestPlace, Clearing, MeasuredRange>;

/// Whether it is only known when the trial is over, and may come nearer by other speeds and tips.
[[nodiscard]] inline bool is_of_end(const Want& want) {
    return std::holds_alternative<RestPlace>(want) || std::holds_alternative<MeasuredRange>(want);
}

/// A trial as it concerns wants: since a strike.
struct Trial {
    const sim::WorldDescription& world;
    const std::vector<std::string>& names;  // of the bodies of outcome.states
    const sim::Outcome& outcome;
    std::size_t strike = 0;  // which of the strikes in the log it is, from 0

    /// The events from the strike on; empty if it did not happen.
    [[nodiscard]] std::span<const sim::Event> events() const;
    /// Where a ball is at the end; empty if it is off the table or no moving body.
    [[nodiscard]] std::optional<Vec2> place_of(const std::string& ball) const;
};

/// How far a want is from being met: 0 if it is. A place at rest: the distance (m) beyond `within`;
/// a measure likewise, by its `per_unit`. Happenings: 1 for each that is missing or too many, at
/// least 1.
[[nodiscard]] double miss_of(const Want& want, const Trial& trial);

/// How far the outcome is from the middle of what is wanted, as a fraction of what may be off; of a
/// range without an end 0 inside. 0 for wants that are not of the end.
[[nodiscard]] double distance_of(const Want& want, const Trial& trial);

/// How far (m) a measure is above the middle of its range, or, if that has no end, above or below
/// it; by `per_unit`. Empty if what is measured does not happen.
[[nodiscard]] std::optional<double> offset_of(const MeasuredRange& want, const Trial& trial);

/// Sees the events of a trial one after the other, and tells when its wants are decided.
class Watch {
  public:
    Watch(const std::vector<Want>& wants, std::size_t strike);

    void see(const sim::Event& event);

    /// Whether one of the happenings can no longer be as it is wanted.
    [[nodiscard]] bool has_failed() const { return has_failed_; }
    /// Whether all that shall happen has happened; what is to be avoided may still follow.
    [[nodiscard]] bool is_met() const { return is_met_; }
    /// Whether the strike has happened.
    [[nodiscard]] bool has_begun() const { return seen_strikes_ > strike_; }

  private:
    struct Count {
        const Happening* wanted;
        int count = 0;
        double last_contact = -1;  // s
        bool is_closed = false;    // `before` has happened
    };
    std::vector<Count> counts_;
    std::size_t strike_;
    std::size_t seen_strikes_ = 0;
    double began_ = 0;
    bool has_failed_ = false;
    bool is_met_ = false;
};

}  // namespace carom::pipeline::solve
