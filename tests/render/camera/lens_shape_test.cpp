#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/camera/lens_distortion.h"
#include "render/camera/thin_lens_camera.h"
#include "tests/render/statistics.h"
#include "tests/render/two_disks.h"

namespace carom::render {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 360;
const double kCorner = 0.5 * std::hypot(kWidth, kHeight);
constexpr float kRadius = 0.02F;

CameraState state_of(const LensShape& shape, double lens_radius = 0) {
    CameraState state;
    state.position = Vec3(-1.5, -2, 1.2);
    state.target = Vec3(0.3, 0.1, 0.05);
    state.vertical_fov = 0.6;
    state.focus_distance = 2.2;
    state.lens_radius = lens_radius;
    state.lens = shape;
    return state;
}

ThinLensCamera camera_of(const CameraState& state) {
    return {state, state, kWidth, kHeight, 0, PixelFilter::box, 1};
}

LensShape cat_eye(double ratio, double shift) {
    LensShape shape;
    shape.cat_eye_ratio = ratio;
    shape.cat_eye_shift = shift;
    return shape;
}

LensShape barrel(double distortion) {
    LensShape shape;
    shape.distortion = distortion;
    return shape;
}

CameraSample random_sample(test::TestRandom& random) {
    return {{random.unit(), random.unit()}, {random.unit(), random.unit()}, random.unit()};
}

/// The ray's point on the lens in radii of the lens.
V2f lens_point(const ThinLensCamera& camera, const Ray& ray) {
    const CameraFrame frame = camera.frame_at(0);
    const V3f arm = ray.origin - frame.position;
    return V2f(arm.dot(frame.right), arm.dot(frame.up)) / kRadius;
}

TEST(LensDistortion, InverseIsExact) {
    for (const float in_corner : {-0.3F, -0.02F, 0.01F, 0.3F}) {
        const float k = in_corner;  // with the corner at the distance 1
        for (const V2f& place : {V2f(0, 0), V2f(0.6F, 0.8F), V2f(-0.3F, 0.1F), V2f(0, -0.9F)}) {
            const V2f there = distorted(undistorted(place, k), k);
            EXPECT_NEAR(there.x, place.x, 1e-6F) << in_corner;
            EXPECT_NEAR(there.y, place.y, 1e-6F) << in_corner;
        }
    }
}

TEST(LensDistortion, Corner_MovesByThatPart) {
    for (const double distortion : {-0.05, 0.03}) {
        const ThinLensCamera straight = camera_of(state_of(LensShape()));
        const ThinLensCamera bent = camera_of(state_of(barrel(distortion)));
        // The point that the picture has in its corner.
        const Ray ray = bent.ray(kWidth - 1, 0, {V2f(1, 0), V2f(0.5F, 0.5F), 0});
        const V3f point = ray.origin + 3.0F * ray.direction;
        const V2f without = *straight.project(point, 0) - V2f(kWidth / 2.0F, kHeight / 2.0F);
        EXPECT_NEAR(static_cast<double>(without.length()) * (1 + distortion), kCorner, 1e-2);
        const V2f with = *bent.project(point, 0);
        EXPECT_NEAR(with.x, kWidth, 1e-2F);
        EXPECT_NEAR(with.y, 0, 1e-2F);
    }
}

TEST(LensDistortion, Centre_StaysWhereItIs) {
    const ThinLensCamera straight = camera_of(state_of(LensShape()));
    const ThinLensCamera bent = camera_of(state_of(barrel(-0.1)));
    const CameraSample sample{V2f(0, 0), V2f(0.5F, 0.5F), 0};
    EXPECT_EQ(straight.ray(kWidth / 2, kHeight / 2, sample).direction,
              bent.ray(kWidth / 2, kHeight / 2, sample).direction);
}

TEST(LensShape, ImagePoint_UndoesRay) {
    LensShape shape = barrel(-0.08);
    shape.squeeze = 0.6;
    test::TestRandom random(4);
    for (const double radius : {0.0, 0.03}) {
        for (const double distortion : {-0.08, 0.05}) {
            shape.distortion = distortion;
            const ThinLensCamera camera = camera_of(state_of(shape, radius));
            for (int i = 0; i < 1'000; ++i) {
                const CameraSample sample = random_sample(random);
                const int x = i % kWidth;
                const int y = (7 * i) % kHeight;
                const Ray ray = camera.ray(x, y, sample);
                const ThinLensCamera::Aperture aperture = camera.aperture(sample);
                ASSERT_EQ(aperture.position, ray.origin);
                const auto there = camera.image_point(aperture, ray.direction);
                ASSERT_TRUE(there);
                EXPECT_NEAR(there->position.x, static_cast<float>(x) + sample.pixel.x, 3e-3F);
                EXPECT_NEAR(there->position.y, static_cast<float>(y) + sample.pixel.y, 3e-3F);
            }
        }
    }
}

TEST(LensDistortion, PixelSolidAngle_IsThatBetweenItsCorners) {
    for (const double distortion : {-0.1, 0.1}) {
        const ThinLensCamera camera = camera_of(state_of(barrel(distortion), 0.05));
        const CameraSample sample{V2f(0.5F, 0.5F), V2f(0.9F, 0.2F), 0};
        const ThinLensCamera::Aperture aperture = camera.aperture(sample);
        for (const int x : {0, 100, 320, 639}) {
            const auto toward = [&](int dx, int dy) {
                return camera.ray(x + dx, 40 + dy, sample).direction;
            };
            const V3f across = (toward(3, 0) - toward(-3, 0)) / 6;
            const V3f down = (toward(0, 3) - toward(0, -3)) / 6;
            const double expected = static_cast<double>(across.cross(down).length());
            const auto there = camera.image_point(aperture, toward(0, 0));
            ASSERT_TRUE(there);
            EXPECT_NEAR(static_cast<double>(there->pixel_solid_angle), expected, 1e-3 * expected)
                << x;
        }
    }
}

TEST(LensDistortion, PixelSolidAngles_SumToThePicture) {
    // The picture's border is bent, so the whole is the sum over small triangles of it.
    const ThinLensCamera camera = camera_of(state_of(barrel(-0.1)));
    const CameraSample sample{V2f(0.5F, 0.5F), V2f(0.5F, 0.5F), 0};
    const ThinLensCamera::Aperture aperture = camera.aperture(sample);
    double sum = 0;
    double cells = 0;
    constexpr int kStep = 20;
    const auto corner = [&](int x, int y) {
        return Vec3(camera.ray(x, y, {V2f(0, 0), V2f(0.5F, 0.5F), 0}).direction);
    };
    for (int y = 0; y < kHeight; y += kStep) {
        for (int x = 0; x < kWidth; x += kStep) {
            const V3f middle =
                camera.ray(x + kStep / 2, y + kStep / 2, {V2f(0, 0), V2f(0.5F, 0.5F), 0}).direction;
            sum += kStep * kStep *
                   static_cast<double>(camera.image_point(aperture, middle)->pixel_solid_angle);
            const Vec3 a = corner(x + kStep, y + kStep) - corner(x, y);
            const Vec3 b = corner(x, y + kStep) - corner(x + kStep, y);
            cells += 0.5 * a.cross(b).length();
        }
    }
    EXPECT_NEAR(sum, cells, 2e-3 * cells);
}

TEST(CatEye, MeanWeight_IsTheAreaThatTwoDisksHaveInCommon) {
    const double ratio = 1.1;
    const double shift = 0.8;
    const ThinLensCamera camera = camera_of(state_of(cat_eye(ratio, shift), kRadius));
    test::TestRandom random(11);
    for (const int x : {kWidth / 2, 100, 0}) {
        double sum = 0;
        constexpr int kCount = 200'000;
        for (int i = 0; i < kCount; ++i) {
            sum += static_cast<double>(
                camera.weight(x, 0, {V2f(0, 0), V2f(random.unit(), random.unit()), 0}));
        }
        const double far = std::hypot(x - kWidth / 2, kHeight / 2) / kCorner;
        EXPECT_NEAR(sum / kCount, test::common_area(ratio, far * shift) / std::numbers::pi, 1e-3)
            << x;
    }
}

TEST(CatEye, Rays_PassBothOpeningsAndCoverThemEvenly) {
    for (const int blades : {0, 6}) {
        const double ratio = 1.05;
        const double shift = 0.7;
        CameraState state = state_of(cat_eye(ratio, shift), kRadius);
        state.blades = blades;
        state.blade_rotation = 0.2;
        const ThinLensCamera camera = camera_of(state);
        state.lens.reset();
        const ThinLensCamera open = camera_of(state);
        const int x = 40;
        const int y = 300;
        const V2f field = V2f(x - kWidth / 2.0F, kHeight / 2.0F - y) / static_cast<float>(kCorner);
        const V2f second = -field * static_cast<float>(shift);
        test::TestRandom random(5);
        Vec3 weighted(0, 0, 0);  // of area, and of the two second moments
        Vec3 expected(0, 0, 0);
        double squares = 0;  // of weights
        constexpr int kCount = 400'000;
        for (int i = 0; i < kCount; ++i) {
            const CameraSample sample{V2f(0, 0), V2f(random.unit(), random.unit()), 0};
            const V2f place = lens_point(camera, camera.ray(x, y, sample));
            ASSERT_LE((place - second).length(), ratio + 1e-4);
            const double weight = static_cast<double>(camera.weight(x, y, sample));
            squares += weight * weight;
            const auto add = [](Vec3& to, const V2f& at, double w) {
                to += w * Vec3(1, static_cast<double>((at - V2f(0.1F, 0.2F)).length()),
                               static_cast<double>(at.x * at.y + at.x));
            };
            add(weighted, place, weight);
            const V2f all = lens_point(open, open.ray(x, y, sample));
            add(expected, all, (all - second).length() <= static_cast<float>(ratio) ? 1 : 0);
        }
        const double mean = weighted[0] / kCount;
        EXPECT_LT(std::sqrt(squares / kCount - mean * mean), 0.05 * mean)
            << "noise of what is in focus";
        const Vec3 difference = (weighted - expected) / kCount;
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(difference[i], 0, 2.5e-3) << blades << ", " << i;
        }
    }
}

