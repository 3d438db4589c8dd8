#include "sim/impact/group_impact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/assert.h"
#include "core/length.h"
#include "core/rigid.h"

namespace carom::sim {
namespace {

/// A body of less restitution would recover at more than a hundred times the speed of compression.
/// Below, the force of recovery is less instead.
constexpr double kMinRecovery = 0.1;
/// An impact without end has a body that keeps its velocity.
constexpr int kMaxSteps = 20'000;
constexpr int kMaxFreeSteps = 1'000'000;

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

/// A value at the beginning of a step, at the present stage and, so far, at its end.
template <class Value>
struct Stepped {
    Value start, now, end;

    void begin() { now = end = start; }
    void follow(const Value& rate, double ahead, double weight) {
        end.add(rate, weight);
        now = start;
        now.add(rate, ahead);
    }
    void finish() { start = end; }
};

struct Load {
    Vec3 force{0, 0, 0};
    Vec3 torque{0, 0, 0};
};

struct ContactData {
    Vec3 normal;
    Vec3 first_arm, second_arm;
    double recovery = 1;      // restitution, or the least one with which the bodies recover
    double recovered = 1;     // the part of the force with which they do
    double mass = 0;          // against an impulse along the normal, kg
    double slight_depth = 0;  // of bodies that met at the least speed that counts, m
    double slip_mass = 0;     // against one across it, at least, kg
    double stick_factor = 0;  // greatest friction per slip, kg/s
    double friction = 0;
    double largest_slip = 0;  // since it closed, m/s
    double opening = 0;       // speed when the step began, m/s
    bool is_near = false;     // may push in this step, or be pushed
    Vec3 friction_impulse{0, 0, 0};
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

Imath::M33d inverse_inertia_in_world(const RigidBody& body) {
    Imath::M33d sum(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 own(0, 0, 0);
        own[axis] = 1;
        const Vec3 direction = to_world(body.state.orientation, own);
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                sum[i][k] += direction[i] * direction[k] / body.inertia[axis];
            }
        }
    }
    return sum;
}

class Group {
  public:
    Group(std::vector<GroupBody>& bodies, std::span<const GroupContact> contacts,
          const BallBall& law, const GroupPrecision& precision);

    std::vector<GroupContactResult> run();

  private:
    void prepare(std::size_t index);
    void choose_step();
    void begin_step();
    void find_near();
    void look_at(std::size_t index);
    void measure_slip(std::size_t index);
    void turn_to_approach(std::size_t index);
    void step();
    void follow_stage(double ahead, double weight);
    Compression press(std::size_t index, double weight);
    [[nodiscard]] double acting_part(const ContactData& data, double full_force,
                                     double opening) const;
    void add_load(std::size_t index, const Vec3& force);
    [[nodiscard]] Vec3 relative_velocity(std::size_t index) const;
    [[nodiscard]] bool is_finished() const;
    [[nodiscard]] double kinetic_energy() const;
    void balance_energy(double wanted);
    bool balance_once(double wanted);
    void separate();

