#include "sim/impact/group_impact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/assert.h"
#include "core/elementary.h"
#include "core/length.h"

namespace carom::sim {
namespace {

/// Steps in the time of the shortest contact.
constexpr double kStepsPerContact = 100;
/// A body of less restitution would recover at more than a hundred times the speed of compression.
/// Below, the force of recovery is less instead.
constexpr double kLeastRecovery = 0.1;
constexpr int kMaxSteps = 1'000'000;

/// The motion of a body, or its rate of change.
struct Motion {
    Vec3 velocity{0, 0, 0};
    Vec3 angular{0, 0, 0};

    void add(const Motion& other, double factor) {
        velocity += other.velocity * factor;
        angular += other.angular * factor;
    }
};

/// How far the bodies of a contact compress each other, or its rate of change.
struct Compression {
    double depth = 0;  // m; if negative, the gap. Bodies that recover do so faster than they part
    double rise = 0;   // relative vertical velocity that a level contact keeps to itself, m/s

    void add(const Compression& other, double factor) {
        depth += other.depth * factor;
        rise += other.rise * factor;
    }
};

struct State {
    std::vector<Motion> bodies;
    std::vector<Compression> contacts;
    double loss = 0;  // of energy, J
};

/// What does not change while a contact is closed.
struct ContactData {
    Vec3 normal;
    Vec3 first_arm, second_arm;
    double recovery = 1;      // restitution, or the least one with which the bodies recover
    double recovered = 1;     // the part of the force with which they do
    double mass = 0;          // against an impulse along the normal, kg
    double slip_mass = 0;     // against one across it, at least, kg
    double stick_factor = 0;  // greatest friction per slip, kg/s
    double friction = 0;
    double largest_slip = 0;  // since it closed, m/s
    bool is_near = false;     // may close in this step
};

Vec3 point_velocity(const Motion& motion, const Vec3& arm) {
    return motion.velocity + motion.angular.cross(arm);
}

/// Response of a body to an impulse along `direction` at `arm`, 1/kg.
double response(const GroupBody& body, const Vec3& arm, const Vec3& direction) {
    const Vec3 turn = arm.cross(direction);
    return body.inverse_mass + turn.dot(turn * body.inverse_inertia);
}

/// At least the response to an impulse in any direction.
double greatest_response(const GroupBody& body, const Vec3& arm) {
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
        const auto& row = body.inverse_inertia[i];
        largest = std::max(largest, std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]));
    }
    return body.inverse_mass + largest * arm.dot(arm);
}

/// The unit vector between two spheres' centres when they touch, if they fly from `apart` (first
/// minus second) with this relative velocity; if they will not touch, where they are closest.
Vec3 normal_of_approach(const Vec3& apart, const Vec3& velocity, double distance) {
    const double closing = -apart.dot(velocity);
    if (closing <= 0) {
        return unit(apart);
    }
    const double square = velocity.dot(velocity);
    const double beyond = apart.dot(apart) - distance * distance;
    const double root = closing * closing - square * beyond;
    const double time = root > 0 ? beyond / (closing + std::sqrt(root)) : closing / square;
    return unit(apart + velocity * time);
}

class Group {
  public:
    Group(std::vector<GroupBody>& bodies, std::span<const GroupContact> contacts,
          const BallBall& law);

    std::vector<GroupContactResult> run();

  private:
    struct Force {
        double normal = 0;
        Vec3 friction{0, 0, 0};
    };

    void prepare(std::size_t index);
    void choose_step();
    void begin_step();
    void look_at(std::size_t index, double reach);
    void step();
    void find_rates(const State& state, State& rates, double weight);
    Force force_at(std::size_t index, const State& state, State& rates) const;
    [[nodiscard]] Vec3 relative_velocity(std::size_t index, const State& state) const;
    [[nodiscard]] bool is_finished() const;
    [[nodiscard]] double kinetic_energy(const std::vector<Motion>& motions) const;
    void balance_energy();
    void separate();
    void apply(std::size_t index, const Vec3& impulse, std::vector<Motion>& motions) const;

    std::vector<GroupBody>& bodies_;
    std::span<const GroupContact> contacts_;
    const BallBall& law_;
    std::vector<Imath::M33d> inertias_;
    std::vector<ContactData> data_;
    std::vector<double> counts_;  // contacts of each body
    std::vector<GroupContactResult> results_;
    std::vector<Vec3> friction_impulses_;
    std::vector<Motion> start_;
    State state_, trial_;
    std::array<State, 4> rates_;
    double time_ = 0;
    double duration_ = 0;  // of a step
};

