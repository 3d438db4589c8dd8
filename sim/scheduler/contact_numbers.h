// The numbers of the contact law that a pair in lasting contact goes by.
#pragma once

#include <string>

#include "core/vectors.h"
#include "sim/contact_law.h"

namespace carom::sim {

struct ContactNumbers {
    double restitution = 0;
    double friction = 0;
    double rolling_lever = 0;   // m
    double spinning_lever = 0;  // m
};

/// Materials "ball", "cloth" and "cushion" follow the billiard laws, all others their pair's.
/// `radius`: of the ball among the two, 0 if there is none.
[[nodiscard]] ContactNumbers contact_numbers(const ContactLaw& law, const std::string& a,
                                             const std::string& b, double radius);

/// True for what a ball meets as a pocket's lining (ball_impact.h).
[[nodiscard]] bool is_lining(const std::string& material, const Vec3& normal);

}  // namespace carom::sim
