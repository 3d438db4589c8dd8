#include "sim/billiards/respotting_rules.h"

#include <algorithm>
#include <utility>

#include "sim/billiards/ball_names.h"
#include "sim/billiards/free_place.h"

namespace carom::sim::billiards {
namespace {

bool is_colour(const std::string& name) {
    return snooker_value(name).value_or(0) > 1;
}
bool is_red(const std::string& name) {
    return snooker_value(name) == 1;
}

/// The ball with the lowest value or number among those on the table; empty if none has one.
template <class ValueOf>
std::string lowest(const std::set<std::string>& names, ValueOf value_of) {
    std::string found;
    for (const std::string& name : names) {
        const std::optional<int> value = value_of(name);
        if (value && (found.empty() || *value < *value_of(found))) {
            found = name;
        }
    }
    return found;
}

/// Puts balls down one after the other.
class Placing {
  public:
    Placing(const TableMeasures& table, const std::vector<GameBall>& balls,
            std::set<std::string>& owed)
        : table_(table), balls_(balls), owed_(owed), places_(table, lying(balls)) {}

    [[nodiscard]] std::vector<RespottedBall> take() { return std::move(done_); }

    [[nodiscard]] bool is_owed(const std::string& ball) const { return owed_.contains(ball); }
    [[nodiscard]] std::set<std::string> owed() const { return owed_; }

    /// Onto that spot if it is free; true if the ball now lies there.
    bool on_spot(const std::string& ball, const Spot& spot) {
        return places_.is_free(spot.place, radius_of(ball)) &&
               put(ball, FreePlace{spot.place, spot.name});
    }
    /// Onto the spot or the nearest place on its line, first in `direction`.
    bool near_spot(const std::string& ball, const Spot& spot, double direction) {
        if (on_spot(ball, spot)) {
            return true;
        }
        for (const double towards : {direction, -direction}) {
            if (const auto place = places_.along_table(spot.place, towards, radius_of(ball))) {
                return put(ball, FreePlace{*place, {}});
            }
        }
        return false;
    }
    /// Onto another place, because the spot is occupied.
    bool on_next(const std::string& ball, const Spot& spot) {
        const auto place = next_place(places_, table_, spot.place, spot.name, radius_of(ball));
        return place && put(ball, *place);
    }
    /// The ball that lies on the spot; empty if it is free.
    [[nodiscard]] std::string occupant(const std::string& ball, const Spot& spot) const {
        const LyingBall* found = places_.occupant(spot.place, radius_of(ball));
        return found == nullptr ? std::string() : found->name;
    }

  private:
    static std::vector<LyingBall> lying(const std::vector<GameBall>& balls) {
        std::vector<LyingBall> on_table;
        for (const GameBall& ball : balls) {
            if (ball.is_on_table) {
                on_table.push_back({ball.name, ball.place, ball.radius});
            }
        }
        return on_table;
    }
    [[nodiscard]] double radius_of(const std::string& name) const {
        return std::ranges::find(balls_, name, &GameBall::name)->radius;
    }
    bool put(const std::string& ball, const FreePlace& place) {
        places_.add({ball, place.place, radius_of(ball)});
        done_.push_back({ball, place.place, place.spot});
        owed_.erase(ball);
        return true;
    }

