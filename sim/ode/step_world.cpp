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
// Friction is stiffer, because what friction holds creeps by its softness.
constexpr double kFrictionSoftness = 0.1;
// If ODE fails to solve a step, it is tried again, each time ten times softer.
constexpr int kMaxAttempts = 4;
// Every contact separates at about this speed (m/s), each at a different one. Bodies that fall
// together have no relative acceleration; where that is exactly zero, ODE's pivoting (Dantzig's, as
// in Baraff, Fast contact force computation for nonpenetrating rigid bodies, 1994) finds a step of
// length zero and fails. The resulting motion is negligible against the margins.
constexpr double kSeparationSpeed = 1e-7;
/// Bodies that turn on each other more slowly than this (rad/s) do not roll: rounding.
constexpr double kMinRolling = 1e-9;
constexpr double kGoldenRatio = 0.6180339887498949;

/// Friction leaves a thousandth of a velocity in each step. Where that comes to the smallest
/// numbers there are, ODE finds steps of length zero and fails.
Vec3 without_traces(Vec3 velocity) {
    constexpr double kTrace = 1e-100;  // m/s or rad/s
    for (int i = 0; i < 3; ++i) {
        velocity[i] = std::abs(velocity[i]) < kTrace ? 0 : velocity[i];
    }
    return velocity;
}

/// The speed (m/s) at which a contact may close after the midpoint of a step; if negative, at which
/// it has to open.
///
/// A gap may close by the middle of the next step, but no further: if it closed within this step,
/// it would open again half a step later, and so on. Where the bodies turn, as at a box that tips
/// over an edge or a coin that rolls, the contact closes as fast as turning has opened it, or the
/// reverse: then its force does no work, and the end of the step is the start reflected in the
/// normal, on the same curve, with the same gap. Turning has changed the gap at the midpoint by a
/// quarter of its speed times the duration.
double closing_speed(const StepContact& contact, double duration) {
    const double opening = contact.turning.dot(contact.normal);
    const double gap_at_start = -contact.depth - 0.25 * opening * duration;
    return std::max(gap_at_start, 0.0) / duration + opening;
}

/// The motion of the first body of a contact relative to the second.
struct RelativeMotion {
    Vec3 velocity{0, 0, 0};  // at the contact
    Vec3 turning{0, 0, 0};   // angular

    /// The slip that friction acts against. A contact that does not slip at the ends of a step
    /// slips at its midpoint if the bodies turn: by as much before the change of velocities as
    /// backwards after it.
    [[nodiscard]] Vec3 slip(const StepContact& contact) const {
        return across(velocity + contact.turning, contact.normal);
    }
};

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
    std::vector<Vec3> directions;  // per contact: of friction, or the axis of rolling
    /// How a contact resists rolling.
    struct Rolling {
        bool is_resisted = false;
        double slip_speed = 0;  // m/s; a body that slips as fast has no rolling resistance yet
        bool may_stop = false;  // within the step: it is held about all axes
        Vec3 turning{0, 0,
                     0};  // relative angular velocity across the normal at the midpoint, rad/s
    };
    std::vector<Rolling> rolling;  // per contact
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
    void select(std::span<const int> moving);
    void prepare(const StepProblem& problem);
    [[nodiscard]] bool solve(const Attempt& attempt, const StepProblem& problem);
    template <class VelocitiesOf>
    [[nodiscard]] RelativeMotion relative_motion(const StepContact& contact,
                                                 std::span<const MotionState> states,
                                                 const VelocitiesOf& velocities_of) const;
    void find_directions(const StepProblem& problem);
    void add_contact(const StepContact& from, std::size_t number, const Attempt& attempt,
                     double duration);
    [[nodiscard]] bool update_directions(const StepProblem& problem,
                                         const std::vector<Velocities>& after);
    void solve_with_directions(const StepProblem& problem, std::vector<Velocities>& after);
    void solve_all(const StepProblem& problem, std::vector<Velocities>& after,
                   std::vector<ImpulsePair>& impulses);
    void add_works(const StepProblem& problem, std::vector<StepMotion>& motions) const;
    [[nodiscard]] Vec3 force_of(std::size_t number, const StepContact& contact) const;
    [[nodiscard]] Vec3 moment_of(std::size_t number, const StepContact& contact,
                                 std::span<const MotionState> states) const;
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

