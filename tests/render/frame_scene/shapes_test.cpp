// Every shape under maps that scale, shear and mirror it, against plain double precision.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/render/frame_scene/scene_helpers.h"

namespace carom::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNone = std::numeric_limits<double>::infinity();

/// Nearest t > 0 at which a ray in object axes hits a shape.
using Reference = std::function<double(const Vec3& o, const Vec3& d)>;

double on_flat(const Vec3& o, const Vec3& d, const std::function<bool(double, double)>& inside) {
    const double t = -o.z / d.z;
    return t > 0 && inside(o.x + t * d.x, o.y + t * d.y) ? t : kNone;
}

/// Radius r0 at z = -h / 2 and r1 at h / 2, with both ends.
double on_frustum(const Vec3& o, const Vec3& d, double r0, double r1, double h) {
    const double k = (r1 - r0) / h;
    const double r = r0 + k * (o.z + 0.5 * h);
    const double a = d.x * d.x + d.y * d.y - k * k * d.z * d.z;
    const double b = o.x * d.x + o.y * d.y - k * r * d.z;
    const double c = o.x * o.x + o.y * o.y - r * r;
    double nearest = kNone;
    const auto offer = [&](double t, bool valid) {
        nearest = valid && t > 0 ? std::min(nearest, t) : nearest;
    };
    if (b * b - a * c >= 0) {
        for (const double sign : {-1.0, 1.0}) {
            const double t = (-b + sign * std::sqrt(b * b - a * c)) / a;
            offer(t, std::abs(o.z + t * d.z) <= 0.5 * h);
        }
    }
    for (const double end : {-1.0, 1.0}) {
        const double t = (end * 0.5 * h - o.z) / d.z;
        const double radius = end < 0 ? r0 : r1;
        offer(t, std::hypot(o.x + t * d.x, o.y + t * d.y) <= radius);
    }
    return nearest;
}

/// Distance of a point from a convex body's core.
using Distance = std::function<double(const Vec3& p)>;

