// Puts balls back by the rule of a game whenever everything rests.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/diagnostic.h"
#include "sim/billiards/respotting_rules.h"
#include "sim/scheduler/ball_placer.h"
#include "sim/scheduler/bodies.h"
#include "sim/scheduler/recorder.h"

namespace carom::sim {

/// Does nothing if the world has no such rule.
class Respotting {
  public:
    Respotting(const WorldDescription& world, const Bodies& bodies, const Recorder& recorder,
               BallPlacer& placer);

    /// Whether the log has grown since the last time, so that a shot may have been played.
    [[nodiscard]] bool has_news() const {
        return rules_ && recorder_.events().size() > seen_events_;
    }
    /// Everything rests: puts back the balls that the rule puts back.
    void act(double time);

    /// One warning for each ball that should have been put back and had no place.
    [[nodiscard]] std::vector<Diagnostic> never_put_back() const;

  private:
    [[nodiscard]] billiards::ShotOutcome played_shot() const;
    [[nodiscard]] std::vector<billiards::GameBall> game_balls(double time) const;
    [[nodiscard]] std::uint32_t index_of(const std::string& ball) const;
    [[nodiscard]] bool is_shot_played() const;
    void note_balls_on_table();
    void put_back(const billiards::RespottedBall& put, double time);

    const Bodies& bodies_;
    const Recorder& recorder_;
    BallPlacer& placer_;
    std::optional<billiards::RespottingRules> rules_;
    bool has_cue_ball_ = true;  // by name, not only by the stick: not in carom
    std::size_t seen_events_ = 0;
    std::set<std::string> on_table_;  // at the last rest
    std::vector<Diagnostic> blocked_;
};

}  // namespace carom::sim