/// `velocities_of` takes the number of a moving body and its index among the moving ones.
template <class VelocitiesOf>
RelativeMotion StepWorld::State::relative_motion(const StepContact& contact,
                                                 std::span<const MotionState> states,
                                                 const VelocitiesOf& velocities_of) const {
    RelativeMotion relative;
    for (const auto& [number, sign] : {std::pair(contact.first, 1.0), {contact.second, -1.0}}) {
        if (moving_body(number) == nullptr) {
            continue;
        }
        const auto slot = static_cast<std::size_t>(slots[static_cast<std::size_t>(number)]);
        const Velocities v = velocities_of(number, slot);
        const Vec3 arm = contact.point - states[slot].position;
        relative.velocity += (v.linear + v.angular.cross(arm)) * sign;
        relative.turning += v.angular * sign;
    }
    return relative;
}

/// The friction pyramid is exact along its direction, which is that of the slip without contacts.
/// Where bodies roll it is the axis of rolling.
void StepWorld::State::find_directions(const StepProblem& problem) {
    directions.clear();
    rolling.clear();
    const std::span<const MotionState> states = problem.midpoints;
    const Vec3 velocity_by_gravity = problem.gravity * problem.duration;
    const double fall = length(velocity_by_gravity);
    const auto velocities_of = [&](int number, std::size_t slot) {
        return Velocities{states[slot].velocity + velocity_by_gravity * gravity_factor(number),
                          states[slot].angular_velocity};
    };
    for (const StepContact& contact : problem.contacts) {
        const RelativeMotion relative = relative_motion(contact, states, velocities_of);
        const Vec3 slip = relative.slip(contact);
        directions.push_back(direction_across(slip, contact.normal, kMinStepSlip));
        Rolling& rolls = rolling.emplace_back();
        rolls.slip_speed = 4 * contact.friction * fall + 1e-6;
        rolls.is_resisted = contact.rolling_arm > 0 && length(slip) < rolls.slip_speed;
        if (!rolls.is_resisted) {
            continue;
        }
        rolls.turning = across(relative.turning, contact.normal);
        const Vec3 gain = contact.normal.cross(slip) / contact.rolling_length;
        // The resistance takes at most arm * fall / (R * rolling_length) of it, R the radius.
        const double most =
            3 * contact.rolling_arm * fall / (contact.rolling_length * contact.rolling_length);
        rolls.may_stop = length(rolls.turning + gain) < most;
        const Vec3 axis = rolls.turning + gain * (rolls.may_stop ? 1 : 0.5);
        if (contact.rolling_axis != Vec3(0, 0, 0)) {
            directions.back() = contact.rolling_axis;
        } else if (const double rate = length(axis); rate > kMinRolling) {
            directions.back() = axis / rate;
        }
    }
}

void StepWorld::State::add_contact(const StepContact& from, std::size_t number,
                                   const Attempt& attempt, double duration) {
    dBodyID first = moving_body(from.first);
    dBodyID second = moving_body(from.second);
    const Vec3& direction = directions[number];
    dContact contact{};
    dSurfaceParameters& surface = contact.surface;
    surface.mode = dContactSoftERP | dContactSoftCFM | dContactApprox1 | dContactFDir1 |
                   dContactMotionN | dContactMotion1 | dContactMotion2 | dContactSlip1 |
                   dContactSlip2;
    surface.mu = attempt.has_friction() ? from.friction : 0;
    surface.soft_erp = std::min(kErrorReduction, kErrorRate * duration);
    double inverse_mass = 0;
    for (const int body : {from.first, from.second}) {
        if (moving_body(body) != nullptr && !is_kinematic(body)) {
            inverse_mass += 1 / properties[static_cast<std::size_t>(body)].body.mass;
        }
    }
    surface.soft_cfm = attempt.softness() * inverse_mass * duration;
    surface.slip1 = surface.slip2 = kFrictionSoftness * surface.soft_cfm;
    surface.motionN = attempt.separation_speed(number) - closing_speed(from, duration);
    // ODE takes a contact without a first body as one of the second, with the opposite normal, but
    // with the same first direction.
    surface.motion1 = -from.turning.dot(direction) * (first != nullptr ? 1 : -1);
    surface.motion2 = -from.turning.dot(from.normal.cross(direction));
    const Rolling& rolls = rolling[number];
    if (attempt.has_friction() && (from.torsional_arm > 0 || rolls.is_resisted)) {
        surface.mode |= dContactRolling | dContactAxisDep;
        surface.mu2 = from.friction;
        // ODE adds a row of zeros for an arm of 0, and none for a negative one.
        const auto arm = [](bool acts, double value) { return acts && value > 0 ? value : -1; };
        // What stops is held about the other axis, too.
        const bool is_held = rolls.may_stop && from.rolling_axis == Vec3(0, 0, 0);
        surface.rho = arm(rolls.is_resisted, from.rolling_arm);
        surface.rho2 = arm(rolls.is_resisted && is_held, from.rolling_arm);
        surface.rhoN = arm(true, from.torsional_arm);
    }
    for (int i = 0; i < 3; ++i) {
        contact.geom.pos[i] = from.point[i];
        contact.geom.normal[i] = from.normal[i];
        contact.fdir1[i] = direction[i];
    }
    contact.geom.depth = std::max(from.depth - kSlop, 0.0);
    dJointID joint = dJointCreateContact(world->get(), group.get(), &contact);
    dJointAttach(joint, first, second);
    dJointSetFeedback(joint, &feedback[number]);
}

