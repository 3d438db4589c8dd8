// Objects that follow tracks.
#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "lab/structures/make_structure.h"
#include "render/acceleration/moving_shape.h"
#include "render/geometry/rigid_motion.h"
#include "sim/timeline/rotation.h"
#include "tests/render/frame_scene/scene_helpers.h"
#include "tests/render/geometry/intersect.h"
#include "tests/render/hits.h"

namespace carom::test {
namespace {

std::vector<sim::Key> tumbling() {
    return {key_at(0, Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 3, 1)),
            key_at(1, Vec3(1, 0.2, 0.3), Vec3(0.5, 0, 1), Vec3(4, 0, -2),
                   turn_about(Vec3(1, 1, 1), 1.1))};
}

constexpr double kOpen = 0.2;
constexpr double kClose = 0.7;

double scene_time(float time) {
    return kOpen + (kClose - kOpen) * static_cast<double>(time);
}

TEST(MovingBall, TextureTurnsWithTheTrack) {
    SceneBuilder builder;
    builder.add_moving(SphereShape{0.1}, tumbling());
    const BuiltScene scene(builder, kOpen, kClose);
    TestRandom random(1);
    for (int i = 0; i < 500; ++i) {
        const float time = random.unit();
        const sim::Track& track = builder.tracks[0];
        const MotionState state = track.sample(scene_time(time));
        const Ray ray = ray_from(state.position + random_vector(random).normalized(),
                                 state.position + random_vector(random, 0.05f), time);
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit));
        const SurfacePoint p = scene.frame.surface_at(ray, hit);
        const Vec3 arm = Vec3(p.position) - state.position;
        ASSERT_NEAR(arm.length(), 0.1, 5e-7);
        ASSERT_NEAR((arm.normalized() - Vec3(p.geometric_normal)).length(), 0, 1e-5);
        const Vec3 expected = (~state.orientation).rotateVector(arm);
        // 1e-4 rad of orientation at the end of the arm.
        ASSERT_NEAR((Vec3(p.object_position) - expected).length(), 0, 1e-5);
    }
}

TEST(MovingBall, ScaleOfItsTransform_IsItsOnlyPart) {
    SceneBuilder builder;
    builder.add_moving(SphereShape{0.1}, tumbling(), Vec3(2));
    const BuiltScene scene(builder, kOpen, kOpen);
    const Vec3 centre = builder.tracks[0].sample(kOpen).position;
    Hit hit;
    ASSERT_TRUE(scene.frame.structure().closest_hit(ray_from(centre + Vec3(0, 0, 1), centre), hit));
    EXPECT_NEAR(hit.t, 0.8, 1e-6);
}

TEST(MovingBall, ImpactInsideTheShutter_LeavesACorner) {
    // Along x until 0.5 s, then along y: the ball is always on one of the two lines.
    SceneBuilder builder;
    sim::Key a = key_at(0, Vec3(0, 0, 0), Vec3(1, 0, 0));
    sim::Key b = key_at(0.5, Vec3(0.5, 0, 0), Vec3(1, 0, 0));
    const sim::Key c = key_at(1, Vec3(0.5, 0.5, 0), Vec3(0, 1, 0));
    b.velocity_out = Vec3(0, 1, 0);
    builder.add_moving(SphereShape{0.01}, {a, b, c});
    const BuiltScene scene(builder, 0, 1);
    for (int i = 0; i < 1000; ++i) {
        const float time = static_cast<float>(i) / 1000;
        const double t = static_cast<double>(time);
        const Vec3 centre = t < 0.5 ? Vec3(t, 0, 0) : Vec3(0.5, t - 0.5, 0);
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(
            ray_from(centre + Vec3(0, 0, 1), centre, time), hit));
        ASSERT_NEAR(hit.t, 0.99, 1e-6) << time;
    }
}

/// Nearest hit of the object in its own axes, in double precision.
std::optional<double> expected_hit(const MotionState& state, const Vec3& half, const Ray& ray) {
    const Quat back = ~state.orientation;
    const Vec3 origin = back.rotateVector(Vec3(ray.origin) - state.position);
    const Vec3 direction = back.rotateVector(Vec3(ray.direction));
    return intersect_unit_shape<ShapeKind::box>(
        RaySegment<double>{origin / half, direction / half});
}

