// Impulses between touching balls that do not rebound.
#pragma once

#include <utility>
#include <vector>

#include "sim/stick/cluster_strike.h"

namespace carom::sim {

/// On the first ball of a contact, N s.
struct ContactImpulse {
    double normal = 0;
    Vec3 friction{0, 0, 0};
};

/// Solves the contacts of a group for one increment of an external impulse: afterwards no contact
/// closes, a contact that opens has no impulse, and the friction, of at most its coefficient times
/// the normal impulse, acts against the slip, or stops it.
class ContactImpulses {
  public:
    explicit ContactImpulses(const FrozenCluster& group);

    /// Changes `velocities`, which are those without contacts, and `impulses`, which are first
    /// guesses. `friction`: one coefficient for each contact.
    void solve(std::vector<Velocities>& velocities, const std::vector<double>& friction,
               std::vector<ContactImpulse>& impulses) const;

    /// From now on a contact counts as closing if it opens more slowly than this, m/s.
    void set_least_separations(std::vector<double> speeds) { least_ = std::move(speeds); }

    /// The velocity of the first ball's surface relative to the second's, along the normal and
    /// across it.
    struct Relative {
        double normal = 0;
        Vec3 slip{0, 0, 0};
    };
    [[nodiscard]] Relative relative_velocity(const TouchingPair& contact,
                                             const std::vector<Velocities>& velocities) const;

  private:
    void add(const std::vector<ContactImpulse>& impulses,
             std::vector<Velocities>& velocities) const;
    /// One step of projected gradient descent from `from`; returns the largest change, m/s.
    double descend(const std::vector<Velocities>& velocities, const std::vector<double>& friction,
                   const std::vector<ContactImpulse>& from, std::vector<ContactImpulse>& to) const;

    const FrozenCluster& group_;
    std::vector<double> inverse_masses_;  // of each contact: sum over its two balls
    std::vector<double> least_;           // separation speeds of the contacts
    double step_ = 1;                     // of the descent
};

}  // namespace carom::sim