void StepWorld::State::select(std::span<const int> moving) {
    is_moving.assign(properties.size(), 0);
    slots.assign(properties.size(), -1);
    for (std::size_t i = 0; i < moving.size(); ++i) {
        is_moving[static_cast<std::size_t>(moving[i])] = 1;
        slots[static_cast<std::size_t>(moving[i])] = static_cast<int>(i);
    }
}

void StepWorld::State::prepare(const StepProblem& problem) {
    for (std::size_t i = 0; i < problem.moving.size(); ++i) {
        const dBodyID body = bodies[static_cast<std::size_t>(problem.moving[i])];
        CAROM_ASSERT(is_finite(problem.midpoints[i]));
        set_state(body, problem.midpoints[i]);
        dBodyEnable(body);
    }
    feedback.assign(problem.contacts.size(), dJointFeedback{});
    const Vec3& gravity = problem.gravity;
    dWorldSetGravity(world->get(), gravity.x, gravity.y, gravity.z);
}

bool StepWorld::State::solve(const Attempt& attempt, const StepProblem& problem) {
    prepare(problem);
    for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
        const StepContact& contact = problem.contacts[i];
        CAROM_ASSERT(moving_body(contact.first) != nullptr ||
                     moving_body(contact.second) != nullptr);
        add_contact(contact, i, attempt, problem.duration);
    }
    MessageCapture capture;
    try {
        dWorldStep(world->get(), problem.duration);
    } catch (const Error& error) {
        rebuild();
        capture.add_message(error.what());
    }
    if (!capture.messages().empty() && attempt.number + 1 == kMaxAttempts) {
        capture.forward();
    }
    return capture.messages().empty();
}

/// On the first body, N.
Vec3 StepWorld::State::force_of(std::size_t number, const StepContact& contact) const {
    return moving_body(contact.first) != nullptr ? to_vec3(feedback[number].f1)
                                                 : -to_vec3(feedback[number].f2);
}

/// The moment against rolling and turning, on the first body, N m.
Vec3 StepWorld::State::moment_of(std::size_t number, const StepContact& contact,
                                 std::span<const MotionState> states) const {
    const bool is_on_first = moving_body(contact.first) != nullptr;
    const int body = is_on_first ? contact.first : contact.second;
    const auto slot = static_cast<std::size_t>(slots[static_cast<std::size_t>(body)]);
    const Vec3 about_centre =
        is_on_first ? to_vec3(feedback[number].t1) : -to_vec3(feedback[number].t2);
    return about_centre - (contact.point - states[slot].position).cross(force_of(number, contact));
}

void StepWorld::State::solve_with_directions(const StepProblem& problem,
                                             std::vector<Velocities>& after) {
    for (Attempt attempt; attempt.number < kMaxAttempts; ++attempt.number) {
        dJointGroupEmpty(group.get());
        if (solve(attempt, problem)) {
            break;
        }
    }
    after.resize(problem.moving.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        const dBodyID body = bodies[static_cast<std::size_t>(problem.moving[i])];
        after[i] = {without_traces(to_vec3(dBodyGetLinearVel(body))),
                    without_traces(to_vec3(dBodyGetAngularVel(body)))};
        dBodyDisable(body);
    }
}