void expect_box_hits(const SceneBuilder& builder, const Vec3& half, const StructureMaker& maker) {
    const BuiltScene scene(builder, kOpen, kClose, maker);
    TestRandom random(2);
    int hits = 0;
    int differing = 0;
    for (int i = 0; i < 20'000; ++i) {
        const float time = random.unit();
        const MotionState state = builder.tracks[0].sample(scene_time(time));
        const Ray ray = ray_from(state.position + random_vector(random, 2),
                                 state.position + random_vector(random, 0.5f), time);
        const auto expected = expected_hit(state, half, ray);
        Hit hit;
        const bool found = scene.frame.structure().closest_hit(ray, hit);
        ASSERT_EQ(found, scene.frame.structure().any_hit(ray));
        if (found != expected.has_value()) {
            ++differing;  // rays next to an edge, which 1e-4 rad may move by 5e-5 m
            continue;
        }
        if (found) {
            ++hits;
            const SurfacePoint p = scene.frame.surface_at(ray, hit);
            const Vec3 local = (~state.orientation).rotateVector(Vec3(p.position) - state.position);
            double off = 1;
            for (int axis = 0; axis < 3; ++axis) {
                off = std::min(off, std::abs(std::abs(local[axis]) - half[axis]));
                ASSERT_LE(std::abs(local[axis]), half[axis] + 1e-4);
            }
            ASSERT_LE(off, 1e-4);
            ASSERT_NEAR((Vec3(p.object_position) - local).length(), 0, 1e-4);
        }
    }
    EXPECT_GT(hits, 4'000);
    EXPECT_LT(differing, 20);
}

TEST(MovingBox, TumblingBox_IsWhereTheTrackHasIt) {
    SceneBuilder builder;
    builder.add_moving(BoxShape{Vec3(0.2, 0.4, 0.3)}, tumbling(), Vec3(1, 2, 1));
    for (const StructureMaker& maker :
         {StructureMaker(), structure_maker(AccelerationKind::embree)}) {
        expect_box_hits(builder, Vec3(0.1, 0.4, 0.15), maker);
    }
}

/// All points within `radius` of the box |p| <= core.
void expect_round_hits(const Shape& shape, const Vec3& core, double radius,
                       const StructureMaker& maker) {
    SceneBuilder builder;
    builder.add_moving(shape, tumbling());
    const BuiltScene scene(builder, kOpen, kClose, maker);
    TestRandom random(7);
    for (int i = 0; i < 20'000; ++i) {
        const float time = random.unit();
        const MotionState state = builder.tracks[0].sample(scene_time(time));
        // Towards a point within the core, from outside or, for every third ray, from another point
        // of the core.
        const Vec3 to = random_vector(random, 1) * core;
        const Vec3 from = i % 3 == 0 ? random_vector(random, 1) * core : random_vector(random, 2);
        const auto in_world = [&](const Vec3& p) {
            return state.position + state.orientation.rotateVector(p);
        };
        const Ray ray = ray_from(in_world(from), in_world(to), time);
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit)) << i;
        ASSERT_TRUE(scene.frame.structure().any_hit(ray));
        const SurfacePoint point = scene.frame.surface_at(ray, hit);
        const Quat back = ~state.orientation;
        const Vec3 p = back.rotateVector(Vec3(point.position) - state.position);
        Vec3 out = p;
        for (int axis = 0; axis < 3; ++axis) {
            out[axis] -= std::clamp(p[axis], -core[axis], core[axis]);
        }
        ASSERT_NEAR(out.length(), radius, 1e-4) << i;
        const Vec3 normal = back.rotateVector(Vec3(point.geometric_normal));
        ASSERT_LT((normal - out.normalized()).length(), 2e-3) << i;  // 1e-4 m of the radius
    }
}

