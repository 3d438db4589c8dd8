#include "sim/ode/impact_solver.h"

#include "core/assert.h"
#include "core/length.h"
#include "core/rigid.h"
#include "sim/numeric/tolerances.h"
#include "sim/ode/handles.h"

namespace carom::sim::ode {
namespace {

// Impulses do not depend on the step; a power of two keeps the products with it exact.
constexpr double kStep = 1.0 / 1024;

void load(dBodyID body, const RigidBody& from) {
    set_mass(body, from);
    set_state(body, from.state);
}

Velocities velocities_of(dBodyID body) {
    return {to_vec3(dBodyGetLinearVel(body)), to_vec3(dBodyGetAngularVel(body))};
}

dContact contact_of(const Contact& from, double restitution, double friction,
                    const Vec3& relative_velocity) {
    dContact contact{};
    contact.surface.mode =
        dContactBounce | dContactSoftERP | dContactSoftCFM | dContactApprox1 | dContactFDir1;
    contact.surface.mu = friction;
    contact.surface.bounce = restitution;
    const Vec3 direction = direction_across(relative_velocity, from.normal, kMinImpactSlip);
    for (int i = 0; i < 3; ++i) {
        contact.geom.pos[i] = from.point[i];
        contact.geom.normal[i] = from.normal[i];
        contact.fdir1[i] = direction[i];
    }
    return contact;
}

void measure_impulse(const RigidBody& first, const Vec3& normal, ImpactResult& result) {
    const Vec3 impulse = (result.first.linear - first.state.velocity) * first.mass;
    result.impulse.normal = impulse.dot(normal);
    result.impulse.tangential = length(impulse - normal * result.impulse.normal);
}

}  // namespace

// Members are destroyed in reverse order: the joints before their world.
struct ImpactSolver::State {
    World world;
    JointGroup contacts{dJointGroupCreate(0)};
    dBodyID first = dBodyCreate(world.get());
    dBodyID second = dBodyCreate(world.get());

    void step(const dContact& contact, dBodyID other) {
        dJointAttach(dJointCreateContact(world.get(), contacts.get(), &contact), first, other);
        dWorldStep(world.get(), kStep);
        dJointGroupEmpty(contacts.get());
    }
};

ImpactSolver::ImpactSolver() : state_(std::make_unique<State>()) {
    dWorldSetCFM(state_->world.get(), 0);
    dWorldSetERP(state_->world.get(), 0);
    for (dBodyID body : {state_->first, state_->second}) {
        dBodySetGyroscopicMode(body, 0);
    }
}

ImpactSolver::~ImpactSolver() = default;

ImpactResult ImpactSolver::solve(const RigidBody& first, const RigidBody& second,
                                 const Contact& contact, double restitution, double friction) {
    const Vec3 relative =
        velocity_at(first.state, contact.point) - velocity_at(second.state, contact.point);
    CAROM_ASSERT(relative.dot(contact.normal) < 0);
    load(state_->first, first);
    load(state_->second, second);
    dBodyEnable(state_->second);
    state_->step(contact_of(contact, restitution, friction, relative), state_->second);
    ImpactResult result;
    result.first = velocities_of(state_->first);
    result.second = velocities_of(state_->second);
    measure_impulse(first, contact.normal, result);
    return result;
}

ImpactResult ImpactSolver::solve_static(const RigidBody& first, const Contact& contact,
                                        double restitution, double friction) {
    const Vec3 relative = velocity_at(first.state, contact.point);
    CAROM_ASSERT(relative.dot(contact.normal) < 0);
    load(state_->first, first);
    dBodyDisable(state_->second);
    state_->step(contact_of(contact, restitution, friction, relative), nullptr);
    ImpactResult result;
    result.first = velocities_of(state_->first);
    measure_impulse(first, contact.normal, result);
    return result;
}

ImpactResult ImpactSolver::solve_kinematic(const RigidBody& first, const Vec3& velocity,
                                           const Contact& contact, double restitution,
                                           double friction) {
    RigidBody relative = first;
    relative.state.velocity -= velocity;
    ImpactResult result = solve_static(relative, contact, restitution, friction);
    result.first.linear += velocity;
    return result;
}

}  // namespace carom::sim::ode
