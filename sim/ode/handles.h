// RAII owners of ODE's handles. Private to sim/ode.
#pragma once

#include <memory>

#include <ode/ode.h>

#include "core/error.h"
#include "core/vectors.h"

namespace carom::sim::ode {

struct WorldDeleter {
    void operator()(dWorldID world) const { dWorldDestroy(world); }
};
struct ThreadingDeleter {
    void operator()(dThreadingImplementationID threading) const {
        dThreadingFreeImplementation(threading);
    }
};
struct JointGroupDeleter {
    void operator()(dJointGroupID group) const { dJointGroupDestroy(group); }
};

/// A world that destroys its bodies and joints with it. By default all worlds of a process share
/// one built-in threading implementation, which crashes when two threads step concurrently
/// (dWorldSetStepThreadingImplementation in ode/objects.h); so each world has its own.
class World {
  public:
    World() : threading_(dThreadingAllocateSelfThreadedImplementation()), world_(dWorldCreate()) {
        if (threading_ == nullptr || world_ == nullptr) {
            throw Error("ODE could not create a world: it is probably out of memory");
        }
        dWorldSetStepThreadingImplementation(
            world_.get(), dThreadingImplementationGetFunctions(threading_.get()), threading_.get());
    }

    [[nodiscard]] dWorldID get() const { return world_.get(); }

  private:
    // The world is destroyed first, since it uses the threading implementation.
    std::unique_ptr<dxThreadingImplementation, ThreadingDeleter> threading_;
    std::unique_ptr<dxWorld, WorldDeleter> world_;
};

/// Declare it after its world, so that it is destroyed first.
using JointGroup = std::unique_ptr<dxJointGroup, JointGroupDeleter>;

inline Vec3 to_vec3(const dReal* v) {
    return {v[0], v[1], v[2]};
}

}  // namespace carom::sim::ode