Group::Group(std::vector<GroupBody>& bodies, std::span<const GroupContact> contacts,
             const BallBall& law)
    : bodies_(bodies),
      contacts_(contacts),
      law_(law),
      data_(contacts.size()),
      counts_(bodies.size(), 0),
      results_(contacts.size()),
      friction_impulses_(contacts.size(), Vec3(0, 0, 0)) {
    for (const GroupBody& body : bodies) {
        state_.bodies.push_back({body.velocity, body.angular_velocity});
        inertias_.push_back(body.inverse_mass > 0 ? body.inverse_inertia.inverse()
                                                  : Imath::M33d(0.0));
    }
    start_ = state_.bodies;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        prepare(i);
    }
    choose_step();
    trial_ = state_;
    for (State& rates : rates_) {
        rates = state_;
    }
}

void Group::prepare(std::size_t index) {
    const GroupContact& contact = contacts_[index];
    const GroupBody& a = bodies_[contact.first];
    const GroupBody& b = bodies_[contact.second];
    ContactData& data = data_[index];
    CAROM_ASSERT(contact.gap >= 0);
    data.normal = contact.normal;
    data.first_arm = contact.first_arm;
    data.second_arm = contact.second_arm;
    data.recovery = std::max(contact.restitution, kLeastRecovery);
    const double part = contact.restitution / data.recovery;
    data.recovered = part * part;
    data.mass = 1 / (response(a, contact.first_arm, contact.normal) +
                     response(b, contact.second_arm, contact.normal));
    data.slip_mass =
        1 / (greatest_response(a, contact.first_arm) + greatest_response(b, contact.second_arm));
    counts_[contact.first] += a.inverse_mass > 0 ? 1 : 0;
    counts_[contact.second] += b.inverse_mass > 0 ? 1 : 0;
    state_.contacts.push_back({-contact.gap, 0});
}

/// Steps are equal, so that the result changes continuously with the start. A speed that no two
/// bodies have at first is reached only if light ones are hit by heavy ones, and contacts become
/// shorter with its fifth root only.
void Group::choose_step() {
    double speed = 0;
    double recovery = 1;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        speed = std::max(speed, length(relative_velocity(i, state_)));
        recovery = std::min(recovery, data_[i].recovery);
    }
    CAROM_ASSERT(speed > 0);
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        shortest = std::min(shortest, contact_time(contacts_[i].stiffness, data_[i].mass, speed));
    }
    duration_ = shortest * recovery / kStepsPerContact;
    // Friction that stops a slip would overshoot if several contacts of a body stopped it at once.
    // The method follows rates of up to 2.78 per step.
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const double count = std::max(counts_[contacts_[i].first], counts_[contacts_[i].second]);
        data_[i].stick_factor = 1.5 * data_[i].slip_mass / (count * duration_);
    }
}

Vec3 Group::relative_velocity(std::size_t index, const State& state) const {
    const GroupContact& contact = contacts_[index];
    const ContactData& data = data_[index];
    Vec3 relative = point_velocity(state.bodies[contact.first], data.first_arm) -
                    point_velocity(state.bodies[contact.second], data.second_arm);
    relative.z += state.contacts[index].rise;
    return relative;
}

std::vector<GroupContactResult> Group::run() {
    for (int i = 0; i < kMaxSteps; ++i) {
        begin_step();
        step();
        if (is_finished()) {
            break;
        }
    }
    balance_energy();
    separate();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        bodies_[i].velocity = state_.bodies[i].velocity;
        bodies_[i].angular_velocity = state_.bodies[i].angular;
    }
    for (std::size_t i = 0; i < results_.size(); ++i) {
        results_[i].impulse.tangential = length(friction_impulses_[i]);
    }
    return results_;
}

void Group::begin_step() {
    double fastest = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec3& velocity = state_.bodies[i].velocity;
        fastest = std::max(fastest, velocity.dot(velocity));
    }
    const double reach = 4 * std::sqrt(fastest) * duration_;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        look_at(i, reach);
    }
}

/// Which contacts may close in this step, and their normals: those with which the bodies would meet
/// if they flew on from their places before the impact, as they do if the gap is wide. The friction
/// is that at the greatest slip since they met, which for two bodies alone is the first one.
void Group::look_at(std::size_t index, double reach) {
    const GroupContact& contact = contacts_[index];
    ContactData& data = data_[index];
    const bool is_open = state_.contacts[index].depth <= 0;
    if (is_open && contact.are_spheres && contact.gap > 0) {
        const Vec3 velocity =
            state_.bodies[contact.first].velocity - state_.bodies[contact.second].velocity;
        const double first_radius = length(contact.first_arm);
        const double second_radius = length(contact.second_arm);
        data.normal =
            normal_of_approach(contact.normal * (first_radius + second_radius + contact.gap),
                               velocity, first_radius + second_radius);
        data.first_arm = data.normal * -first_radius;
        data.second_arm = data.normal * second_radius;
    }
    data.is_near = state_.contacts[index].depth > -reach;
    if (!data.is_near) {
        return;
    }
    const Vec3 relative = relative_velocity(index, state_);
    const double opening = relative.dot(data.normal);
    const double slip = length(relative - data.normal * opening);
    if (is_open || slip > data.largest_slip) {
        data.largest_slip = slip;
        data.friction = contact.friction ? *contact.friction : ball_friction(law_, slip);
    }
    if (is_open && !results_[index].touched_after) {
        results_[index].approach = -opening;
        results_[index].slip = slip;
        results_[index].normal = data.normal;
    }
}