/// All points within `radius` of a convex core. The distance from the core along a line is convex:
/// its minimum is found by ternary search, and the points where it is `radius` on both sides of the
/// minimum by bisection.
double on_rounded(const Vec3& o, const Vec3& d, double radius, const Distance& distance) {
    const auto at = [&](double t) { return distance(o + t * d); };
    double low = -1e3;
    double high = 1e3;
    for (int i = 0; i < 200; ++i) {
        const double third = (high - low) / 3;
        if (at(low + third) < at(high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    const double middle = 0.5 * (low + high);
    if (at(middle) > radius) {
        return kNone;
    }
    for (const double side : {-1.0, 1.0}) {
        double in = middle;
        double out = middle + side * 1e3;
        for (int i = 0; i < 70; ++i) {
            const double t = 0.5 * (in + out);
            (at(t) <= radius ? in : out) = t;
        }
        if (in > 0) {
            return in;
        }
    }
    return kNone;
}

double beyond(double p, double half) {
    return std::max(std::abs(p) - half, 0.0);
}

struct Case {
    const char* name;
    Shape shape;
    Reference reference;
    /// Whether the uv belong to the point, given in object axes.
    std::function<bool(const Vec3& p, const V2f& uv)> has_uv;
};

bool near(double a, double b) {
    return std::abs(a - b) < 1e-4;
}

bool near_turn(float uv, const Vec3& p) {
    const double turn = std::atan2(p.y, p.x) / (2 * kPi) - static_cast<double>(uv);
    return std::abs(turn - std::round(turn)) < 1e-4;
}

std::vector<Case> cases() {
    const auto across = [](double w, double h) {
        return [w, h](const Vec3& p, const V2f& uv) {
            return near(uv.x, p.x / w + 0.5) && near(uv.y, p.y / h + 0.5);
        };
    };
    const auto around = [](double radius, double height) {
        return [radius, height](const Vec3& p, const V2f& uv) {
            if (std::abs(std::abs(p.z) - 0.5 * height) < 1e-4) {
                return true;  // the ends are tested below
            }
            static_cast<void>(radius);
            return near_turn(uv.x, p) && near(uv.y, p.z / height + 0.5);
        };
    };
    const Vec3 a(0.3, -0.2, 0.1);
    const Vec3 u(0.9, 0.2, -0.3);
    const Vec3 v(-0.1, 0.8, 0.5);
    const auto weights = [=](const Vec3& p) {
        const Vec3 n = u.cross(v);
        const double area2 = n.dot(n);
        return Vec2((p - a).cross(v).dot(n) / area2, u.cross(p - a).dot(n) / area2);
    };
    const auto on_edges = [=](const std::function<bool(const Vec2&)>& inside) -> Reference {
        return [=](const Vec3& o, const Vec3& d) {
            const Vec3 n = u.cross(v);
            const double t = (a - o).dot(n) / d.dot(n);
            return t > 0 && inside(weights(o + t * d)) ? t : kNone;
        };
    };
    const auto uv_is_weights = [=](const Vec3& p, const V2f& uv) {
        const Vec2 w = weights(p);
        return near(uv.x, w.x) && near(uv.y, w.y);
    };
    return {
        {"triangle", TriangleShape{{a, a + u, a + v}},
         on_edges([](const Vec2& w) { return w.x >= 0 && w.y >= 0 && w.x + w.y <= 1; }),
         uv_is_weights},
        {"parallelogram", ParallelogramShape{a, u, v},
         on_edges([](const Vec2& w) { return w.x >= 0 && w.y >= 0 && w.x <= 1 && w.y <= 1; }),
         uv_is_weights},
        {"rectangle", RectangleShape{Vec2(1.4, 0.6)},
         [](const Vec3& o, const Vec3& d) {
             return on_flat(
                 o, d, [](double x, double y) { return std::abs(x) <= 0.7 && std::abs(y) <= 0.3; });
         },
         across(1.4, 0.6)},
        {"disk", DiskShape{0.8},
         [](const Vec3& o, const Vec3& d) {
             return on_flat(o, d, [](double x, double y) { return std::hypot(x, y) <= 0.8; });
         },
         across(1.6, 1.6)},
        {"cylinder", CylinderShape{0.5, 1.2},
         [](const Vec3& o, const Vec3& d) { return on_frustum(o, d, 0.5, 0.5, 1.2); },
         around(0.5, 1.2)},
        {"cone", ConeShape{0.7, 0, 1.1},
         [](const Vec3& o, const Vec3& d) { return on_frustum(o, d, 0.7, 0, 1.1); },
         around(0.7, 1.1)},
        {"funnel", ConeShape{0.2, 0.6, 0.9},
         [](const Vec3& o, const Vec3& d) { return on_frustum(o, d, 0.2, 0.6, 0.9); },
         around(0.6, 0.9)},
        {"capsule", CapsuleShape{0.4, 1.1},
         [](const Vec3& o, const Vec3& d) {
             return on_rounded(
                 o, d, 0.4, [](const Vec3& p) { return std::hypot(p.x, p.y, beyond(p.z, 0.55)); });
         },
         [](const Vec3& p, const V2f& uv) {
             // The length along the surface from the lower pole.
             const double on_axis = std::clamp(p.z, -0.55, 0.55);
             const double latitude = std::atan2(p.z - on_axis, std::hypot(p.x, p.y));
             const double arc_length = 0.4 * (0.5 * kPi + latitude) + on_axis + 0.55;
             return near_turn(uv.x, p) && near(uv.y, arc_length / (0.4 * kPi + 1.1));
         }},
        {"rounded box", RoundedBoxShape{Vec3(1, 0.8, 1.2), 0.25},
         [](const Vec3& o, const Vec3& d) {
             return on_rounded(o, d, 0.25, [](const Vec3& p) {
                 return std::hypot(beyond(p.x, 0.25), beyond(p.y, 0.15), beyond(p.z, 0.35));
             });
         },
         [](const Vec3& p, const V2f& uv) {
             const Vec3 size(1, 0.8, 1.2);
             for (int axis = 0; axis < 3; ++axis) {
                 const int next = (axis + 1) % 3;
                 const int last = (axis + 2) % 3;
                 if (near(uv.x, p[next] / size[next] + 0.5) &&
                     near(uv.y, p[last] / size[last] + 0.5)) {
                     return true;  // on one of the sides
                 }
             }
             return false;
         }},
    };
}

/// Scaled, sheared, rotated, translated, and every other time mirrored.
Mat44 random_affine(TestRandom& random) {
    Mat44 m;
    for (;;) {
        for (int row = 0; row < 3; ++row) {
            for (int axis = 0; axis < 3; ++axis) {
                m[row][axis] = static_cast<double>(random.between(-1.5f, 1.5f));
            }
            m[3][row] = static_cast<double>(random.between(-3, 3));
        }
        if (std::abs(m.determinant()) > 0.3) {
            return m;
        }
    }
}

/// The numbers of rays compared.
struct Tally {
    int hits = 0;
    int differing = 0;
};

void compare(const BuiltScene& scene, const Case& c, const Mat44& world_from_object, const Ray& ray,
             Tally& tally) {
    const Mat44 back = world_from_object.inverse();
    Vec3 o;
    Vec3 d;
    back.multVecMatrix(Vec3(ray.origin), o);
    back.multDirMatrix(Vec3(ray.direction), d);
    const double expected = c.reference(o, d);
    Hit hit;
    const bool found = scene.frame.structure().closest_hit(ray, hit);
    ASSERT_EQ(found, scene.frame.structure().any_hit(ray));
    const bool same = found == std::isfinite(expected) &&
                      (!found || std::abs(hit.t - expected) < 1e-3 * (1 + expected));
    if (!same) {
        ++tally.differing;  // next to a rim, or grazing
        return;
    }
    if (!found) {
        return;
    }
    ++tally.hits;
    const SurfacePoint point = scene.frame.surface_at(ray, hit);
    const Vec3 place = Vec3(ray.origin) + expected * Vec3(ray.direction);
    ASSERT_LT((Vec3(point.position) - place).length(), 2e-3) << c.name;
    Vec3 p;
    back.multVecMatrix(Vec3(point.position), p);
    ASSERT_TRUE(c.has_uv(p, point.uv)) << c.name << ' ' << p << ' ' << point.uv;
    Vec3 scaled;
    back.multVecMatrix(Vec3(point.position), scaled);
    scaled *= axis_scales(world_from_object);
    ASSERT_LT((Vec3(point.object_position) - scaled).length(), 1e-4) << c.name;
    // Neighbouring points of the reference's surface lie in the tangent plane.
    const double step = 1e-4;
    const Vec3 n(point.geometric_normal);
    ASSERT_NEAR(n.length(), 1, 1e-5);
    const double facing = n.dot(Vec3(ray.direction));
    if (std::abs(facing) < 0.2) {
        return;
    }
    Vec3 beside[2];
    Vec3 axis = Vec3(0);
    axis[std::abs(ray.direction.x) < 0.5f ? 0 : 1] = 1;
    beside[0] = Vec3(ray.direction).cross(axis).normalized();
    beside[1] = Vec3(ray.direction).cross(beside[0]);
    for (const Vec3& side : beside) {
        const Vec3 shift = side * back - Vec3(0) * back;
        const double t = c.reference(o + step * shift, d);
        const double opposite = c.reference(o - step * shift, d);
        if (!(std::abs(t + opposite - 2 * expected) < 0.1 * step)) {
            continue;  // beyond a rim
        }
        const Vec3 tangent = (step * side + (t - expected) * Vec3(ray.direction)).normalized();
        ASSERT_NEAR(tangent.dot(n), 0, 0.02) << c.name << " at " << p;
    }
}

TEST(Shapes, UnderAnyAffineMap_HitsPlacesNormalsAndUvAreThoseOfDoublePrecision) {
    for (const AccelerationKind kind : {AccelerationKind::hybrid, AccelerationKind::embree}) {
        TestRandom random(11);
        for (const Case& c : cases()) {
            Tally tally;
            for (int repeat = 0; repeat < 12; ++repeat) {
                const Mat44 map = random_affine(random);
                SceneBuilder builder;
                builder.add(c.shape, map);
                const BuiltScene scene(builder, 0, 0, kind);
                const Vec3 centre(map[3][0], map[3][1], map[3][2]);
                for (int i = 0; i < 1500; ++i) {
                    const float distance = i % 3 == 0 ? 0.5f : (i % 3 == 1 ? 4 : 40);
                    const Ray ray = ray_from(centre + random_vector(random, distance),
                                             centre + random_vector(random, 0.7f));
                    compare(scene, c, map, ray, tally);
                    if (HasFatalFailure()) {
                        return;
                    }
                }
            }
            EXPECT_GT(tally.hits, 1500) << c.name;
            EXPECT_LE(tally.differing, 5) << c.name;
        }
    }
}

SurfacePoint look(const Shape& shape, const Vec3& from, const Vec3& to) {
    SceneBuilder builder;
    builder.add(shape, Mat44());
    const BuiltScene scene(builder);
    const Ray ray = ray_from(from, to);
    Hit hit;
    EXPECT_TRUE(scene.frame.structure().closest_hit(ray, hit));
    return scene.frame.surface_at(ray, hit);
}

void expect_near(const V3f& a, const Vec3& b) {
    EXPECT_NEAR((Vec3(a) - b).length(), 0, 2e-6) << a << " and " << b;
}

TEST(Shapes, Triangle_FrontIsWhereItsCornersRunCounterClockwise) {
    const TriangleShape triangle{{Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(0, 3, 1)}};
    const SurfacePoint above = look(triangle, Vec3(0.5, 0.75, 5), Vec3(0.5, 0.75, 0));
    expect_near(above.position, Vec3(0.5, 0.75, 1));
    expect_near(above.geometric_normal, Vec3(0, 0, 1));
    EXPECT_NEAR((above.uv - V2f(0.25f, 0.25f)).length(), 0, 1e-6);
    const SurfacePoint below = look(triangle, Vec3(0.5, 0.75, -5), Vec3(0.5, 0.75, 0));
    expect_near(below.geometric_normal, Vec3(0, 0, 1));
}

TEST(Shapes, CylinderEnds_AreFlatAndCarryThePictureOfADisk) {
    const CylinderShape cylinder{0.5, 2};
    const SurfacePoint top = look(cylinder, Vec3(0.25, 0.1, 5), Vec3(0.25, 0.1, 0));
    expect_near(top.position, Vec3(0.25, 0.1, 1));
    expect_near(top.geometric_normal, Vec3(0, 0, 1));
    EXPECT_NEAR((top.uv - V2f(0.75f, 0.6f)).length(), 0, 1e-6);
    const SurfacePoint bottom = look(cylinder, Vec3(0.25, 0.1, -5), Vec3(0.25, 0.1, 0));
    expect_near(bottom.geometric_normal, Vec3(0, 0, -1));
    const SurfacePoint inside = look(cylinder, Vec3(0, 0, 0), Vec3(0, 0, 3));
    expect_near(inside.position, Vec3(0, 0, 1));
    expect_near(inside.geometric_normal, Vec3(0, 0, 1));
}

TEST(Shapes, Cone_NormalLeansUpBySlope) {
    // Radius 1 at z = -1, tip at z = 1: the side's normal is (2, 1) / sqrt 5.
    const SurfacePoint side = look(ConeShape{1, 0, 2}, Vec3(5, 0, 0), Vec3(0, 0, 0));
    expect_near(side.position, Vec3(0.5, 0, 0));
    expect_near(side.geometric_normal, Vec3(2, 0, 1) / std::sqrt(5.0));
}

TEST(Shapes, Capsule_IsHitAlongItsAxisAndFromInside) {
    const CapsuleShape capsule{0.5, 2};
    const SurfacePoint pole = look(capsule, Vec3(0, 0, 5), Vec3(0, 0, 0));
    expect_near(pole.position, Vec3(0, 0, 1.5));
    expect_near(pole.geometric_normal, Vec3(0, 0, 1));
    // Parallel to the axis, 0.4 beside it: the end is 0.3 above the hemisphere's centre.
    const SurfacePoint end = look(capsule, Vec3(0, 0.4, -5), Vec3(0, 0.4, 0));
    expect_near(end.position, Vec3(0, 0.4, -1.3));
    expect_near(end.geometric_normal, Vec3(0, 0.8, -0.6));
    const SurfacePoint inside = look(capsule, Vec3(0, 0.4, 0), Vec3(0, 0.4, 1));
    expect_near(inside.position, Vec3(0, 0.4, 1.3));
    const SurfacePoint side = look(capsule, Vec3(0, 0, 0.25), Vec3(3, 0, 0.25));
    expect_near(side.position, Vec3(0.5, 0, 0.25));
    expect_near(side.geometric_normal, Vec3(1, 0, 0));
}

TEST(Shapes, CapsuleSeam_PlaceAndNormalAreContinuous) {
    SceneBuilder builder;
    builder.add(CapsuleShape{0.5, 2}, Mat44());
    const BuiltScene scene(builder);
    std::optional<SurfacePoint> before;
    for (int i = -2000; i <= 2000; ++i) {
        const double height = 1 + 1e-5 * i;  // across the seam at z = 1
        const Ray ray = ray_from(Vec3(5, 0.2, height), Vec3(0, 0.2, height));
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit));
        const SurfacePoint point = scene.frame.surface_at(ray, hit);
        if (before) {
            ASSERT_LT((point.position - before->position).length(), 2e-5f);
            ASSERT_LT((point.geometric_normal - before->geometric_normal).length(), 5e-5f);
            ASSERT_LT((point.uv - before->uv).length(), 2e-5f);
        }
        before = point;
    }
}

TEST(Shapes, RoundedBox_FlatSidesEdgesAndCornersAreWhereTheyBelong) {
    const RoundedBoxShape box{Vec3(2, 1, 3), 0.25};  // core: 0.75, 0.25, 1.25
    const SurfacePoint flat = look(box, Vec3(0.7, 0.2, 9), Vec3(0.7, 0.2, 0));
    expect_near(flat.position, Vec3(0.7, 0.2, 1.5));
    EXPECT_EQ(flat.geometric_normal, V3f(0, 0, 1));
    EXPECT_NEAR((flat.uv - V2f(0.85f, 0.7f)).length(), 0, 1e-6);
    // Down onto the edge along y at +x, +z: 0.15 beyond the core, so 0.2 above it.
    const SurfacePoint edge = look(box, Vec3(0.9, 0.1, 9), Vec3(0.9, 0.1, 0));
    expect_near(edge.position, Vec3(0.9, 0.1, 1.45));
    expect_near(edge.geometric_normal, Vec3(0.6, 0, 0.8));
    // Straight at a corner, and from the centre out through it.
    const Vec3 corner(0.75, 0.25, 1.25);
    const Vec3 out = Vec3(1, 1, 1).normalized();
    for (const Vec3& from : {corner + 3.0 * out, corner - 0.1 * out}) {
        const SurfacePoint point = look(box, from, corner + 0.25 * out);
        expect_near(point.position, corner + 0.25 * out);
        expect_near(point.geometric_normal, out);
    }
    // Through the corner of the bounding box, outside the rounded shape.
    SceneBuilder builder;
    builder.add(box, Mat44());
    const BuiltScene scene(builder);
    Hit hit;
    EXPECT_FALSE(scene.frame.structure().closest_hit(
        ray_from(Vec3(0.99, 0.49, 9), Vec3(0.99, 0.49, 0)), hit));
    EXPECT_TRUE(scene.frame.structure().closest_hit(
        ray_from(Vec3(-0.9, -0.4, 9), Vec3(-0.9, -0.4, 0)), hit));
}

TEST(Shapes, RoundedBoxWithoutACore_IsASphere) {
    TestRandom random(18);
    SceneBuilder round;
    round.add(RoundedBoxShape{Vec3(1, 1, 1), 0.5}, Mat44());
    SceneBuilder ball;
    ball.add(SphereShape{0.5}, Mat44());
    SceneBuilder pill;
    pill.add(CapsuleShape{0.5, 1}, Mat44());
    SceneBuilder long_box;
    long_box.add(RoundedBoxShape{Vec3(1, 1, 2), 0.5}, Mat44());
    const BuiltScene scenes[] = {BuiltScene(round), BuiltScene(ball), BuiltScene(long_box),
                                 BuiltScene(pill)};
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = ray_from(random_vector(random, 2), random_vector(random, 0.7f));
        for (const int pair : {0, 2}) {
            Hit a;
            Hit b;
            const bool found = scenes[pair].frame.structure().closest_hit(ray, a);
            if (found != scenes[pair + 1].frame.structure().closest_hit(ray, b)) {
                ADD_FAILURE() << i;
            } else if (found) {
                ++hits;
                ASSERT_NEAR(a.t, b.t, 5e-4f) << i;  // the error of grazing rays
            }
        }
    }
    EXPECT_GT(hits, 10'000);
}

TEST(Shapes, SlenderCapsule_IsHitAllAlongItsLength) {
    // A thousand radii long, from all directions, including rays along it.
    TestRandom random(17);
    SceneBuilder builder;
    const Mat44 map = placed(Vec3(1, 2, 3), turn_about(Vec3(1, 2, 0), 1.1));
    builder.add(CapsuleShape{0.002, 2}, map);
    const BuiltScene scene(builder);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 aim = Vec3(0, 0, static_cast<double>(random.between(-1, 1)));
        const Vec3 from = aim + random_vector(random, 1) * Vec3(0.1, 0.1, 1);
        const Ray ray = ray_from(from * map, aim * map);
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit)) << i;
        const Vec3 p = Vec3(scene.frame.surface_at(ray, hit).position) * map.inverse();
        ASSERT_NEAR(std::hypot(p.x, p.y, beyond(p.z, 1)), 0.002, 2e-6) << i;
    }
}

