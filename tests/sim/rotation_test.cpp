
#include "sim/numeric/rotation.h"

#include <cmath>

#include <gtest/gtest.h>

namespace carom::sim {
namespace {

TEST(Turned_ConstantSpin, IsExactOverManyTurns) {
    const Vec3 omega(0, 0, 70);
    const Quat q = turned(Quat(), omega, omega, 10);
    EXPECT_NEAR(q.r, std::cos(350.0), 1e-13);
    EXPECT_NEAR(q.v.z, std::sin(350.0), 1e-13);
}

TEST(Turned_TurningAxis, AgreesWithFineSteps) {
    const Vec3 from(30, -20, 10);
    const Vec3 to(-10, 40, 5);
    const double duration = 0.5;
    Quat fine;
    const int count = 200000;
    for (int i = 0; i < count; ++i) {
        const Vec3 omega = from + (to - from) * ((i + 0.5) / count);
        fine = rotation_by(omega * (duration / count)) * fine;
    }
    const Quat own = turned(Quat(), from, to, duration);
    const double cosine = own.r * fine.r + own.v.dot(fine.v);
    EXPECT_NEAR(std::abs(cosine), 1, 1e-9);  // under 0.005 degree
}

}  // namespace
}  // namespace carom::sim