TEST(MovingCapsule, TumblingCapsule_IsWhereTheTrackHasIt) {
    for (const StructureMaker& maker :
         {StructureMaker(), structure_maker(AccelerationKind::embree)}) {
        expect_round_hits(CapsuleShape{0.1, 0.5}, Vec3(0, 0, 0.25), 0.1, maker);
    }
}

TEST(MovingRoundedBox, TumblingBox_IsWhereTheTrackHasIt) {
    for (const StructureMaker& maker :
         {StructureMaker(), structure_maker(AccelerationKind::embree)}) {
        expect_round_hits(RoundedBoxShape{Vec3(0.4, 0.5, 0.8), 0.1}, Vec3(0.1, 0.15, 0.3), 0.1,
                          maker);
    }
}

TEST(MovingMesh, TumblingMesh_IsWhereTheTrackHasIt) {
    SceneBuilder builder;
    builder.add_moving(cube_mesh(), tumbling(), Vec3(0.1, 0.4, 0.15));
    for (const StructureMaker& maker :
         {StructureMaker(), structure_maker(AccelerationKind::embree)}) {
        expect_box_hits(builder, Vec3(0.1, 0.4, 0.15), maker);
    }
}

// Bounds hold the shape at every time, and are tighter than those of a ball around it.
TEST(SweptBounds, OfATumblingTile_HoldItsCornersAndLittleElse) {
    const sim::Track track("tile", tumbling());
    const render::RigidMotion motion(track, kOpen, kClose);
    const V3f half(0.01f, 0.03f, 0.06f);
    const render::Affine offset{Imath::M33f(), V3f(0.02f, 0, 0)};
    const float radius = half.length() + 0.02f;
    const Imath::Box3f bounds = render::swept_bounds(motion, radius, offset, half);
    for (int step = 0; step <= 1000; ++step) {
        const float time = static_cast<float>(step) / 1000;
        for (int corner = 0; corner < 8; ++corner) {
            const V3f side((corner & 1) != 0 ? half.x : -half.x,
                           (corner & 2) != 0 ? half.y : -half.y,
                           (corner & 4) != 0 ? half.z : -half.z);
            const V3f point = motion.position(time) +
                              render::rotate(motion.world_from_body(time), offset.point(side));
            ASSERT_TRUE(bounds.intersects(point)) << time << " " << corner;
        }
    }
    const Imath::Box3f ball = render::swept_bounds(motion, radius);
    EXPECT_LT(bounds.size().x * bounds.size().y * bounds.size().z,
              0.9f * ball.size().x * ball.size().y * ball.size().z);
}

/// The number of rays that hit; `hybrid` and Embree must give the same hits, except for the last
/// bits on meshes, for which Embree has its own test.
int compare_structures(const SceneBuilder& builder, int rays) {
    const BuiltScene hybrid(builder, kOpen, kClose);
    const BuiltScene embree(builder, kOpen, kClose, structure_maker(AccelerationKind::embree));
    TestRandom random(3);
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        const Vec3 from = random_vector(random, 2);
        const Ray ray = ray_from(from, random_vector(random), random.unit());
        Hit a;
        Hit b;
        const bool found = hybrid.frame.structure().closest_hit(ray, a);
        EXPECT_EQ(found, embree.frame.structure().closest_hit(ray, b));
        EXPECT_EQ(a.object, b.object) << i;
        if (found) {
            EXPECT_NEAR(a.t, b.t, is_on_mesh(a) ? 2e-6f * (1 + a.t) : 0) << i;
        }
        EXPECT_EQ(hybrid.frame.structure().any_hit(ray), found);
        hits += found ? 1 : 0;
    }
    return hits;
}

