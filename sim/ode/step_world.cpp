#include "sim/ode/step_world.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/error.h"
#include "core/finite.h"
#include "core/length.h"
#include "core/rigid.h"
#include "sim/motion/free_rotation.h"
#include "sim/numeric/tolerances.h"
#include "sim/ode/handles.h"
#include "sim/ode/process.h"

namespace carom::sim::ode {
namespace {

// Penetration of lasting contacts is reduced at this rate (1/s) times the depth, up to the given
// fraction per step and speed.
constexpr double kErrorRate = 200;
constexpr double kErrorReduction = 0.2;
constexpr double kCorrectingSpeed = 0.1;  // m/s
// ODE's constraint force mixing, as a fraction of the inverse mass at a contact: it distributes the
// load, and the friction, among redundant contacts. Without it rounding decides, which turns
// bodies.
constexpr double kSoftness = 1e-3;
// If ODE fails to solve a step, it is tried again, each time ten times softer.
constexpr int kMaxAttempts = 4;
// Every contact separates at about this speed (m/s), each at a different one. Bodies that fall
// together have no relative acceleration; where that is exactly zero, ODE's pivoting (Dantzig's, as
// in Baraff, Fast contact force computation for nonpenetrating rigid bodies, 1994) finds a step of
// length zero and fails. The resulting motion is negligible against the margins.
constexpr double kSeparationSpeed = 1e-7;
constexpr double kGoldenRatio = 0.6180339887498949;

Vec3 velocity_at(dBodyID body, const Vec3& point) {
    dVector3 v = {0, 0, 0, 0};
    dBodyGetPointVel(body, point.x, point.y, point.z, v);
    return to_vec3(v);
}

Vec3 velocity_at(const MotionState& state, const Velocities& velocities, const Vec3& point) {
    return velocities.linear + velocities.angular.cross(point - state.position);
}

/// The speed (m/s) at which a contact may close after the midpoint of a step.
///
/// A gap may close by the middle of the next step, but no further: if it closed within this step,
/// it would open again half a step later, and so on. Where the normal turns, as at a ball that tips
/// over an edge, it may close as fast as it opened: then its force does no work, and the end of the
/// step is the start reflected in the normal, on the same curve. By the middle of a step that
/// begins without a gap such a contact opens by a quarter of `turning` times the duration, so that
/// three quarters more are allowed.
double closing_speed(const StepContact& contact, double duration) {
    return std::max(-contact.depth / duration + 0.75 * contact.turning, 0.0);
}

struct Attempt {
    int number = 0;

    [[nodiscard]] double softness() const {
        double softness = kSoftness;
        for (int i = 0; i < number; ++i) {
            softness *= 10;
        }
        return softness;
    }
    [[nodiscard]] double separation_speed(std::size_t contact) const {
        const double multiple = kGoldenRatio * static_cast<double>(contact + 1) * (number + 1);
        return kSeparationSpeed * (1 + multiple - std::floor(multiple));
    }
    /// The last attempt omits friction: ODE has never been seen to fail without it.
    [[nodiscard]] bool has_friction() const { return number < kMaxAttempts - 1; }
};

}  // namespace

struct StepWorld::State {
    std::unique_ptr<World> world;
    JointGroup group;
    std::vector<dBodyID> bodies;
    struct Properties {
        RigidBody body;  // its state has no meaning
        bool is_kinematic = false;
    };
    std::vector<Properties> properties;
    std::vector<char> is_moving;
    std::vector<dJointFeedback> feedback;
    std::vector<Vec3> directions;  // of friction, per contact
    std::vector<int> slots;        // per body: its index among the moving ones

    [[nodiscard]] dBodyID moving_body(int number) const {
        if (number < 0) {
            return nullptr;
        }
        const auto i = static_cast<std::size_t>(number);
        return is_moving[i] != 0 ? bodies[i] : nullptr;
    }

