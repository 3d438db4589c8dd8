// Whether what a body rests on holds it up, or whether it is only balanced for a moment.
#pragma once

#include <vector>

#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/step_body.h"

namespace carom::sim {

/// The contacts of one step, and what was solved for them.
struct SolvedContacts {
    const std::vector<FoundContact>& contacts;
    const std::vector<ode::StepImpulse>& impulses;  // in the same order
    double duration = 0;                            // of the step, s
};

/// Something carries the body and, seen along gravity, its centre of mass lies inside the convex
/// hull of its points of contact, or the point does where its weight and what lies on it act
/// together: a plank may stick out far if something heavy holds its other end. What lies on it
/// holds it, too: it would have to be lifted. (Such bodies may still be about to tip together; that
/// shows in their rising speed, which StepSleep looks at.) A ball, and a capsule or cylinder on its
/// side, may also rest on one point or line straight below: there it is in neutral equilibrium, and
/// rolling resistance may hold it a little beside. What is balanced there exactly, as far as
/// numbers can tell, stands, too. `number`: of the body. True without gravity.
[[nodiscard]] bool is_stably_supported(const StepBody& body, int number,
                                       const SolvedContacts& solved, const Vec3& gravity);

/// Whether the body leans on something: a contact that carries it pushes aside as well as up. Then
/// friction may hold it with its centre of mass beside its support (Bretl and Lall, Testing static
/// equilibrium for legged robots, IEEE Trans. Robotics 24, 2008), which `is_stably_supported` does
/// not see; but what friction does not hold slides at once, where what is balanced on level ground
/// departs from rest ever so slowly at first.
[[nodiscard]] bool leans(int number, const SolvedContacts& solved, const Vec3& gravity);

/// How long (s) a body that is only balanced takes to fall, however well it is balanced: rounding
/// errors grow by a factor of 10^15 in this time. A slender rod on its end tips at the rate
/// sqrt(3 g / (2 L)), L its length, and everything else of that size more slowly by a small factor.
[[nodiscard]] double time_to_tip(const StepBody& body, const Vec3& gravity);

}  // namespace carom::sim