TEST(FrameScene, StructuresAgreeOnAWholeScene) {
    SceneBuilder builder;
    builder.add_moving(SphereShape{0.1}, tumbling());
    builder.add_moving(BoxShape{Vec3(0.2, 0.4, 0.3)}, tumbling());
    builder.add_moving(cube_mesh(), tumbling(), Vec3(0.05));
    builder.add_moving(RectangleShape{Vec2(0.4, 0.4)}, tumbling());
    builder.add(PlaneShape{}, placed(Vec3(0, 0, -0.4)));
    builder.add(BoxShape{Vec3(0.3, 0.3, 0.3)}, placed(Vec3(0.5, 0.4, 0)));
    builder.add(cube_mesh(), placed(Vec3(-0.3, 0.4, 0), Quat(), Vec3(0.1)));
    builder.scene.lights.push_back({"lamp", RectangleLight{}});
    builder.scene.lights.push_back({"bulb", SphereLight{}});
    EXPECT_GT(compare_structures(builder, 50'000), 10'000);
}

// Static shapes stay in one tree from frame to frame, unless too many others move.
TEST(FrameScene, StructuresAgreeOnManyStaticBalls) {
    for (const int moving : {0, 5, 500}) {
        SceneBuilder builder;
        TestRandom random(4);
        for (int i = 0; i < 600; ++i) {
            const float size = i < 4 ? 0.3f : 0.03f;
            builder.add(SphereShape{size}, placed(random_vector(random, 1.5)));
        }
        builder.add(PlaneShape{}, placed(Vec3(0, 0, -1.4)));
        for (int i = 0; i < moving; ++i) {
            std::vector<sim::Key> keys = tumbling();
            const Vec3 shift = random_vector(random, 1);
            for (sim::Key& key : keys) {
                key.position += shift;
            }
            if (i % 2 == 0) {
                builder.add_moving(SphereShape{0.05}, keys);
            } else {
                builder.add_moving(BoxShape{Vec3(0.1)}, keys);
            }
        }
        EXPECT_GT(compare_structures(builder, 20'000), 5'000) << moving;
    }
}

TEST(FrameScene, ZeroLengthShutter_IsTheSharpSceneAtAnyRayTime) {
    SceneBuilder builder;
    builder.add_moving(SphereShape{0.1}, tumbling());
    builder.add_moving(BoxShape{Vec3(0.2, 0.4, 0.3)}, tumbling());
    builder.add_moving(cube_mesh(), tumbling(), Vec3(0.05));
    const BuiltScene scene(builder, 0.4, 0.4);
    TestRandom random(4);
    for (int i = 0; i < 5'000; ++i) {
        const Vec3 from = random_vector(random, 2);
        const Vec3 to = Vec3(0.4, 0.05, 0.1) + random_vector(random, 0.4f);
        Ray ray = ray_from(from, to, 0);
        Hit a;
        Hit b;
        const bool found = scene.frame.structure().closest_hit(ray, a);
        const SurfacePoint p = found ? scene.frame.surface_at(ray, a) : SurfacePoint{};
        ray.time = random.unit();
        ASSERT_EQ(scene.frame.structure().closest_hit(ray, b), found);
        ASSERT_EQ(a.t, b.t);
        ASSERT_EQ(a.object, b.object);
        if (found) {
            const SurfacePoint q = scene.frame.surface_at(ray, b);
            ASSERT_EQ(p.position, q.position);
            ASSERT_EQ(p.geometric_normal, q.geometric_normal);
            ASSERT_EQ(p.object_position, q.object_position);
        }
    }
}

TEST(FrameScene, Moved_CarriesAPointWithItsObject) {
    SceneBuilder builder;
    const std::uint32_t ball = builder.add_moving(SphereShape{0.1}, tumbling());
    const std::uint32_t floor = builder.add(PlaneShape{}, Mat44());
    const BuiltScene scene(builder, kOpen, kClose);
    const MotionState from = builder.tracks[0].sample(scene_time(0.25f));
    const MotionState to = builder.tracks[0].sample(scene_time(0.75f));
    const Vec3 arm(0.03, -0.05, 0.08);
    const V3f start(from.position + from.orientation.rotateVector(arm));
    const Vec3 end = to.position + to.orientation.rotateVector(arm);
    EXPECT_NEAR((Vec3(scene.frame.moved(ball, start, 0.25f, 0.75f)) - end).length(), 0, 2e-5);
    EXPECT_EQ(scene.frame.moved(floor, start, 0.25f, 0.75f), start);
}

}  // namespace
}  // namespace carom::test