    [[nodiscard]] bool is_kinematic(int number) const {
        return properties[static_cast<std::size_t>(number)].is_kinematic;
    }
    [[nodiscard]] double gravity_factor(int number) const { return is_kinematic(number) ? 0 : 1; }

    void rebuild();
    void create(const Properties& from);
    void prepare(std::span<const int> moving, std::span<const MotionState> states,
                 std::span<const StepContact> contacts);
    [[nodiscard]] bool solve(const Attempt& attempt, double duration, const Vec3& gravity,
                             std::span<const int> moving, std::span<const MotionState> states,
                             std::span<const StepContact> contacts);
    void add_contact(const StepContact& from, std::size_t number, const Attempt& attempt,
                     double duration, const Vec3& velocity_by_gravity);
    [[nodiscard]] bool update_friction_directions(std::span<const MotionState> states,
                                                  std::span<const StepContact> contacts,
                                                  const std::vector<Velocities>& after);
    void solve_with_directions(double duration, const Vec3& gravity, std::span<const int> moving,
                               std::span<const MotionState> states,
                               std::span<const StepContact> contacts,
                               std::vector<Velocities>& after);
    void solve_all(double duration, const Vec3& gravity, std::span<const int> moving,
                   std::span<const MotionState> states, std::span<const StepContact> contacts,
                   std::vector<Velocities>& after, std::vector<ImpulsePair>& impulses);
    void add_works(double duration, std::span<const StepContact> contacts,
                   std::vector<StepMotion>& motions) const;
    [[nodiscard]] ImpulsePair impulse_of(const StepContact& contact,
                                         const dJointFeedback& feedback_of_contact,
                                         double duration) const;
};

/// Creates a new world with the same bodies: after ODE has failed in the middle of a step, the old
/// one cannot be trusted.
void StepWorld::State::rebuild() {
    group.reset();
    world = std::make_unique<World>();
    group.reset(dJointGroupCreate(0));
    dWorldSetContactMaxCorrectingVel(world->get(), kCorrectingSpeed);
    bodies.clear();
    for (const Properties& from : properties) {
        create(from);
    }
}

void StepWorld::State::create(const Properties& from) {
    dBodyID body = dBodyCreate(world->get());
    set_mass(body, from.body);
    if (from.is_kinematic) {
        dBodySetKinematic(body);
    }
    dBodySetGyroscopicMode(body, 0);
    dBodyDisable(body);
    bodies.push_back(body);
}

StepWorld::StepWorld() : state_(std::make_unique<State>()) {
    state_->rebuild();
}

StepWorld::~StepWorld() = default;

void StepWorld::add(const RigidBody& body, bool is_kinematic) {
    state_->properties.push_back({body, is_kinematic});
    state_->create(state_->properties.back());
}

void StepWorld::State::add_contact(const StepContact& from, std::size_t number,
                                   const Attempt& attempt, double duration,
                                   const Vec3& velocity_by_gravity) {
    dBodyID first = moving_body(from.first);
    dBodyID second = moving_body(from.second);
    Vec3 relative(0, 0, 0);
    if (first != nullptr) {
        relative +=
            velocity_at(first, from.point) + velocity_by_gravity * gravity_factor(from.first);
    }
    if (second != nullptr) {
        relative -=
            velocity_at(second, from.point) + velocity_by_gravity * gravity_factor(from.second);
    }
    const Vec3 slip = across(relative, from.normal);
    if (number >= directions.size()) {
        // The friction pyramid is exact along its direction.
        directions.push_back(direction_across(relative, from.normal, kLeastStepSlip));
    }
    dContact contact{};
    dSurfaceParameters& surface = contact.surface;
    surface.mode = dContactSoftERP | dContactSoftCFM | dContactApprox1 | dContactFDir1 |
                   dContactMotionN | dContactSlip1 | dContactSlip2;
    surface.mu = attempt.has_friction() ? from.friction : 0;
    surface.soft_erp = std::min(kErrorReduction, kErrorRate * duration);
    double inverse_mass = 0;
    for (const int body : {from.first, from.second}) {
        if (moving_body(body) != nullptr && !is_kinematic(body)) {
            inverse_mass += 1 / properties[static_cast<std::size_t>(body)].body.mass;
        }
    }
    surface.soft_cfm = attempt.softness() * inverse_mass * duration;
    surface.slip1 = surface.slip2 = surface.soft_cfm;
    surface.motionN = attempt.separation_speed(number) - closing_speed(from, duration);
    // A slipping ball has no rolling resistance yet.
    const bool is_rolling = length(slip) < 4 * from.friction * length(velocity_by_gravity) + 1e-6;
    if (attempt.has_friction() &&
        (from.torsional_arm > 0 || (from.rolling_arm > 0 && is_rolling))) {
        surface.mode |= dContactRolling | dContactAxisDep;
        surface.mu2 = from.friction;
        surface.rho = surface.rho2 = is_rolling ? from.rolling_arm : 0;
        surface.rhoN = from.torsional_arm;
    }
    for (int i = 0; i < 3; ++i) {
        contact.geom.pos[i] = from.point[i];
        contact.geom.normal[i] = from.normal[i];
        contact.fdir1[i] = directions[number][i];
    }
    contact.geom.depth = std::max(from.depth - kSlop, 0.0);
    dJointID joint = dJointCreateContact(world->get(), group.get(), &contact);
    dJointAttach(joint, first, second);
    dJointSetFeedback(joint, &feedback[number]);
}

void StepWorld::State::prepare(std::span<const int> moving, std::span<const MotionState> states,
                               std::span<const StepContact> contacts) {
    is_moving.assign(properties.size(), 0);
    slots.assign(properties.size(), -1);
    feedback.assign(contacts.size(), dJointFeedback{});
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const auto number = static_cast<std::size_t>(moving[i]);
        is_moving[number] = 1;
        slots[number] = static_cast<int>(i);
        CAROM_ASSERT(is_finite(states[i]));
        set_state(bodies[number], states[i]);
        dBodyEnable(bodies[number]);
    }
}