TEST(Shapes, RaysParallelToAConesSide_HitTheOtherSide) {
    // The quadratic's leading term vanishes: down along the generator at +x, shifted inwards.
    const Vec3 down = Vec3(0.5, 0, -1).normalized();
    const Vec3 start(-0.25, 0, 0.25);
    const SurfacePoint point = look(ConeShape{1, 0, 2}, start, start + down);
    expect_near(point.position, Vec3(0.375, 0, -1));
    expect_near(point.geometric_normal, Vec3(0, 0, -1));
}

TEST(Shapes, RimsOfCylindersAndCones_LetNoRayThrough) {
    TestRandom random(12);
    SceneBuilder builder;
    const Mat44 map = random_affine(random);
    builder.add(ConeShape{0.7, 0.3, 1.1}, map);
    const BuiltScene scene(builder);
    int tested = 0;
    for (int i = 0; i < 100'000; ++i) {
        // From inside through a point of a rim.
        const double angle = 2 * kPi * static_cast<double>(random.unit());
        const bool is_top = random.next() % 2 == 0;
        const double radius = is_top ? 0.3 : 0.7;
        const Vec3 rim(radius * std::cos(angle), radius * std::sin(angle), is_top ? 0.55 : -0.55);
        const Ray ray = ray_from(random_vector(random, 0.1f) * map, rim * map);
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit)) << i;
        ++tested;
    }
    EXPECT_EQ(tested, 100'000);
}