// What light tracing finds of a point of the picture is what its rays weigh.
TEST(CatEye, ImagePoints_AreStoppedAsRaysAreWeakened) {
    const double ratio = 1.1;
    const double shift = 0.9;
    LensShape shape = cat_eye(ratio, shift);
    shape.squeeze = 0.5;
    const ThinLensCamera camera = camera_of(state_of(shape, kRadius));
    const Ray ray = camera.ray(20, 30, {V2f(0, 0), V2f(0.5F, 0.5F), 0});
    const CameraFrame frame = camera.frame_at(0);
    // In the plane of focus, so that it is there through every point of the lens.
    const V3f point = frame.position + ray.direction * (2.2F / ray.direction.dot(frame.forward));
    test::TestRandom random(6);
    int seen = 0;
    Vec2 seen_through(0, 0);  // sums of points of the lens
    Vec2 weighted(0, 0);
    constexpr int kCount = 100'000;
    for (int i = 0; i < kCount; ++i) {
        const CameraSample sample = random_sample(random);
        const ThinLensCamera::Aperture aperture = camera.aperture(sample);
        const V3f direction = (point - aperture.position).normalized();
        if (camera.image_point(aperture, direction)) {
            seen += 1;
            seen_through += Vec2(aperture.pupil);
        }
        const V2f place = lens_point(camera, camera.ray(20, 30, sample));
        weighted +=
            static_cast<double>(camera.weight(20, 30, sample)) *
            Vec2(static_cast<double>(place.x) / shape.squeeze, static_cast<double>(place.y));
    }
    const double far = std::hypot(20 - kWidth / 2, 30 - kHeight / 2) / kCorner;
    EXPECT_NEAR(static_cast<double>(seen) / kCount,
                test::common_area(ratio, far * shift) / std::numbers::pi, 5e-3);
    EXPECT_GT(weighted.length() / kCount, 0.1) << "on one side of the lens";
    EXPECT_NEAR((seen_through - weighted).length() / kCount, 0, 5e-3);
}