bool StepWorld::State::solve(const Attempt& attempt, double duration, const Vec3& gravity,
                             std::span<const int> moving, std::span<const MotionState> states,
                             std::span<const StepContact> contacts) {
    prepare(moving, states, contacts);
    dWorldSetGravity(world->get(), gravity.x, gravity.y, gravity.z);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const StepContact& contact = contacts[i];
        CAROM_ASSERT(moving_body(contact.first) != nullptr ||
                     moving_body(contact.second) != nullptr);
        add_contact(contact, i, attempt, duration, gravity * duration);
    }
    MessageCapture capture;
    try {
        dWorldStep(world->get(), duration);
    } catch (const Error& error) {
        rebuild();
        capture.add_message(error.what());
    }
    if (!capture.messages().empty() && attempt.number + 1 == kMaxAttempts) {
        capture.forward();
    }
    return capture.messages().empty();
}

ImpulsePair StepWorld::State::impulse_of(const StepContact& contact,
                                         const dJointFeedback& feedback_of_contact,
                                         double duration) const {
    const bool is_on_first = moving_body(contact.first) != nullptr;
    const Vec3 force =
        is_on_first ? to_vec3(feedback_of_contact.f1) : -to_vec3(feedback_of_contact.f2);
    const double along = force.dot(contact.normal);
    return {along * duration, length(force - contact.normal * along) * duration};
}

void StepWorld::State::solve_with_directions(double duration, const Vec3& gravity,
                                             std::span<const int> moving,
                                             std::span<const MotionState> states,
                                             std::span<const StepContact> contacts,
                                             std::vector<Velocities>& after) {
    for (Attempt attempt; attempt.number < kMaxAttempts; ++attempt.number) {
        dJointGroupEmpty(group.get());
        if (solve(attempt, duration, gravity, moving, states, contacts)) {
            break;
        }
    }
    after.resize(moving.size());
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const dBodyID body = bodies[static_cast<std::size_t>(moving[i])];
        after[i] = {to_vec3(dBodyGetLinearVel(body)), to_vec3(dBodyGetAngularVel(body))};
        dBodyDisable(body);
    }
}

