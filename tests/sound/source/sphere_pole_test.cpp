// One sphere whose velocity changes at once, against Kirchhoff's solution.
#include <cmath>

#include <gtest/gtest.h>

#include "sound/source/direct_sound.h"

namespace carom::sound {
namespace {

TEST(SpherePole, Step_AtFiveAnglesAndThreeDistances_IsKirchhoffsSolution) {
    const double radius = 0.028575;
    const double kappa = 343 / radius;
    for (const double degrees : {0.0, 30.0, 60.0, 90.0, 150.0}) {
        for (const double distance : {0.05, 0.5, 3.0}) {
            const double cosine = std::cos(degrees * M_PI / 180);
            const SpherePole wave = sphere_pole(radius, distance, cosine);
            for (const double tau : {0.0, 20e-6, 80e-6, 300e-6}) {
                const double near = radius / distance;
                const double exact = 1.204 * 343 * cosine * near * std::exp(-kappa * tau) *
                                     (std::cos(kappa * tau) - (1 - near) * std::sin(kappa * tau));
                const double found = 2 * (wave.residue * exponential(tau * wave.pole)).re;
                EXPECT_NEAR(found, exact, 1e-10 * 413 * near);
            }
        }
    }
}

}  // namespace
}  // namespace carom::sound
