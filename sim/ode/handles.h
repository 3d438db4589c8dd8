// Owners for ODE's handles. Private to sim/ode.
#pragma once

#include <memory>

#include <ode/ode.h>

#include "sim/timeline/vocabulary.h"

namespace carom::sim::ode {

struct WorldDeleter {
    void operator()(dWorldID world) const { dWorldDestroy(world); }
};
struct JointGroupDeleter {
    void operator()(dJointGroupID group) const { dJointGroupDestroy(group); }
};

/// Destroys its bodies and joints with it.
using World = std::unique_ptr<dxWorld, WorldDeleter>;
/// To be declared after its world: it is destroyed first.
using JointGroup = std::unique_ptr<dxJointGroup, JointGroupDeleter>;

inline Vec3 to_vec3(const dReal* v) {
    return {v[0], v[1], v[2]};
}

}  // namespace carom::sim::ode
