#include "sim/ode/step_world.h"

#include <algorithm>
#include <cmath>

#include "sim/motion/free_rotation.h"
#include "sim/ode/handles.h"
#include "sim/timeline/assert.h"

namespace carom::sim::ode {
namespace {

// How fast lasting contacts come out of each other: this share of the depth per step, at no more
// than the given speed.
constexpr double kErrorReduction = 0.2;
constexpr double kCorrectingSpeed = 0.1;  // m/s
// ODE's constraint force mixing: shares the load among more contacts than are needed.
constexpr double kSoftness = 1e-6;
// Every contact parts at about this speed (m/s), each at another one. Bodies that fall together
// have no acceleration against each other; where that is exactly zero ODE's pivoting (Dantzig's, as
// in Baraff, Fast contact force computation for nonpenetrating rigid bodies, 1994) finds a step of
// length zero and gives up. What it moves a body by is lost in the margins.
constexpr double kParting = 1e-7;
constexpr double kGoldenRatio = 0.6180339887498949;

double length(const Vec3& v) {
    return std::sqrt(v.dot(v));
}

void load(dBodyID body, const MotionState& state) {
    CAROM_ASSERT(std::isfinite(state.position.x + state.position.y + state.position.z));
    CAROM_ASSERT(std::isfinite(state.velocity.x + state.velocity.y + state.velocity.z));
    const Vec3& p = state.position;
    const Quat& o = state.orientation;
    const dQuaternion q = {o.r, o.v.x, o.v.y, o.v.z};
    dBodySetPosition(body, p.x, p.y, p.z);
    dBodySetQuaternion(body, q);
    dBodySetLinearVel(body, state.velocity.x, state.velocity.y, state.velocity.z);
    dBodySetAngularVel(body, state.angular_velocity.x, state.angular_velocity.y,
                       state.angular_velocity.z);
}

Vec3 velocity_at(dBodyID body, const Vec3& point) {
    dVector3 v = {0, 0, 0, 0};
    dBodyGetPointVel(body, point.x, point.y, point.z, v);
    return to_vec3(v);
}

/// Along the slip that would be there without friction, so that the pyramid is exact along it.
Vec3 friction_direction(const Vec3& slip, const Vec3& normal) {
    const double speed = length(slip);
    if (speed > 1e-12)
        return slip / speed;
    const Vec3 axis = std::abs(normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 across = normal.cross(axis);
    return across / length(across);
}

}  // namespace

struct StepWorld::State {
    World world{dWorldCreate()};
    JointGroup group{dJointGroupCreate(0)};
    std::vector<dBodyID> bodies;
    std::vector<StepBody> masses;
    std::vector<char> is_moving;
    std::vector<char> has_contact;
    std::vector<dJointFeedback> feedback;

    [[nodiscard]] dBodyID moving_body(int number) const {
        if (number < 0)
            return nullptr;
        const auto i = static_cast<std::size_t>(number);
        return is_moving[i] != 0 ? bodies[i] : nullptr;
    }

