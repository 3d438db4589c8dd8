// The questions of a page about a strike, as those of the solver.
#pragma once

#include <string>
#include <vector>

#include "pipeline/shot/shot.h"
#include "pipeline/solve/solver.h"
#include "pipeline/studio/solve_messages.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// A strike of a shot in a world without those that follow it.
struct SoughtStrike {
    sim::WorldDescription world;
    std::size_t event = 0;                // of the world
    double time = 0;                      // s
    pipeline::solve::PlayerError player;  // of the shot's `solve`, else a club player

    [[nodiscard]] const std::string& ball() const { return world.events[event].object; }
    [[nodiscard]] const sim::Strike& strike() const {
        return std::get<sim::Strike>(world.events[event].action);
    }
};

/// The strike with that index in ShotState.events. It has a direction, also where the shot says
/// what it aims at. As many as there are events: a new one of the ball `struck` after them. Throws
/// Error if there is no such strike.
[[nodiscard]] SoughtStrike sought_strike(const pipeline::Shot& shot, const sim::Timeline& timeline,
                                         int event, const std::string& struck);

/// The balls other than the struck one that the strike pots before the next strike, and where.
[[nodiscard]] std::vector<Pot> pots_of(const SoughtStrike& sought, const sim::Timeline& timeline);

/// The first other ball that the struck one meets; empty if there is none.
[[nodiscard]] std::string first_hit(const SoughtStrike& sought, const sim::Timeline& timeline);

/// To pot these balls and not the struck one, with a raised stick only where no level one does it.
[[nodiscard]] pipeline::solve::SolveProblem pot_problem(const SoughtStrike& sought,
                                                        const std::vector<Pot>& pots);

}  // namespace carom::studio