TEST(Shapes, TrianglesSideBySide_LeaveNoGap) {
    TestRandom random(13);
    for (int repeat = 0; repeat < 50; ++repeat) {
        const Vec3 a = random_vector(random, 2);
        const Vec3 b = random_vector(random, 2);
        const Vec3 c = random_vector(random, 2);
        const Vec3 d = a + b - c + 0.2 * random_vector(random);
        if ((b - a).cross(c - a).length() < 0.3 * (b - a).length() * (c - a).length()) {
            continue;  // too thin
        }
        SceneBuilder builder;
        builder.add(TriangleShape{{a, b, c}}, Mat44());
        builder.add(TriangleShape{{b, a, d}}, Mat44());
        const BuiltScene scene(builder);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 on_edge = a + static_cast<double>(random.between(0.01f, 0.99f)) * (b - a);
            const Vec3 from = on_edge + random_vector(random, 3);
            const Vec3 to_edge = (on_edge - from).normalized();
            if (std::abs(to_edge.dot((b - a).cross(c - a).normalized())) < 0.2 ||
                std::abs(to_edge.dot((b - a).cross(d - a).normalized())) < 0.2) {
                continue;  // grazing
            }
            Hit hit;
            ASSERT_TRUE(scene.frame.structure().closest_hit(ray_from(from, on_edge), hit));
        }
    }
}