/// Where a contact begins to slip or changes the direction of its slip, the friction direction has
/// to follow: a misaligned friction pyramid pushes bodies sideways. True if any direction changed.
bool StepWorld::State::update_friction_directions(std::span<const MotionState> states,
                                                  std::span<const StepContact> contacts,
                                                  const std::vector<Velocities>& after) {
    constexpr double kSlip = 1e-5;          // m/s
    constexpr double kMaxDeviation = 0.02;  // sine of the angle
    bool is_changed = false;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const StepContact& contact = contacts[i];
        Vec3 relative(0, 0, 0);
        if (moving_body(contact.first) != nullptr) {
            const auto slot =
                static_cast<std::size_t>(slots[static_cast<std::size_t>(contact.first)]);
            relative += velocity_at(states[slot], after[slot], contact.point);
        }
        if (moving_body(contact.second) != nullptr) {
            const auto slot =
                static_cast<std::size_t>(slots[static_cast<std::size_t>(contact.second)]);
            relative -= velocity_at(states[slot], after[slot], contact.point);
        }
        const Vec3 slip = across(relative, contact.normal);
        if (contact.friction == 0 || length(slip) < kSlip ||
            length(slip.cross(directions[i])) < kMaxDeviation * length(slip)) {
            continue;
        }
        directions[i] = slip / length(slip);
        is_changed = true;
    }
    return is_changed;
}

void StepWorld::State::solve_all(double duration, const Vec3& gravity, std::span<const int> moving,
                                 std::span<const MotionState> states,
                                 std::span<const StepContact> contacts,
                                 std::vector<Velocities>& after,
                                 std::vector<ImpulsePair>& impulses) {
    directions.clear();
    solve_with_directions(duration, gravity, moving, states, contacts, after);
    if (update_friction_directions(states, contacts, after)) {
        solve_with_directions(duration, gravity, moving, states, contacts, after);
    }
    dJointGroupEmpty(group.get());
    impulses.resize(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        impulses[i] = impulse_of(contacts[i], feedback[i], duration);
    }
}

/// The work of a kinematic body is that against the forces on it, which keep its velocities.
void StepWorld::State::add_works(double duration, std::span<const StepContact> contacts,
                                 std::vector<StepMotion>& motions) const {
    const auto add = [&](int number, const dReal* force, const dReal* torque) {
        if (moving_body(number) != nullptr && is_kinematic(number)) {
            const auto slot = static_cast<std::size_t>(slots[static_cast<std::size_t>(number)]);
            const MotionState& kept = motions[slot].after;
            motions[slot].work -=
                (to_vec3(force).dot(kept.velocity) + to_vec3(torque).dot(kept.angular_velocity)) *
                duration;
        }
    };
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        add(contacts[i].first, feedback[i].f1, feedback[i].t1);
        add(contacts[i].second, feedback[i].f2, feedback[i].t2);
    }
}

void StepWorld::step(double duration, const Vec3& gravity, std::span<const int> moving,
                     std::span<const MotionState> midpoints, std::span<const StepContact> contacts,
                     std::vector<StepMotion>& motions, std::vector<ImpulsePair>& impulses) {
    std::vector<Velocities> after;
    state_->solve_all(duration, gravity, moving, midpoints, contacts, after, impulses);
    motions.resize(moving.size());
    for (std::size_t i = 0; i < moving.size(); ++i) {
        StepMotion& motion = motions[i];
        motion.work = 0;
        motion.after = midpoints[i];
        motion.after.velocity = after[i].linear;
        motion.after.angular_velocity = after[i].angular;
        const Vec3& inertia = state_->properties[static_cast<std::size_t>(moving[i])].body.inertia;
        motion.end = drift(motion.after, inertia, 0.5 * duration);
    }
    state_->add_works(duration, contacts, motions);
}

}  // namespace carom::sim::ode