    std::vector<GroupBody>& bodies_;
    std::span<const GroupContact> contacts_;
    const BallBall& law_;
    GroupPrecision precision_;
    std::vector<Imath::M33d> inertias_;
    std::vector<Stepped<Motion>> motions_;
    std::vector<Load> loads_;
    std::vector<double> counts_;       // contacts of each body
    std::vector<char> is_pushed_;      // each body, in this step
    std::vector<std::size_t> pushed_;  // those bodies
    std::vector<std::size_t> near_;    // contacts that are followed in this step
    std::vector<ContactData> data_;
    std::vector<Stepped<Compression>> compressions_;
    std::vector<GroupContactResult> results_;
    double loss_ = 0;  // of energy, J
    double work_ = 0;  // of the bodies that keep their velocities, J
    int max_steps_ = kMaxFreeSteps;
    double time_ = 0;
    double duration_ = 0;  // of a step
    double outlook_ = 0;   // how far ahead contacts have to stay open for the impact to end, s
};

Group::Group(std::vector<GroupBody>& bodies, std::span<const GroupContact> contacts,
             const BallBall& law, const GroupPrecision& precision)
    : bodies_(bodies),
      contacts_(contacts),
      law_(law),
      precision_(precision),
      motions_(bodies.size()),
      loads_(bodies.size()),
      counts_(bodies.size(), 0),
      is_pushed_(bodies.size(), 1),
      data_(contacts.size()),
      compressions_(contacts.size()),
      results_(contacts.size()) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const GroupBody& body = bodies[i];
        motions_[i].start = {body.velocity, body.angular_velocity};
        motions_[i].begin();
        inertias_.push_back(body.inverse_mass > 0 ? body.inverse_inertia.inverse()
                                                  : Imath::M33d(0.0));
        if (body.inverse_mass <= 0 &&
            (body.velocity != Vec3(0, 0, 0) || body.angular_velocity != Vec3(0, 0, 0))) {
            max_steps_ = kMaxSteps;
        }
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        prepare(i);
    }
    choose_step();
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
    data.recovery = std::max(contact.restitution, kMinRecovery);
    const double part = contact.restitution / data.recovery;
    data.recovered = part * part;
    data.mass = 1 / (response(a, contact.first_arm, contact.normal) +
                     response(b, contact.second_arm, contact.normal));
    data.slight_depth = greatest_depth(contact.stiffness, data.mass, precision_.end_speed);
    data.slip_mass =
        1 / (greatest_response(a, contact.first_arm) + greatest_response(b, contact.second_arm));
    counts_[contact.first] += a.inverse_mass > 0 ? 1 : 0;
    counts_[contact.second] += b.inverse_mass > 0 ? 1 : 0;
    compressions_[index].start.depth = -contact.gap;
    compressions_[index].begin();
}

/// Steps are equal, so that the result changes continuously with the start. A speed that no two
/// bodies have at first is reached only if light ones are hit by heavy ones, and contacts become
/// shorter with its fifth root only.
void Group::choose_step() {
    double speed = 0;
    double recovery = 1;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        speed = std::max(speed, length(relative_velocity(i)));
        recovery = std::min(recovery, data_[i].recovery);
    }
    CAROM_ASSERT(speed > 0);
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        shortest = std::min(shortest, contact_time(contacts_[i].stiffness, data_[i].mass, speed));
    }
    outlook_ = shortest * recovery;
    duration_ =
        std::min(outlook_ / precision_.recovery_steps, shortest / precision_.compression_steps);
    // Friction that stops a slip would overshoot if several contacts of a body stopped it at once.
    // The method follows rates of up to 2.78 per step.
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const double count = std::max(counts_[contacts_[i].first], counts_[contacts_[i].second]);
        data_[i].stick_factor = 1.5 * data_[i].slip_mass / (count * duration_);
    }
}

Vec3 Group::relative_velocity(std::size_t index) const {
    const GroupContact& contact = contacts_[index];
    const ContactData& data = data_[index];
    Vec3 relative = point_velocity(motions_[contact.first].now, data.first_arm) -
                    point_velocity(motions_[contact.second].now, data.second_arm);
    relative.z += compressions_[index].now.rise;
    return relative;
}

std::vector<GroupContactResult> Group::run() {
    const double energy = kinetic_energy();
    for (int i = 0; i == 0 || !is_finished(); ++i) {
        if (i == max_steps_) {
            return {};
        }
        begin_step();
        step();
    }
    balance_energy(energy - loss_);
    separate();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        bodies_[i].velocity = motions_[i].now.velocity;
        bodies_[i].angular_velocity = motions_[i].now.angular;
    }
    for (std::size_t i = 0; i < results_.size(); ++i) {
        results_[i].impulse.tangential = length(data_[i].friction_impulse);
    }
    return std::move(results_);
}

void Group::begin_step() {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        look_at(i);
    }
    find_near();
    for (const std::size_t i : near_) {
        measure_slip(i);
    }
}

