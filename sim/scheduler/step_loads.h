// How the pairs of bodies press against each other in a step of ODE.
#pragma once

#include <vector>

#include "sim/scheduler/contact_log.h"
#include "sim/scheduler/toi_substep.h"

namespace carom::sim {

struct PairLoad {
    int first = 0;
    ContactPartner partner;
    ContactLoad load;
};

/// The loads of all pairs that press against each other in a trial step, in the order of its
/// contacts. The points of contact of a pair are summed; their slips are weighted with their
/// impulses. `bodies`: those of the trial.
[[nodiscard]] std::vector<PairLoad> pair_loads(const ToiSubstep& trial,
                                               const std::vector<MovingBody>& bodies);

}  // namespace carom::sim
