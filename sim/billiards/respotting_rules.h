// What the rules of a game put back onto the table between two shots.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/vectors.h"
#include "sim/billiards/game.h"
#include "sim/billiards/table.h"

namespace carom::sim::billiards {

/// A ball of the game after a shot, when everything rests.
struct GameBall {
    std::string name;
    double radius = 0;         // m
    bool is_on_table = false;  // not in a pocket, beside the table or taken off
    Vec2 place{0, 0};          // seen from above, if it is on the table
};

/// What one shot did, as far as the event log says it.
struct ShotOutcome {
    std::string cue_ball;            // the ball that was struck
    std::string first_hit;           // the ball that the cue ball touched first; empty: none
    std::set<std::string> on_table;  // before the shot
    std::set<std::string> potted;    // by it
    std::set<std::string> off_table;

    [[nodiscard]] bool has_lost(const std::string& ball) const {
        return potted.contains(ball) || off_table.contains(ball);
    }
};

/// A ball that is put down on a place, on the spot of that name or on none (empty).
struct RespottedBall {
    std::string ball;
    Vec2 place{0, 0};
    std::string spot;

    bool operator==(const RespottedBall&) const = default;
};

/// Puts balls back as the rules of one game say. It sees only which balls fell and which the cue
/// ball touched first, so it knows neither calls nor fouls beyond those.
///
/// Snooker (WPBSA, Official Rules of Snooker, section 3, rules 3 and 7). A colour that fell comes
/// back while reds are on the table before the shot, and after the shot that followed the last red.
/// From then on the colour of the lowest value stays down, if the cue ball touched it first and no
/// other ball fell; every other colour that fell comes back. A colour goes to its own spot, else to
/// the free spot of the highest value, else as near to its own spot as possible towards the top
/// cushion, else towards the baulk cushion. Reds stay down. The cue ball in hand: halfway between
/// the brown and the yellow spot, else between brown and green, else behind them.
///
/// Nine ball (WPA, The Rules of Play, 1.4, 1.5 and Nine Ball). The nine comes back to the foot spot
/// if it left the table, if the cue ball fell too, or if the cue ball did not touch the lowest ball
/// first; a legal nine has won and stays down. Other balls stay down.
///
/// Eight ball (WPA, Eight Ball). The eight comes back to the foot spot if it fell at the break, a
/// shot before which all 15 balls are on the table. Other balls stay down.
///
/// In both, the place is the nearest to the foot spot towards the foot cushion, else towards the
/// head; the cue ball in hand goes to the head spot, else to the nearest place towards the head
/// cushion, else towards the foot.
///
/// Carom (UMB, World Rules of Carom Billiard, articles 27 and 28, as in three cushions). Balls that
/// left the table come back: red to the foot spot, the ball of the player who plays next to the
/// head spot, the one that was struck to the centre; where a ball lies on it, to the spot of that
/// ball, else to a free one of the three.
class RespottingRules {
  public:
    RespottingRules(Game game, const TableMeasures& table) : game_(game), table_(table) {}

    /// The balls that are put back now, in this order. A ball for which there was no place is
    /// tried again after the next shot.
    [[nodiscard]] std::vector<RespottedBall> after(const ShotOutcome& shot,
                                                   const std::vector<GameBall>& balls);

    /// The balls that would have been put back if there had been a place for them.
    [[nodiscard]] const std::set<std::string>& without_place() const { return owed_; }

  private:
    void note_snooker(const ShotOutcome& shot);
    void note_pool(const ShotOutcome& shot);

    Game game_;
    const TableMeasures& table_;
    std::set<std::string> owed_;  // balls that come back
    bool follows_red_ = false;    // snooker: the previous shot potted a red
};

}  // namespace carom::sim::billiards
