#include "sim/scheduler/contact_numbers.h"

#include <cmath>

namespace carom::sim {

ContactNumbers contact_numbers(const ContactLaw& law, const std::string& a, const std::string& b,
                               double radius) {
    const auto is = [&](const char* first, const char* second) {
        return (a == first && b == second) || (a == second && b == first);
    };
    if (is("ball", "cloth")) {
        const BallCloth& cloth = law.ball_cloth;
        // A ball that rolls without slip decelerates by mu_r g if the moment that holds it back is
        // 7/5 mu_r R N.
        return {cloth.restitution, cloth.sliding_friction, 1.4 * cloth.rolling_friction * radius,
                cloth.spinning_friction * radius};
    }
    if (is("ball", "ball")) {
        return {law.ball_ball.restitution, law.ball_ball.friction, 0, 0};
    }
    if (is("ball", "cushion")) {
        return {law.ball_cushion.restitution, law.ball_cushion.friction, 0, 0};
    }
    const PairContact& pair = law.between(a, b);
    const double lever = 1.4 * pair.rolling_friction * radius;
    return {pair.restitution, pair.friction, lever, lever};
}

bool is_lining(const std::string& material, const Vec3& normal) {
    constexpr double kSteep = 0.3;
    return material == "pocket" && std::abs(normal.z) < kSteep;
}

}  // namespace carom::sim
