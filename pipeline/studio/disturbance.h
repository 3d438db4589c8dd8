// Small disturbances of a shot, which show how sure its outcome is.
#pragma once

#include "core/vectors.h"
#include "pipeline/studio/messages.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::studio {

/// The disturbances of one run: what Fan says, with the signs and directions of this run.
struct Disturbance {
    Vec2 displacement{0, 0};  // of struck balls, m
    double turn = 0;          // of directions about the vertical, rad
};

/// Those of run `run` (from 0) of the fan. The displacements point into directions that divide a
/// full turn evenly; the angles fill [-angle, angle] evenly.
[[nodiscard]] Disturbance disturbance_of(int run, const Fan& fan);

/// The world with its struck balls displaced and its strikes, impulses, forces and velocities
/// turned. `timeline`: the motion without disturbances, which says where a strike aims.
[[nodiscard]] sim::WorldDescription disturbed(const sim::WorldDescription& world,
                                              const sim::Timeline& timeline,
                                              const Disturbance& disturbance);

}  // namespace carom::studio