TEST(Shapes, TrackedObjects_AreMappedBeforeTheyMove) {
    // Sheared, offset from its body's origin, then rotated by a quarter turn about z and moved
    // along x.
    Mat44 map;
    map[1][0] = 0.5;  // y leans towards x
    map[3][0] = 2;
    for (const AccelerationKind kind : {AccelerationKind::hybrid, AccelerationKind::embree}) {
        SceneBuilder builder;
        const Quat turn = turn_about(Vec3(0, 0, 1), kPi / 2);
        builder.tracks.emplace_back(
            "path", std::vector<sim::Key>{key_at(0, Vec3(0), Vec3(1, 0, 0), Vec3(0), turn),
                                          key_at(1, Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(0), turn)});
        builder.add(BoxShape{Vec3(1, 1, 1)}, map, "path");
        builder.add(ConeShape{1, 0, 2}, Mat44(), "path");
        const BuiltScene scene(builder, 0, 1, kind);
        // The box's point (0.3, 0.4, 0.5) at time 0.5.
        const Vec3 in_body = Vec3(0.3, 0.4, 0.5) * map;
        const Vec3 in_world = turn.rotateVector(in_body) + Vec3(0.5, 0, 0);
        const Ray ray = ray_from(in_world + Vec3(0, 0, 3), in_world, 0.5f);
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit));
        EXPECT_EQ(hit.object, 0u);
        EXPECT_NEAR(hit.t, 3, 1e-5);
        const SurfacePoint point = scene.frame.surface_at(ray, hit);
        expect_near(point.geometric_normal, Vec3(0, 0, 1));
        EXPECT_NEAR((Vec3(point.object_position) - Vec3(0.3, 0.4, 0.5) * axis_scales(map)).length(),
                    0, 1e-5);
        const Ray at_cone = ray_from(Vec3(0.5, -5, 0), Vec3(0.5, 0, 0), 0.5f);
        ASSERT_TRUE(scene.frame.structure().closest_hit(at_cone, hit));
        const SurfacePoint on_cone = scene.frame.surface_at(at_cone, hit);
        EXPECT_EQ(on_cone.object, 1u);
        EXPECT_NEAR((Vec3(on_cone.geometric_normal) - Vec3(0, -2, 1) / std::sqrt(5.0)).length(), 0,
                    1e-5);
    }
}