    const TableMeasures& table_;
    const std::vector<GameBall>& balls_;
    std::set<std::string>& owed_;
    FreePlaces places_;
    std::vector<RespottedBall> done_;
};

Spot spot_named(const std::vector<Spot>& spots, std::string_view name) {
    return *std::ranges::find(spots, name, &Spot::name);
}

/// Colours whose own spots are free go there; the others follow from the highest value.
void place_snooker(const TableMeasures& table, Placing& placing) {
    std::vector<Spot> spots = snooker_spots(table);
    std::ranges::reverse(spots);
    for (const Spot& spot : spots) {
        if (placing.is_owed(spot.name)) {
            placing.on_spot(spot.name, spot);
        }
    }
    for (const Spot& spot : spots) {
        if (placing.is_owed(spot.name)) {
            placing.on_next(spot.name, spot);
        }
    }
    const Spot& yellow = spot_named(spots, "yellow");
    for (const std::string& cue : placing.owed()) {
        if (!is_colour(cue)) {
            const Spot right{"", yellow.place * Vec2(1, 0.5)};
            const Spot left{"", yellow.place * Vec2(1, -0.5)};
            if (!placing.on_spot(cue, right) && !placing.on_spot(cue, left)) {
                placing.near_spot(cue, right, -1);
            }
        }
    }
}

void place_pool(const TableMeasures& table, Placing& placing) {
    const std::vector<Spot> spots = pool_spots(table);
    for (const std::string& ball : placing.owed()) {
        if (pool_number(ball)) {
            placing.near_spot(ball, spot_named(spots, "foot"), 1);
        } else {
            placing.near_spot(ball, spot_named(spots, "head"), -1);
        }
    }
}

void place_carom(const TableMeasures& table, const std::string& struck, Placing& placing) {
    const std::vector<Spot> spots = pool_spots(table);
    const auto own_spot = [&](const std::string& ball) {
        return spot_named(spots, ball == "red" ? "foot" : ball == struck ? "centre" : "head");
    };
    for (const std::string& ball : placing.owed()) {
        placing.on_spot(ball, own_spot(ball));
    }
    for (const std::string& ball : placing.owed()) {
        const Spot own = own_spot(ball);
        if (!placing.on_spot(ball, own_spot(placing.occupant(ball, own)))) {
            placing.on_next(ball, own);
        }
    }
}

}  // namespace

void RespottingRules::note_snooker(const ShotOutcome& shot) {
    const bool had_reds = std::ranges::any_of(shot.on_table, is_red);
    const bool is_cue_lost = shot.has_lost(shot.cue_ball);
    const std::string ball_on = lowest(shot.on_table, snooker_value);
    const bool is_ending = !had_reds && !follows_red_;
    const bool stays_down = is_ending && shot.first_hit == ball_on && shot.off_table.empty() &&
                            shot.potted == std::set<std::string>{ball_on};
    for (const auto* lost : {&shot.potted, &shot.off_table}) {
        for (const std::string& name : *lost) {
            if (name == shot.cue_ball || (is_colour(name) && !stays_down)) {
                owed_.insert(name);
            }
        }
    }
    follows_red_ = had_reds && !is_cue_lost && is_red(shot.first_hit) &&
                   std::ranges::any_of(shot.potted, is_red);
}

void RespottingRules::note_pool(const ShotOutcome& shot) {
    const bool is_cue_lost = shot.has_lost(shot.cue_ball);
    if (is_cue_lost) {
        owed_.insert(shot.cue_ball);
    }
    if (game_ == Game::eight_ball) {
        const auto numbered = std::ranges::count_if(
            shot.on_table, [](const std::string& name) { return pool_number(name).has_value(); });
        if (shot.has_lost("eight") && numbered == 15) {
            owed_.insert("eight");
        }
        return;
    }
    const bool is_foul = is_cue_lost || shot.first_hit != lowest(shot.on_table, pool_number);
    if (shot.off_table.contains("nine") || (shot.potted.contains("nine") && is_foul)) {
        owed_.insert("nine");
    }
}

std::vector<RespottedBall> RespottingRules::after(const ShotOutcome& shot,
                                                  const std::vector<GameBall>& balls) {
    if (game_ == Game::snooker) {
        note_snooker(shot);
    } else if (game_ == Game::carom) {
        owed_.insert(shot.potted.begin(), shot.potted.end());
        owed_.insert(shot.off_table.begin(), shot.off_table.end());
    } else {
        note_pool(shot);
    }
    std::erase_if(owed_, [&](const std::string& name) {  // put back or taken off by an event
        const auto ball = std::ranges::find(balls, name, &GameBall::name);
        return ball == balls.end() || ball->is_on_table;
    });
    Placing placing(table_, balls, owed_);
    if (game_ == Game::snooker) {
        place_snooker(table_, placing);
    } else if (game_ == Game::carom) {
        place_carom(table_, shot.cue_ball, placing);
    } else {
        place_pool(table_, placing);
    }
    return placing.take();
}

}  // namespace carom::sim::billiards
