#include "render/light/emissive_shape.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/render/direction_density.h"
#include "tests/render/light/light_samples.h"

namespace carom::render {
namespace {

struct ShapeCase {
    const char* name;
    ShapeKind kind;
    V3f parameters{0, 0, 0};
    double area;  // of the unit shape
};

constexpr double kPi64 = 3.14159265358979;

std::vector<ShapeCase> shape_cases() {
    return {{"disk", ShapeKind::disk, {0, 0, 0}, kPi64},
            {"cylinder", ShapeKind::frustum, {1, 0, 0}, 6 * kPi64},
            {"cone", ShapeKind::frustum, {0.5f, -0.5f, 0}, kPi64 * (1 + std::sqrt(5.0))},
            {"capsule", ShapeKind::capsule, {0.7f, 0, 0}, 4 * kPi64 * 1.7},
            {"rounded box",
             ShapeKind::rounded_box,
             {0.5f, 1, 0.25f},
             4 * kPi64 * 2.75 + 8 * (0.5 + 0.25 + 0.125)}};
}

EmissiveShape made(const ShapeCase& shape, const Mat44& world_from_unit) {
    return *EmissiveShape::make({shape.kind, false, 1, Affine::narrowed(world_from_unit.inverse()),
                                 Affine::narrowed(world_from_unit), shape.parameters, 10},
                                V3f(1, 1, 1));
}

/// Distance from the unit shape's surface, roughly.
double off_surface(const ShapeCase& shape, const V3f& p) {
    const double across = std::hypot(static_cast<double>(p.x), static_cast<double>(p.y));
    if (shape.kind == ShapeKind::disk) {
        return std::max(std::abs(static_cast<double>(p.z)), across - 1);
    }
    if (shape.kind == ShapeKind::frustum) {
        const double radius = static_cast<double>(shape.parameters.x + shape.parameters.y * p.z);
        const double beyond = std::max(across - radius, std::abs(static_cast<double>(p.z)) - 1);
        return std::abs(beyond);
    }
    const V3f core =
        shape.kind == ShapeKind::capsule ? V3f(0, 0, shape.parameters.x) : shape.parameters;
    V3f arm;
    for (int axis = 0; axis < 3; ++axis) {
        arm[axis] = std::max(0.0f, std::abs(p[axis]) - core[axis]);
    }
    return std::abs(static_cast<double>(arm.length()) - 1);
}

// Far away the density of a direction is the distance squared over the cosine and the area, so that
// the mean of cosine over density and squared distance is the area that faces the receiver.
TEST(EmissiveShape, Samples_LieOnTheShapeAndCoverItsProjection) {
    for (const ShapeCase& shape : shape_cases()) {
        const EmissiveShape emitter = made(shape, Mat44());
        test::TestRandom random(23);
        double mean_projection = 0;
        constexpr int kReceivers = 4000;
        int facing = 0;
        for (int i = 0; i < kReceivers; ++i) {
            const float height = 2 * random.unit() - 1;
            const float angle = 6.2831853f * random.unit();
            const float level = std::sqrt(1 - height * height);
            const V3f receiver =
                1e3f * V3f(level * std::cos(angle), level * std::sin(angle), height);
            for (int k = 0; k < 10; ++k) {
                const auto sample =
                    light_sample(emitter, receiver, V2f{random.unit(), random.unit()});
                if (!sample) {
                    continue;
                }
                facing += 1;
                ASSERT_LT(off_surface(shape, receiver + sample->direction * sample->distance), 2e-3)
                    << shape.name;
                mean_projection += 1e6 / static_cast<double>(sample->pdf) / (kReceivers * 10);
            }
        }
        // Cauchy: a convex body shows a quarter of its area; a one-sided disk on average as much.
        EXPECT_NEAR(mean_projection, shape.area / 4, 0.015 * shape.area / 4) << shape.name;
        if (shape.kind != ShapeKind::disk && shape.parameters.y >= 0) {
            // From far away a point or its opposite faces, except for caps seen from the side.
            EXPECT_GT(facing, 0.998 * kReceivers * 10) << shape.name;
        }
    }
}

// A sample's density is the one that a hit of the same point gets, under any affine map.
TEST(EmissiveShape, DensityOfAHit_IsThatOfTheSample) {
    Mat44 map;
    map.setScale(Vec3(0.3, 0.2, 0.5));
    Mat44 shear;
    shear[0][2] = 0.3;
    shear[1][0] = -0.4;
    map = map * shear;
    map[3][0] = 0.4;
    map[3][2] = 0.2;
    std::vector<ShapeCase> cases = shape_cases();
    cases.push_back({"ellipsoid", ShapeKind::sphere, {0, 0, 0}, 4 * kPi64});
    for (const ShapeCase& shape : cases) {
        const EmissiveShape emitter = made(shape, map);
        const Affine unit_from_world = emitter.constants().unit_from_body;
        test::TestRandom random(29);
        const V3f point(0.3f, -0.6f, 1.7f);
        double solid_angle = 0;
        int checked = 0;
        for (int i = 0; i < 4000; ++i) {
            const auto sample = light_sample(emitter, point, V2f{random.unit(), random.unit()});
            if (!sample) {
                continue;
            }
            solid_angle += 1 / (4000 * static_cast<double>(sample->pdf));
            const V3f place = unit_from_world.point(point + sample->direction * sample->distance);
            V3f unit_normal = place;
            if (shape.kind == ShapeKind::disk) {
                unit_normal = V3f(0, 0, 1);
            } else if (shape.kind == ShapeKind::frustum) {
                unit_normal =
                    std::abs(place.z) > 0.9999f
                        ? V3f(0, 0, place.z)
                        : V3f(place.x / std::hypot(place.x, place.y),
                              place.y / std::hypot(place.x, place.y), -shape.parameters.y);
            } else if (shape.kind != ShapeKind::sphere) {
                const V3f core = shape.kind == ShapeKind::capsule ? V3f(0, 0, shape.parameters.x)
                                                                  : shape.parameters;
                for (int axis = 0; axis < 3; ++axis) {
                    unit_normal[axis] = std::copysign(
                        std::max(0.0f, std::abs(place[axis]) - core[axis]), place[axis]);
                }
            }
            const V3f normal = Affine::normal(unit_normal, unit_from_world).normalized();
            const float cosine = -normal.dot(sample->direction);
            if (cosine < 0.05f) {
                continue;  // rounding
            }
            checked += 1;
            const float pdf = scalar::pdf_of_shape<scalar::One>(
                emitter.constants(), point, sample->direction, sample->distance, normal);
            ASSERT_NEAR(pdf, sample->pdf, 2e-3f * sample->pdf) << shape.name;
        }
        EXPECT_GT(checked, 500) << shape.name;
        EXPECT_GT(solid_angle, 0.005) << shape.name;
    }
}

TEST(EmissiveShape, WithinOrBehind_NothingArrives) {
    test::TestRandom random(31);
    std::vector<ShapeCase> cases = shape_cases();
    cases.push_back({"ball", ShapeKind::sphere, {0, 0, 0}, 4 * kPi64});
    for (const ShapeCase& shape : cases) {
        const EmissiveShape emitter = made(shape, Mat44());
        const V3f point =
            shape.kind == ShapeKind::disk ? V3f(0.2f, 0, -2) : V3f(0.05f, 0.1f, -0.1f);
        for (int i = 0; i < 200; ++i) {
            EXPECT_FALSE(light_sample(emitter, point, V2f{random.unit(), random.unit()}))
                << shape.name;
        }
    }
}

TEST(EmissiveShape, FlatFacesAndPlanes_AreNotMadeHere) {
    for (const ShapeKind kind :
         {ShapeKind::box, ShapeKind::rectangle, ShapeKind::triangle, ShapeKind::plane}) {
        EmissiveShape::Description shape;
        shape.kind = kind;
        EXPECT_FALSE(EmissiveShape::make(shape, V3f(1, 1, 1)));
    }
    EXPECT_TRUE(EmissiveShape::make({}, V3f(0, 0, 0))->is_black());
}

}  // namespace
}  // namespace carom::render