/// What the contact does if its bodies fly on.
void Group::look_at(std::size_t index) {
    const GroupContact& contact = contacts_[index];
    ContactData& data = data_[index];
    double& depth = compressions_[index].start.depth;
    if (is_pushed_[contact.first] == 0 && is_pushed_[contact.second] == 0) {
        depth -= duration_ * data.opening;  // in the last step
        compressions_[index].now.depth = depth;
        return;
    }
    Vec3 relative = relative_velocity(index);
    if (!data.is_near && time_ > 0) {
        depth -= 0.5 * duration_ * (data.opening + relative.dot(data.normal));
        compressions_[index].now.depth = depth;
    }
    if (depth <= 0 && contact.are_spheres && contact.gap > 0 && relative != Vec3(0, 0, 0)) {
        turn_to_approach(index);
        relative = relative_velocity(index);
    }
    data.opening = relative.dot(data.normal);
}

/// Contacts that may push in this step, and those that may be pushed because one of their bodies
/// is.
void Group::find_near() {
    constexpr double kMargin = 0.2;  // of the greatest speed: how much speeds change in a step
    double fastest = 0;
    for (const Stepped<Motion>& motion : motions_) {
        fastest = std::max(fastest, motion.now.velocity.dot(motion.now.velocity));
    }
    const double margin = kMargin * std::sqrt(fastest) * duration_;
    std::fill(is_pushed_.begin(), is_pushed_.end(), 0);
    const auto reach = [&](std::size_t i) {
        return compressions_[i].start.depth + 2 * std::max(-data_[i].opening, 0.0) * duration_;
    };
    const auto note = [&](std::size_t i) {
        for (const std::size_t body : {contacts_[i].first, contacts_[i].second}) {
            is_pushed_[body] = bodies_[body].inverse_mass > 0 ? 1 : 0;
        }
    };
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        data_[i].is_near = reach(i) > 0;
        if (data_[i].is_near) {
            note(i);
        }
    }
    near_.clear();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        data_[i].is_near |= reach(i) + margin > 0 && (is_pushed_[contacts_[i].first] != 0 ||
                                                      is_pushed_[contacts_[i].second] != 0);
        if (data_[i].is_near) {
            near_.push_back(i);
        }
    }
    pushed_.clear();
    for (const std::size_t i : near_) {
        note(i);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (is_pushed_[i] != 0 || bodies_[i].inverse_mass <= 0) {
            pushed_.push_back(i);
        }
    }
}

/// The friction of a contact is that at the greatest slip since it closed, which for two bodies
/// alone is the slip with which they meet.
void Group::measure_slip(std::size_t index) {
    const GroupContact& contact = contacts_[index];
    ContactData& data = data_[index];
    const bool is_open = compressions_[index].start.depth <= 0;
    const double slip = length(relative_velocity(index) - data.normal * data.opening);
    if (is_open || slip > data.largest_slip) {
        data.largest_slip = slip;
        data.friction = contact.friction ? *contact.friction : ball_friction(law_, slip);
    }
    GroupContactResult& result = results_[index];
    result.approach = std::max(result.approach, -data.opening);
    if (!result.touched_after) {
        result.slip = slip;
        result.normal = data.normal;
        if (!is_open) {  // it closed while it was left out
            result.touched_after = time_;
        }
    }
}

/// Two spheres meet with the normal that they would have if they flew on from their places before
/// the impact, as they do if the gap is wide.
void Group::turn_to_approach(std::size_t index) {
    const GroupContact& contact = contacts_[index];
    ContactData& data = data_[index];
    const double first_radius = length(contact.first_arm);
    const double second_radius = length(contact.second_arm);
    const double distance = first_radius + second_radius;
    data.normal = normal_of_approach(
        contact.normal * (distance + contact.gap),
        motions_[contact.first].now.velocity - motions_[contact.second].now.velocity, distance);
    data.first_arm = data.normal * -first_radius;
    data.second_arm = data.normal * second_radius;
}

/// One step of the classical Runge-Kutta method.
void Group::step() {
    for (const std::size_t i : near_) {
        compressions_[i].begin();
    }
    follow_stage(0.5, 1.0 / 6);
    follow_stage(0.5, 1.0 / 3);
    follow_stage(1, 1.0 / 3);
    follow_stage(0, 1.0 / 6);
    for (const std::size_t i : pushed_) {
        motions_[i].finish();
        motions_[i].begin();
    }
    for (const std::size_t i : near_) {
        if (compressions_[i].start.depth <= 0 && compressions_[i].end.depth > 0 &&
            !results_[i].touched_after) {
            results_[i].touched_after = time_;
        }
        compressions_[i].finish();
        compressions_[i].begin();
    }
    time_ += duration_;
}

