// Places on the cloth that no ball occupies.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/billiards/spots.h"
#include "sim/billiards/table.h"

namespace carom::sim::billiards {

/// A ball that lies on the table.
struct LyingBall {
    std::string name;
    Vec2 place{0, 0};  // seen from above, m
    double radius = 0;
};

/// A place for a ball; `spot` is empty if it is not on a spot.
struct FreePlace {
    Vec2 place{0, 0};
    std::string spot;
};

/// The balls on a table, and the places that they leave free. A ball that is put down beside
/// another one keeps a distance of 0.1 mm, so that they do not touch.
class FreePlaces {
  public:
    /// The balls of these distances (m) do not touch. It is more than the distance at which a
    /// strike takes balls to be touching.
    static constexpr double kApart = 1e-4;

    FreePlaces(const TableMeasures& table, std::vector<LyingBall> balls)
        : table_(table), balls_(std::move(balls)) {}

    void add(LyingBall ball) { balls_.push_back(std::move(ball)); }
    /// The ball no longer lies there.
    void take(std::string_view name);

    /// The first ball that is in the way of one of `radius` at `place`, or nullptr.
    [[nodiscard]] const LyingBall* occupant(const Vec2& place, double radius) const;
    [[nodiscard]] bool is_free(const Vec2& place, double radius) const {
        return occupant(place, radius) == nullptr;
    }

    /// The first of the spots that is free.
    [[nodiscard]] std::optional<FreePlace> first_free(const std::vector<Spot>& spots,
                                                      double radius) const;

    /// The free place nearest to `from` on the line through it along the table, towards the foot
    /// or top cushion (`direction` 1) or the other one (-1); empty if there is none.
    [[nodiscard]] std::optional<Vec2> along_table(const Vec2& from, double direction,
                                                  double radius) const;

  private:
    const TableMeasures& table_;
    std::vector<LyingBall> balls_;
};

/// Where a ball of `radius` goes whose place is occupied, by the rules of the table's game:
///   - snooker: the free spot of the highest value, else the nearest place towards the top cushion,
///     else towards the baulk cushion (WPBSA, Official Rules of Snooker, section 3, rule 7);
///   - carom: the first free one of the foot, head and centre spot, else as in pool;
///   - pool and others: the nearest place towards the foot cushion, else towards the head (WPA, The
///     Rules of Play, 1.4).
/// In snooker and carom a ball that has no spot (empty `spot`) goes to a place on its line. Empty
/// if there is none.
[[nodiscard]] std::optional<FreePlace> next_place(const FreePlaces& places,
                                                  const TableMeasures& table, const Vec2& at,
                                                  std::string_view spot, double radius);

}  // namespace carom::sim::billiards