    void add_contact(const StepContact& from, std::size_t number, double duration, const Vec3& pull,
                     dJointFeedback& result);
};

StepWorld::StepWorld() : state_(std::make_unique<State>()) {
    dWorldID world = state_->world.get();
    dWorldSetContactMaxCorrectingVel(world, kCorrectingSpeed);
}

StepWorld::~StepWorld() = default;

int StepWorld::add(const StepBody& from) {
    dBodyID body = dBodyCreate(state_->world.get());
    dMass mass;
    dMassSetParameters(&mass, from.mass, 0, 0, 0, from.inertia.x, from.inertia.y, from.inertia.z, 0,
                       0, 0);
    dBodySetMass(body, &mass);
    dBodySetGyroscopicMode(body, 0);
    dBodyDisable(body);
    state_->bodies.push_back(body);
    state_->masses.push_back(from);
    return static_cast<int>(state_->bodies.size()) - 1;
}

void StepWorld::State::add_contact(const StepContact& from, std::size_t number, double duration,
                                   const Vec3& pull, dJointFeedback& result) {
    dBodyID first = moving_body(from.first);
    dBodyID second = moving_body(from.second);
    Vec3 relative(0, 0, 0);
    if (first != nullptr)
        relative += velocity_at(first, from.point) + pull;
    if (second != nullptr)
        relative -= velocity_at(second, from.point) + pull;
    const Vec3 slip = relative - from.normal * relative.dot(from.normal);
    const Vec3 direction = friction_direction(slip, from.normal);
    dContact contact{};
    dSurfaceParameters& surface = contact.surface;
    surface.mode = dContactBounce | dContactSoftERP | dContactSoftCFM | dContactApprox1 |
                   dContactFDir1 | dContactMotionN;
    surface.mu = from.friction;
    surface.bounce = from.restitution;
    surface.bounce_vel = kBounceSpeed;
    surface.soft_erp = kErrorReduction;
    surface.soft_cfm = kSoftness;
    // A gap may close within the step, but no further.
    surface.motionN = std::min(from.depth, 0.0) / duration +
                      kParting * (1 + std::fmod(kGoldenRatio * static_cast<double>(number), 1.0));
    // A ball that slips has no rolling resistance yet.
    const bool is_rolling = length(slip) < 4 * from.friction * length(pull) + 1e-6;
    if (from.spinning_lever > 0 || (from.rolling_lever > 0 && is_rolling)) {
        surface.mode |= dContactRolling | dContactAxisDep;
        surface.mu2 = from.friction;
        surface.rho = surface.rho2 = is_rolling ? from.rolling_lever : 0;
        surface.rhoN = from.spinning_lever;
    }
    for (int i = 0; i < 3; ++i) {
        contact.geom.pos[i] = from.point[i];
        contact.geom.normal[i] = from.normal[i];
        contact.fdir1[i] = direction[i];
    }
    contact.geom.depth = std::max(from.depth, 0.0);
    dJointID joint = dJointCreateContact(world.get(), group.get(), &contact);
    dJointAttach(joint, first, second);
    dJointSetFeedback(joint, &result);
}

void StepWorld::step(double duration, const Vec3& gravity, std::span<const int> moving,
                     std::span<const MotionState> states, std::span<const StepContact> contacts,
                     std::vector<StepMotion>& motions, std::vector<StepImpulse>& impulses) {
    State& s = *state_;
    s.is_moving.assign(s.bodies.size(), 0);
    s.has_contact.assign(s.bodies.size(), 0);
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const auto number = static_cast<std::size_t>(moving[i]);
        s.is_moving[number] = 1;
        load(s.bodies[number], states[i]);
        dBodyEnable(s.bodies[number]);
    }
    dWorldSetGravity(s.world.get(), gravity.x, gravity.y, gravity.z);
    s.feedback.assign(contacts.size(), dJointFeedback{});
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const StepContact& contact = contacts[i];
        if (s.moving_body(contact.first) == nullptr && s.moving_body(contact.second) == nullptr)
            continue;
        s.add_contact(contact, i, duration, gravity * duration, s.feedback[i]);
        s.has_contact[static_cast<std::size_t>(contact.first)] = 1;
        if (contact.second >= 0)
            s.has_contact[static_cast<std::size_t>(contact.second)] = 1;
    }
    dWorldStep(s.world.get(), duration);
    motions.resize(moving.size());
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const auto number = static_cast<std::size_t>(moving[i]);
        StepMotion& motion = motions[i];
        motion.before = motion.after = states[i];
        motion.after.velocity = to_vec3(dBodyGetLinearVel(s.bodies[number]));
        motion.after.angular_velocity = to_vec3(dBodyGetAngularVel(s.bodies[number]));
        motion.end = motion.after;
        const Vec3 mean = s.has_contact[number] != 0
                              ? motion.after.velocity
                              : (motion.before.velocity + motion.after.velocity) * 0.5;
        motion.end.position += mean * duration;
        const Rotation turned =
            rotate_freely({states[i].orientation, motion.after.angular_velocity},
                          s.masses[number].inertia, duration);
        motion.end.orientation = turned.orientation;
        motion.end.angular_velocity = turned.angular_velocity;
        dBodyDisable(s.bodies[number]);
    }
    dJointGroupEmpty(s.group.get());
    impulses.resize(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const StepContact& contact = contacts[i];
        const dJointFeedback& f = s.feedback[i];
        const bool is_on_first = s.moving_body(contact.first) != nullptr;
        const Vec3 force = is_on_first ? to_vec3(f.f1) : -to_vec3(f.f2);
        const double along = force.dot(contact.normal);
        impulses[i] = {along * duration, length(force - contact.normal * along) * duration};
    }
}

}  // namespace carom::sim::ode