TEST(CatEye, Pinhole_IsNotWeakened) {
    const ThinLensCamera camera = camera_of(state_of(cat_eye(1, 0.9)));
    EXPECT_FALSE(camera.has_weights());
    EXPECT_EQ(camera.weight(0, 0, {V2f(0, 0), V2f(0.1F, 0.9F), 0}), 1.0F);
}

TEST(Squeeze, Pupil_IsAnEllipse) {
    LensShape shape;
    shape.squeeze = 0.5;
    const ThinLensCamera camera = camera_of(state_of(shape, kRadius));
    test::TestRandom random(7);
    V2f most(0, 0);
    for (int i = 0; i < 20'000; ++i) {
        const V2f place = lens_point(camera, camera.ray(10, 20, random_sample(random)));
        ASSERT_LE(V2f(2 * place.x, place.y).length(), 1.0001F);
        most = {std::max(most.x, place.x), std::max(most.y, place.y)};
    }
    EXPECT_NEAR(most.x, 0.5F, 5e-3F);
    EXPECT_NEAR(most.y, 1.0F, 5e-3F);
}

TEST(LensShape, PlainShape_GivesTheSameBitsAsNone) {
    CameraState none = state_of(LensShape(), 0.02);
    none.lens.reset();
    const ThinLensCamera plain = camera_of(state_of(LensShape(), 0.02));
    const ThinLensCamera without = camera_of(none);
    test::TestRandom random(8);
    for (int i = 0; i < 1'000; ++i) {
        const CameraSample sample = random_sample(random);
        const Ray a = plain.ray(i % kWidth, i % kHeight, sample);
        const Ray b = without.ray(i % kWidth, i % kHeight, sample);
        ASSERT_EQ(a.origin, b.origin);
        ASSERT_EQ(a.direction, b.direction);
    }
}

std::string message(const LensShape& shape) {
    try {
        const ThinLensCamera camera = camera_of(state_of(shape));
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(LensShape, UnusableShapes_AreRefused) {
    const std::string cat =
        "camera: the cat's eye needs a ratio of at least 1 and a shift from 0 to below the ratio";
    EXPECT_EQ(message(cat_eye(0.9, 0)), cat);
    EXPECT_EQ(message(cat_eye(1.2, 1.2)), cat);
    EXPECT_EQ(message(cat_eye(1.2, -0.1)), cat);
    LensShape shape;
    shape.squeeze = 0;
    EXPECT_EQ(message(shape), "camera: the squeeze of the lens must lie above 0 and not above 1");
    EXPECT_EQ(message(barrel(0.31)),
              "camera: the distortion of the lens must lie between -0.3 and 0.3");
    EXPECT_EQ(message(barrel(std::nan(""))),
              "camera: the distortion of the lens must lie between -0.3 and 0.3");
}

}  // namespace
}  // namespace carom::render