/// Where a contact begins to slip or changes the direction of its slip, the friction direction has
/// to follow: a misaligned friction pyramid pushes bodies sideways. Likewise the axis of rolling. A
/// body that is held about two axes by more than the bound, both together, rolls about the axis of
/// their sum. True if any direction changed.
bool StepWorld::State::update_directions(const StepProblem& problem,
                                         const std::vector<Velocities>& after) {
    constexpr double kSlip = 1e-5;          // m/s
    constexpr double kMaxDeviation = 0.02;  // sine of the angle
    constexpr double kBeyond = 1.001;       // of the bound: not by rounding
    bool is_changed = false;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const StepContact& contact = problem.contacts[i];
        const RelativeMotion relative = relative_motion(
            contact, problem.midpoints, [&](int, std::size_t slot) { return after[slot]; });
        Rolling& rolls = rolling[i];
        const Vec3 slip = relative.slip(contact);
        const double speed = length(slip);
        rolls.is_resisted = rolls.is_resisted && speed < rolls.slip_speed;
        const bool may_turn = rolls.is_resisted && contact.rolling_axis == Vec3(0, 0, 0);
        Vec3 direction(0, 0, 0);
        if (may_turn && rolls.may_stop) {
            const Vec3 moment = across(moment_of(i, contact, problem.midpoints), contact.normal);
            const double bound = contact.rolling_arm * force_of(i, contact).dot(contact.normal);
            if (length(moment) > kBeyond * bound) {
                direction = moment;
                rolls.may_stop = false;
            }
        } else if (may_turn) {
            direction = rolls.turning + across(relative.turning, contact.normal);
        } else if (!rolls.is_resisted && contact.friction > 0 && speed >= kSlip) {
            direction = slip;
        }
        const double size = length(direction);
        if (size > kMinRolling && length(direction.cross(directions[i])) >= kMaxDeviation * size) {
            directions[i] = direction / size;
            is_changed = true;
        }
    }
    return is_changed;
}

void StepWorld::State::solve_all(const StepProblem& problem, std::vector<Velocities>& after,
                                 std::vector<ImpulsePair>& impulses) {
    select(problem.moving);
    find_directions(problem);
    solve_with_directions(problem, after);
    if (update_directions(problem, after)) {
        solve_with_directions(problem, after);
    }
    dJointGroupEmpty(group.get());
    impulses.resize(problem.contacts.size());
    for (std::size_t i = 0; i < impulses.size(); ++i) {
        const StepContact& contact = problem.contacts[i];
        const Vec3 impulse = force_of(i, contact) * problem.duration;
        impulses[i] = {impulse.dot(contact.normal), length(across(impulse, contact.normal))};
    }
}

/// The work of a kinematic body is that against the forces on it, which keep its velocities.
void StepWorld::State::add_works(const StepProblem& problem,
                                 std::vector<StepMotion>& motions) const {
    const auto add = [&](int number, const dReal* force, const dReal* torque) {
        if (moving_body(number) != nullptr && is_kinematic(number)) {
            const auto slot = static_cast<std::size_t>(slots[static_cast<std::size_t>(number)]);
            const MotionState& kept = motions[slot].after;
            motions[slot].work -=
                (to_vec3(force).dot(kept.velocity) + to_vec3(torque).dot(kept.angular_velocity)) *
                problem.duration;
        }
    };
    for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
        add(problem.contacts[i].first, feedback[i].f1, feedback[i].t1);
        add(problem.contacts[i].second, feedback[i].f2, feedback[i].t2);
    }
}

void StepWorld::step(const StepProblem& problem, std::vector<StepMotion>& motions,
                     std::vector<ImpulsePair>& impulses) {
    std::vector<Velocities> after;
    state_->solve_all(problem, after, impulses);
    motions.resize(problem.moving.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
        StepMotion& motion = motions[i];
        motion.work = 0;
        motion.after = problem.midpoints[i];
        motion.after.velocity = after[i].linear;
        motion.after.angular_velocity = after[i].angular;
        const auto number = static_cast<std::size_t>(problem.moving[i]);
        motion.end =
            drift(motion.after, state_->properties[number].body.inertia, 0.5 * problem.duration);
    }
    state_->add_works(problem, motions);
}

}  // namespace carom::sim::ode