/// One step of the classical Runge-Kutta method. The impulses are sums of the same forces for both
/// bodies of a contact.
void Group::step() {
    constexpr std::array<double, 4> kWeights{1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    constexpr std::array<double, 4> kAhead{0, 0.5, 0.5, 1};
    for (std::size_t stage = 0; stage < 4; ++stage) {
        trial_ = state_;
        if (stage > 0) {
            const State& rates = rates_[stage - 1];
            for (std::size_t i = 0; i < bodies_.size(); ++i) {
                trial_.bodies[i].add(rates.bodies[i], kAhead[stage] * duration_);
            }
            for (std::size_t i = 0; i < contacts_.size(); ++i) {
                trial_.contacts[i].add(rates.contacts[i], kAhead[stage] * duration_);
            }
        }
        find_rates(trial_, rates_[stage], kWeights[stage] * duration_);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        for (std::size_t stage = 0; stage < 4; ++stage) {
            state_.bodies[i].add(rates_[stage].bodies[i], kWeights[stage] * duration_);
        }
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const bool was_open = state_.contacts[i].depth <= 0;
        for (std::size_t stage = 0; stage < 4; ++stage) {
            state_.contacts[i].add(rates_[stage].contacts[i], kWeights[stage] * duration_);
        }
        if (was_open && state_.contacts[i].depth > 0 && !results_[i].touched_after) {
            results_[i].touched_after = time_;
        }
    }
    time_ += duration_;
}

/// `weight` (s): of these forces in the impulses.
void Group::find_rates(const State& state, State& rates, double weight) {
    std::fill(rates.bodies.begin(), rates.bodies.end(), Motion{});
    rates.loss = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Force force = force_at(i, state, rates);
        if (force.normal > 0) {
            const Vec3 total = data_[i].normal * force.normal + force.friction;
            apply(i, total, rates.bodies);
            results_[i].impulse.normal += force.normal * weight;
            friction_impulses_[i] += force.friction * weight;
        }
    }
    state_.loss += rates.loss * weight;
}

/// The force on the first body, with the rates of the contact and the energy that it takes away.
Group::Force Group::force_at(std::size_t index, const State& state, State& rates) const {
    const GroupContact& contact = contacts_[index];
    const ContactData& data = data_[index];
    const Vec3 relative = relative_velocity(index, state);
    const double opening = relative.dot(data.normal);
    const double depth = state.contacts[index].depth;
    rates.contacts[index] = {-opening, 0};
    if (depth <= 0 || !data.is_near) {
        return {};
    }
    const double e2 = data.recovery * data.recovery;
    const double full =
        contact.stiffness.factor * (contact.stiffness.is_flat ? depth : depth * std::sqrt(depth));
    Force force{full, {0, 0, 0}};
    if (opening > 0) {
        rates.contacts[index].depth = -opening / e2;
        force.normal = full * data.recovered;
    } else {
        rates.loss -= (1 - e2 * data.recovered) * full * opening;
    }
    const Vec3 slip = relative - data.normal * opening;
    const double speed = length(slip);
    const double limit = data.friction * force.normal;
    const double stick = data.stick_factor * speed;
    if (limit > 0 && speed > 0) {
        force.friction = slip * (-std::min(limit, stick) / speed);
        rates.loss -= force.friction.dot(slip);
    }
    if (contact.is_level) {
        const double lift = data.normal.z * force.normal + force.friction.z;
        rates.contacts[index].rise =
            lift * (bodies_[contact.first].inverse_mass + bodies_[contact.second].inverse_mass);
        rates.loss += lift * state.contacts[index].rise;
    }
    return force;
}

/// Adds the change that an impulse on the first body causes.
void Group::apply(std::size_t index, const Vec3& impulse, std::vector<Motion>& motions) const {
    const GroupContact& contact = contacts_[index];
    const GroupBody& a = bodies_[contact.first];
    const GroupBody& b = bodies_[contact.second];
    const Vec3 along = contact.is_level ? Vec3(impulse.x, impulse.y, 0) : impulse;
    motions[contact.first].velocity += along * a.inverse_mass;
    motions[contact.second].velocity -= along * b.inverse_mass;
    motions[contact.first].angular += data_[index].first_arm.cross(impulse) * a.inverse_inertia;
    motions[contact.second].angular -= data_[index].second_arm.cross(impulse) * b.inverse_inertia;
}