TEST(Shapes, UvMetres_AreTheLengthsThatUvCross) {
    const auto metres = [](const Shape& shape, const Vec3& from, const Vec3& to) {
        const SurfacePoint point = look(shape, from, to);
        EXPECT_NEAR(
            point.uv_per_metre * point.uv_per_metre * (point.uv_metres.x * point.uv_metres.y), 1,
            1e-5);
        return point.uv_metres;
    };
    const Vec3 above(0.1, 0.2, 9);
    const Vec3 below(0.1, 0.2, -9);
    const auto expect = [](const V2f& found, const V2f& expected) {
        EXPECT_NEAR((found - expected).length(), 0, 1e-5) << found;
    };
    expect(metres(RectangleShape{Vec2(3, 2)}, above, below), V2f(3, 2));
    expect(metres(PlaneShape{}, above, below), V2f(1, 1));
    expect(metres(DiskShape{0.5}, above, below), V2f(1, 1));
    expect(metres(TriangleShape{{Vec3(0), Vec3(3, 0, 0), Vec3(0, 2, 0)}}, above, below), V2f(3, 2));
    expect(metres(ParallelogramShape{Vec3(0), Vec3(3, 0, 0), Vec3(0, 2, 0)}, above, below),
           V2f(3, 2));
    expect(metres(BoxShape{Vec3(3, 2, 5)}, above, below), V2f(3, 2));
    const float turn = static_cast<float>(2 * kPi);
    expect(metres(CylinderShape{0.5, 3}, above, below), V2f(1, 1));
    expect(metres(CylinderShape{0.5, 3}, Vec3(9, 0, 0), Vec3(0)), V2f(0.5f * turn, 3));
    const SurfacePoint on_ball = look(SphereShape{2}, Vec3(9, 0, 0), Vec3(0));
    expect(on_ball.uv_metres, V2f(2 * turn, turn));
}

TEST(Shapes, WithoutArea_AreRefused) {
    const auto message = [](const Shape& shape) -> std::string {
        SceneBuilder builder;
        builder.add(shape, Mat44());
        try {
            const StaticGeometry geometry(builder.scene, RenderSettings{});
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message(TriangleShape{{Vec3(0), Vec3(1, 1, 1), Vec3(2, 2, 2)}}),
              "object 'object0': a triangle's corners lie in a line");
    EXPECT_EQ(message(ParallelogramShape{Vec3(0), Vec3(1, 0, 0), Vec3(0)}),
              "object 'object0': the edges of a parallelogram are parallel");
    EXPECT_EQ(message(DiskShape{0}), "object 'object0': the radius must be greater than 0");
    EXPECT_EQ(message(CylinderShape{1, -1}), "object 'object0': the height must be greater than 0");
    EXPECT_EQ(message(ConeShape{0, 0, 1}),
              "object 'object0': the larger radius of a cone must be greater than 0");
    EXPECT_EQ(message(ConeShape{1, -0.5, 1}),
              "object 'object0': the radii of a cone must not be negative");
}

}  // namespace
}  // namespace carom::test