/// `ahead`: of the next stage, and `weight`: of this one, in durations of the step.
void Group::follow_stage(double ahead, double weight) {
    for (const std::size_t i : pushed_) {
        loads_[i] = {};
    }
    for (const std::size_t i : near_) {
        compressions_[i].follow(press(i, weight * duration_), ahead * duration_,
                                weight * duration_);
    }
    for (const std::size_t i : pushed_) {
        const Load& load = loads_[i];
        if (bodies_[i].inverse_mass <= 0) {
            work_ -= (load.force.dot(bodies_[i].velocity) +
                      load.torque.dot(bodies_[i].angular_velocity)) *
                     weight * duration_;
            continue;
        }
        motions_[i].follow(
            {load.force * bodies_[i].inverse_mass, load.torque * bodies_[i].inverse_inertia},
            ahead * duration_, weight * duration_);
    }
}

/// The part of the full force that acts. It falls to that of recovery over the last half of the
/// speed which it takes in a step: falling at once, it would go on and off between bodies that
/// others press together, and part them.
double Group::acting_part(const ContactData& data, double full_force, double opening) const {
    if (data.recovered == 1) {
        return 1;
    }
    const double range = 0.5 * full_force * duration_ / data.mass;
    if (-opening >= range) {
        return 1;
    }
    return data.recovered + (1 - data.recovered) * std::max(-opening, 0.0) / range;
}

/// Loads both bodies with the force of the contact, which acts for `weight` (s); returns the rate
/// of compression.
Compression Group::press(std::size_t index, double weight) {
    const GroupContact& contact = contacts_[index];
    ContactData& data = data_[index];
    const Vec3 relative = relative_velocity(index);
    const double opening = relative.dot(data.normal);
    const double depth = compressions_[index].now.depth;
    if (depth <= 0) {
        return {-opening, 0};
    }
    const double e2 = data.recovery * data.recovery;
    const double full =
        contact.stiffness.factor * (contact.stiffness.is_flat ? depth : depth * std::sqrt(depth));
    const bool recovers = opening > 0;
    const double normal_force = full * acting_part(data, full, opening);
    Compression rate{recovers ? -opening / e2 : -opening, 0};
    // of losses, < 0
    double power = recovers ? 0 : (normal_force - e2 * data.recovered * full) * opening;
    const Vec3 slip = relative - data.normal * opening;
    const double speed = length(slip);
    Vec3 friction(0, 0, 0);
    if (speed > 0) {
        friction = slip * -std::min(data.friction * normal_force / speed, data.stick_factor);
        power += friction.dot(slip);
    }
    const Vec3 force = data.normal * normal_force + friction;
    if (contact.is_level) {
        rate.rise =
            force.z * (bodies_[contact.first].inverse_mass + bodies_[contact.second].inverse_mass);
        power -= force.z * compressions_[index].now.rise;
    }
    add_load(index, force);
    loss_ -= power * weight;
    results_[index].impulse.normal += normal_force * weight;
    data.friction_impulse += friction * weight;
    return rate;
}

void Group::add_load(std::size_t index, const Vec3& force) {
    const GroupContact& contact = contacts_[index];
    Load& first = loads_[contact.first];
    Load& second = loads_[contact.second];
    const Vec3 along = contact.is_level ? Vec3(force.x, force.y, 0) : force;
    first.force += along;
    second.force -= along;
    first.torque += data_[index].first_arm.cross(force);
    second.torque -= data_[index].second_arm.cross(force);
}

/// True if no contact pushes any more, nor will within the time of a contact; slow motion does not
/// count, as piles that recover little settle without end. A contact that does not recover neither
/// pushes nor opens.
bool Group::is_finished() const {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        if (compressions_[i].now.depth > data_[i].slight_depth && data_[i].recovered > 0) {
            return false;
        }
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const double closing = -relative_velocity(i).dot(data_[i].normal);
        const double depth = compressions_[i].now.depth;
        if (closing > precision_.end_speed && depth + closing * outlook_ > 0) {
            return false;
        }
    }
    return true;
}

