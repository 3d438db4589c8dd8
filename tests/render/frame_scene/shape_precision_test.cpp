// Every shape under maps that scale, shear and mirror it, against plain double precision.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "lab/structures/make_structure.h"
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
    for (const StructureMaker& maker :
         {StructureMaker(), structure_maker(AccelerationKind::embree)}) {
        TestRandom random(11);
        for (const Case& c : cases()) {
            Tally tally;
            for (int repeat = 0; repeat < 12; ++repeat) {
                const Mat44 map = random_affine(random);
                SceneBuilder builder;
                builder.add(c.shape, map);
                const BuiltScene scene(builder, 0, 0, maker);
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

}  // namespace
}  // namespace carom::test
