// Whether the support of a body is stable or the body is only balanced for a moment.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/moving_body.h"

namespace carom::sim {

/// The contacts of one step and the impulses that were solved for them.
struct SolvedContacts {
    const std::vector<BodyContact>& contacts;
    const std::vector<ImpulsePair>& impulses;  // in the same order
    double duration = 0;                       // of the step, s
};

/// The contacts of each body.
class ContactsOfBodies {
  public:
    ContactsOfBodies(const std::vector<BodyContact>& contacts, std::size_t body_count);

    /// The indices of the body's contacts, ascending.
    [[nodiscard]] std::span<const std::size_t> of(int number) const {
        const auto i = static_cast<std::size_t>(number);
        return std::span(contacts_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
    }

  private:
    std::vector<std::size_t> begins_;    // per body: its first place in `contacts_`
    std::vector<std::size_t> contacts_;  // of all bodies, one after the other
};

/// True if something supports the body and, seen along gravity, the convex hull of its contact
/// points contains its centre of mass, or the point at which its weight and the loads on it act
/// together: a plank may stick out far if something heavy holds its other end. Loads hold the body
/// too, since it would have to lift them. (Such bodies may still be about to tip together; their
/// rising speed shows that, which StepSleep checks.) A ball, or a capsule or cylinder on its side,
/// may also rest on one point or line straight below: it is then in neutral equilibrium, and
/// rolling resistance may hold it slightly beside that point. A body that is balanced there
/// exactly, within rounding, also stands. `number`: index of the body; `own`: the indices of its
/// contacts. Always true without gravity.
[[nodiscard]] bool is_stably_supported(const MovingBody& body, int number,
                                       const SolvedContacts& solved,
                                       std::span<const std::size_t> own, const Vec3& gravity);

/// True if the body leans on something: a contact that supports it pushes sideways as well as up.
/// Then friction may hold it with its centre of mass beside its support (Bretl and Lall, Testing
/// static equilibrium for legged robots, IEEE Trans. Robotics 24, 2008), a case that
/// `is_stably_supported` does not cover. A leaning body that friction does not hold slides
/// immediately, whereas a body balanced on level ground leaves rest very slowly at first.
[[nodiscard]] bool leans(int number, const SolvedContacts& solved, std::span<const std::size_t> own,
                         const Vec3& gravity);

/// Upper bound for the time (s) that a balanced body takes to fall: rounding errors grow by a
/// factor of 10^15 in this time. A slender rod of length L on its end tips at the rate sqrt(3 g /
/// (2 L)); all other bodies of that size tip more slowly by a small factor.
[[nodiscard]] double time_to_tip(const MovingBody& body, const Vec3& gravity);

}  // namespace carom::sim
