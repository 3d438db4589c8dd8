#include "sim/stick/contact_impulses.h"

#include <algorithm>
#include <cmath>

#include "core/length.h"

namespace carom::sim {
namespace {

/// The descent ends with changes below this fraction of the speeds that the contacts change, or
/// with rounding errors of the speeds.
constexpr double kConverged = 1e-14;
constexpr double kRounding = 4e-16;
/// Some hundreds are usual for a rack. From `kPlain` on without acceleration.
constexpr int kMaxSteps = 40000;
constexpr int kPlain = 20000;

/// Change of the slip per unit of friction impulse, for solid spheres: 1 + 5/2.
constexpr double kSlipResponse = 3.5;

Vec3 without_vertical(const Vec3& v, bool is_level) {
    return is_level ? Vec3(v.x, v.y, 0) : v;
}

}  // namespace

ContactImpulses::ContactImpulses(const FrozenCluster& group) : group_(group) {
    std::vector<double> counts(group.balls.size(), 0);
    for (const TouchingPair& contact : group.contacts) {
        counts[contact.first] += 1;
        counts[contact.second] += 1;
    }
    // Scaled by the masses, the largest eigenvalue of the contacts' response is at most the mean
    // number of contacts of two touching balls, weighted with their inverse masses.
    double largest = 1;
    for (const TouchingPair& contact : group.contacts) {
        const double a = 1 / group.balls[contact.first].mass;
        const double b = 1 / group.balls[contact.second].mass;
        inverse_masses_.push_back(a + b);
        largest =
            std::max(largest, (counts[contact.first] * a + counts[contact.second] * b) / (a + b));
    }
    step_ = 1 / largest;
    least_.assign(group.contacts.size(), 0);
}

ContactImpulses::Relative ContactImpulses::relative_velocity(
    const TouchingPair& contact, const std::vector<Velocities>& velocities) const {
    const Velocities& a = velocities[contact.first];
    const Velocities& b = velocities[contact.second];
    const Vec3 centres = without_vertical(a.linear - b.linear, contact.is_level);
    const Vec3 spin = a.angular * group_.balls[contact.first].radius +
                      b.angular * group_.balls[contact.second].radius;
    const double normal = centres.dot(contact.normal);
    return {normal, centres - contact.normal * normal - spin.cross(contact.normal)};
}

void ContactImpulses::add(const std::vector<ContactImpulse>& impulses,
                          std::vector<Velocities>& velocities) const {
    for (std::size_t i = 0; i < impulses.size(); ++i) {
        const TouchingPair& contact = group_.contacts[i];
        const Vec3 impulse = without_vertical(
            contact.normal * impulses[i].normal + impulses[i].friction, contact.is_level);
        const Vec3 turn = impulses[i].friction.cross(contact.normal) * 2.5;
        const RigidBody& a = group_.balls[contact.first];
        const RigidBody& b = group_.balls[contact.second];
        velocities[contact.first].linear += impulse / a.mass;
        velocities[contact.second].linear -= impulse / b.mass;
        velocities[contact.first].angular += turn / (a.mass * a.radius);
        velocities[contact.second].angular += turn / (b.mass * b.radius);
    }
}

double ContactImpulses::descend(const std::vector<Velocities>& velocities,
                                const std::vector<double>& friction,
                                const std::vector<ContactImpulse>& from,
                                std::vector<ContactImpulse>& to) const {
    double largest = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const Relative relative = relative_velocity(group_.contacts[i], velocities);
        const double scale = step_ / inverse_masses_[i];
        ContactImpulse& impulse = to[i];
        impulse.normal = std::max(from[i].normal - (relative.normal - least_[i]) * scale, 0.0);
        impulse.friction = from[i].friction - relative.slip * (scale / kSlipResponse);
        const double limit = friction[i] * impulse.normal;
        const double size = length(impulse.friction);
        if (size > limit) {
            impulse.friction *= limit / size;
        }
        largest =
            std::max(largest, inverse_masses_[i] * (std::abs(impulse.normal - from[i].normal) +
                                                    length(impulse.friction - from[i].friction)));
    }
    return largest;
}

/// Projected gradient descent with Nesterov's acceleration, restarted where it overshoots
/// (O'Donoghue and Candes, Adaptive restart for accelerated gradient schemes, 2015, section 3.2).
/// Unlike the sequential method of Gauss and Seidel it treats all contacts alike: the result does
/// not depend on their order, not even in a rack whose impulses rigid contacts leave undetermined.
void ContactImpulses::solve(std::vector<Velocities>& velocities,
                            const std::vector<double>& friction,
                            std::vector<ContactImpulse>& impulses) const {
    const std::vector<Velocities> free = velocities;
    double enough = 0;
    for (const TouchingPair& contact : group_.contacts) {
        const Relative relative = relative_velocity(contact, free);
        enough = std::max({enough, kConverged * (std::abs(relative.normal) + length(relative.slip)),
                           kRounding * length(free[contact.first].linear),
                           kRounding * length(free[contact.second].linear)});
    }
    std::vector<ContactImpulse> trial = impulses;
    std::vector<ContactImpulse> next = impulses;
    double weight = 1;
    for (int i = 0; i < kMaxSteps; ++i) {
        velocities = free;
        add(trial, velocities);
        const double change = descend(velocities, friction, trial, next);
        double overshoot = 0;
        for (std::size_t k = 0; k < next.size(); ++k) {
            overshoot +=
                inverse_masses_[k] *
                ((trial[k].normal - next[k].normal) * (next[k].normal - impulses[k].normal) +
                 (trial[k].friction - next[k].friction)
                         .dot(next[k].friction - impulses[k].friction) *
                     kSlipResponse);
        }
        const double last_weight = overshoot > 0 || i >= kPlain ? 1 : weight;
        weight = 0.5 * (1 + std::sqrt(1 + 4 * last_weight * last_weight));
        const double ahead = i >= kPlain ? 0 : (last_weight - 1) / weight;
        for (std::size_t k = 0; k < next.size(); ++k) {
            trial[k].normal = next[k].normal + (next[k].normal - impulses[k].normal) * ahead;
            trial[k].friction =
                next[k].friction + (next[k].friction - impulses[k].friction) * ahead;
        }
        impulses.swap(next);
        if (change <= enough) {
            break;
        }
    }
    velocities = free;
    add(impulses, velocities);
}

}  // namespace carom::sim
