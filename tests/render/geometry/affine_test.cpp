#include "render/geometry/affine.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/geometry/rigid_motion.h"
#include "render/geometry/scalar_kernels.h"
#include "tests/render/pose_matrix.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

TEST(PoseMatrix, QuarterTurnAboutZ_TakesXToY) {
    const double half = std::sqrt(0.5);
    const Mat44 m = pose_matrix({Vec3(1, 2, 3), Quat(half, 0, 0, half)});
    const Vec3 p = Vec3(1, 0, 0) * m;
    EXPECT_NEAR((p - Vec3(1, 3, 3)).length(), 0, 1e-15);
    const Imath::Quatf q(static_cast<float>(half), 0, 0, static_cast<float>(half));
    EXPECT_NEAR((rotate(q, V3f(1, 0, 0)) - V3f(0, 1, 0)).length(), 0, 1e-6);
    EXPECT_NEAR((rotate_back(q, V3f(0, 1, 0)) - V3f(1, 0, 0)).length(), 0, 1e-6);
}

TEST(AxisScales, RotatedScale_IsFound) {
    Mat44 scale;
    scale.setScale(Vec3(2, 3, 0.5));
    const Mat44 m = scale * pose_matrix({Vec3(7, 8, 9), Quat(1, 2, 3, 4).normalized()});
    EXPECT_NEAR((axis_scales(m) - Vec3(2, 3, 0.5)).length(), 0, 1e-14);
}

TEST(Affine, NormalThroughInverse_StaysAtRightAngles) {
    // A shear: a plane's direction and its normal must stay perpendicular.
    const Mat44 m(1, 0.5, 0, 0, 0, 2, 0.3, 0, 0.1, 0, 1, 0, 4, 5, 6, 1);
    const Affine map = Affine::narrowed(m);
    const Affine inverse = Affine::narrowed(m.inverse());
    const V3f normal = Affine::normal(V3f(0, 0, 1), inverse);
    EXPECT_NEAR(normal.dot(map.vector(V3f(1, 0, 0))), 0, 1e-6);
    EXPECT_NEAR(normal.dot(map.vector(V3f(0, 1, 0))), 0, 1e-6);
    EXPECT_NEAR((inverse.point(map.point(V3f(1, 2, 3))) - V3f(1, 2, 3)).length(), 0, 1e-5);
}

TEST(OrthonormalBasis, AnyDirection_IsRightHandedAndOrthonormal) {
    test::TestRandom random(2);
    for (int i = 0; i < 20'000; ++i) {
        const float x = random.between(-1, 1);
        const float y = random.between(-1, 1);
        const float z = random.between(-1, 1);
        // Some close to the poles, where older constructions fail.
        const V3f d = (i % 4 == 0 ? V3f(1e-4f * x, 1e-4f * y, z) : V3f(x, y, z)).normalized();
        const auto basis = scalar::basis_around<scalar::One>(d);
        ASSERT_NEAR(basis.x.length(), 1, 1e-6);
        ASSERT_NEAR(basis.y.length(), 1, 1e-6);
        ASSERT_NEAR(basis.x.dot(basis.y), 0, 1e-6);
        ASSERT_NEAR(basis.x.dot(d), 0, 1e-6);
        ASSERT_NEAR((basis.x.cross(basis.y) - d).length(), 0, 1e-6);
        const V3f v(0.3f, -0.7f, 0.2f);
        ASSERT_NEAR((basis.from_world(basis.to_world(v)) - v).length(), 0, 1e-6);
    }
}

}  // namespace
}  // namespace carom::render