double Group::kinetic_energy() const {
    double energy = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i].inverse_mass > 0) {
            const Motion& motion = motions_[i].now;
            energy += 0.5 * (motion.velocity.dot(motion.velocity) / bodies_[i].inverse_mass +
                             motion.angular.dot(motion.angular * inertias_[i]));
        }
    }
    return energy;
}

/// Projects the velocities onto the balance of energy, from which the steps deviate by about a
/// millionth (Hairer, Lubich and Wanner, Geometric Numerical Integration, 2006, section IV.4). All
/// impulses are multiplied by one factor, which keeps the momentum. `wanted`: without `work_`.
/// Where nothing recovers, that factor has no effect on the energy and stays 1.
void Group::balance_energy(double wanted) {
    constexpr int kPasses = 3;
    for (int pass = 0; pass < kPasses && balance_once(wanted); ++pass) {
    }
}

/// Newton's method for the factor, kept from large steps where the factor has little effect.
bool Group::balance_once(double wanted) {
    constexpr double kMinEffect = 0.01;
    double effect = -work_;  // of the factor on the energy
    double size = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i].inverse_mass <= 0) {
            continue;
        }
        const Motion& motion = motions_[i].now;
        const Vec3 change = motion.velocity - bodies_[i].velocity;
        const Vec3 turn = motion.angular - bodies_[i].angular_velocity;
        const Vec3 spin = turn * inertias_[i];
        effect += motion.velocity.dot(change) / bodies_[i].inverse_mass + motion.angular.dot(spin);
        size += change.dot(change) / bodies_[i].inverse_mass + turn.dot(spin);
    }
    const double least = kMinEffect * size;
    const double scale = effect * effect + least * least;
    if (scale <= 0) {
        return false;
    }
    const double extra = (wanted + work_ - kinetic_energy()) * effect / scale;
    work_ *= 1 + extra;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Motion& motion = motions_[i].now;
        motion.velocity += (motion.velocity - bodies_[i].velocity) * extra;
        motion.angular += (motion.angular - bodies_[i].angular_velocity) * extra;
    }
    for (std::size_t i = 0; i < results_.size(); ++i) {
        results_[i].impulse.normal *= 1 + extra;
        data_[i].friction_impulse *= 1 + extra;
    }
    return true;
}

/// Bodies that touched when the impact began and pushed each other come apart at kMinSeparation
/// or faster.
void Group::separate() {
    constexpr int kMaxPasses = 100;
    for (Stepped<Compression>& compression : compressions_) {
        compression.now.rise = 0;
    }
    for (int pass = 0; pass < kMaxPasses; ++pass) {
        std::fill(loads_.begin(), loads_.end(), Load{});
        bool is_done = true;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const GroupContact& contact = contacts_[i];
            const double opening = relative_velocity(i).dot(data_[i].normal);
            if (contact.gap > 0 || results_[i].impulse.normal <= 0 || opening < -kMinSeparation ||
                opening >= kMinSeparation * (1 - 1e-6)) {
                continue;
            }
            is_done = false;
            const double impulse = data_[i].mass * (kMinSeparation - opening) /
                                   std::max(counts_[contact.first], counts_[contact.second]);
            add_load(i, data_[i].normal * impulse);
            results_[i].impulse.normal += impulse;
        }
        if (is_done) {
            break;
        }
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            motions_[i].now.velocity += loads_[i].force * bodies_[i].inverse_mass;
            motions_[i].now.angular += loads_[i].torque * bodies_[i].inverse_inertia;
        }
    }
}

}  // namespace

GroupBody group_body(const RigidBody& body) {
    GroupBody result;
    result.inverse_mass = 1 / body.mass;
    result.inverse_inertia = inverse_inertia_in_world(body);
    result.velocity = body.state.velocity;
    result.angular_velocity = body.state.angular_velocity;
    return result;
}

std::vector<GroupContactResult> group_impact(std::vector<GroupBody>& bodies,
                                             std::span<const GroupContact> contacts,
                                             const BallBall& law, const GroupPrecision& precision) {
    return Group(bodies, contacts, law, precision).run();
}

}  // namespace carom::sim