/// True if no contact pushes any more. One that does not recover neither pushes nor opens.
bool Group::is_finished() const {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        if (state_.contacts[i].depth <= 0) {
            continue;
        }
        if (data_[i].recovered > 0 || relative_velocity(i, state_).dot(data_[i].normal) < 0) {
            return false;
        }
    }
    return true;
}

double Group::kinetic_energy(const std::vector<Motion>& motions) const {
    double energy = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i].inverse_mass > 0) {
            const Motion& motion = motions[i];
            energy += 0.5 * (motion.velocity.dot(motion.velocity) / bodies_[i].inverse_mass +
                             motion.angular.dot(motion.angular * inertias_[i]));
        }
    }
    return energy;
}

/// Projects the velocities onto the balance of energy, from which the steps deviate by about a
/// millionth (Hairer, Lubich and Wanner, Geometric Numerical Integration, 2006, section IV.4). All
/// impulses are multiplied by one factor, which keeps the momentum. Where nothing recovers, that
/// factor has no effect on the energy and stays 1.
void Group::balance_energy() {
    constexpr double kLeastEffect = 0.01;
    const double wanted = kinetic_energy(start_) - state_.loss;
    for (int pass = 0; pass < 3; ++pass) {
        double effect = 0;  // of the factor on the energy
        double change = 0;
        std::vector<Motion> changes = state_.bodies;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            changes[i].add(start_[i], -1);
            if (bodies_[i].inverse_mass > 0) {
                const double mass = 1 / bodies_[i].inverse_mass;
                const Vec3 turn = changes[i].angular * inertias_[i];
                effect += mass * state_.bodies[i].velocity.dot(changes[i].velocity) +
                          state_.bodies[i].angular.dot(turn);
                change += mass * changes[i].velocity.dot(changes[i].velocity) +
                          changes[i].angular.dot(turn);
            }
        }
        const double least = kLeastEffect * change;
        const double scale = effect * effect + least * least;
        if (scale <= 0) {
            return;
        }
        const double extra = (wanted - kinetic_energy(state_.bodies)) * effect / scale;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            state_.bodies[i].add(changes[i], extra);
        }
        for (std::size_t i = 0; i < results_.size(); ++i) {
            results_[i].impulse.normal *= 1 + extra;
            friction_impulses_[i] *= 1 + extra;
        }
    }
}

/// Bodies that touched when the impact began and pushed each other come apart at kLeastSeparation
/// or faster.
void Group::separate() {
    constexpr int kMaxPasses = 100;
    for (Compression& contact : state_.contacts) {
        contact.rise = 0;
    }
    for (int pass = 0; pass < kMaxPasses; ++pass) {
        std::vector<Motion> next = state_.bodies;
        bool is_done = true;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const GroupContact& contact = contacts_[i];
            const double opening = relative_velocity(i, state_).dot(data_[i].normal);
            if (contact.gap > 0 || results_[i].impulse.normal <= 0 || opening < -kLeastSeparation ||
                opening >= kLeastSeparation * (1 - 1e-6)) {
                continue;
            }
            is_done = false;
            const double impulse = data_[i].mass * (kLeastSeparation - opening) /
                                   std::max(counts_[contact.first], counts_[contact.second]);
            apply(i, data_[i].normal * impulse, next);
            results_[i].impulse.normal += impulse;
        }
        if (is_done) {
            break;
        }
        state_.bodies = next;
    }
}

}  // namespace

GroupBody group_body(const BallBody& ball) {
    GroupBody body;
    body.inverse_mass = 1 / ball.mass;
    body.inverse_inertia = Imath::M33d() * (2.5 / (ball.mass * ball.radius * ball.radius));
    body.velocity = ball.state.velocity;
    body.angular_velocity = ball.state.angular_velocity;
    return body;
}

ContactStiffness hertz_stiffness(double reduced_modulus, double reduced_radius) {
    return {4.0 / 3 * reduced_modulus * std::sqrt(reduced_radius), false};
}

double contact_time(const ContactStiffness& stiffness, double reduced_mass, double speed) {
    if (stiffness.is_flat) {
        constexpr double kPi = 3.14159265358979323846;
        return kPi * std::sqrt(reduced_mass / stiffness.factor);
    }
    const double depth = power(5 * reduced_mass * speed * speed / (4 * stiffness.factor), 0.4);
    return 2.943275 * depth / speed;
}

std::vector<GroupContactResult> group_impact(std::vector<GroupBody>& bodies,
                                             std::span<const GroupContact> contacts,
                                             const BallBall& law) {
    return Group(bodies, contacts, law).run();
}

}  // namespace carom::sim
