// RAII owners of ODE's handles. Private to sim/ode.
#pragma once

#include <memory>

#include <ode/ode.h>

#include "core/error.h"
#include "sim/motion/rigid_body.h"

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

inline void set_state(dBodyID body, const MotionState& state) {
    const Vec3& p = state.position;
    const Quat& o = state.orientation;
    const Vec3& v = state.velocity;
    const Vec3& w = state.angular_velocity;
    const dQuaternion q = {o.r, o.v.x, o.v.y, o.v.z};
    dBodySetPosition(body, p.x, p.y, p.z);
    dBodySetQuaternion(body, q);
    dBodySetLinearVel(body, v.x, v.y, v.z);
    dBodySetAngularVel(body, w.x, w.y, w.z);
}

inline void set_mass(dBodyID body, const RigidBody& from) {
    dMass mass;
    dMassSetParameters(&mass, from.mass, 0, 0, 0, from.inertia.x, from.inertia.y, from.inertia.z, 0,
                       0, 0);
    dBodySetMass(body, &mass);
}

inline Vec3 to_vec3(const dReal* v) {
    return {v[0], v[1], v[2]};
}

}  // namespace carom::sim::ode
