#include "lab/triangle/test_set.h"

#include <cmath>
#include <numbers>

#include "core/splitmix.h"

namespace carom::render::triangle {

namespace {

/// Uniform random numbers; those of the standard library differ between implementations.
class Random {
  public:
    explicit Random(std::uint64_t seed) : random_(seed) {}

    double between(double low, double high) { return random_.between(low, high); }
    Imath::V3d in_cube() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
    Imath::V3d direction() {
        const double z = between(-1, 1);
        const double angle = between(0, 2 * std::numbers::pi);
        const double radius = std::sqrt(1 - z * z);
        return {radius * std::cos(angle), radius * std::sin(angle), z};
    }

  private:
    SplitMix64 random_;
};

/// Two unit vectors perpendicular to a third one and to each other.
struct Frame {
    Imath::V3d along, x, y;

    explicit Frame(const Imath::V3d& direction) : along(direction) {
        const Imath::V3d other =
            std::abs(along.x) < 0.5 ? Imath::V3d(1, 0, 0) : Imath::V3d(0, 1, 0);
        x = along.cross(other).normalized();
        y = along.cross(x);
    }
};

constexpr double kBundleRadius = 0.05;  // of the rays' two ends
constexpr double kSteepest = 3;         // tangent of the angle between bundle and normal
constexpr double kSpacing = 0.4;        // > 2 * kBundleRadius * kSteepest: no two triangles overlap

void add_random_groups(TestSet& set, int groups, Random& random) {
    for (int i = 0; i < groups * set.triangles_in_group; ++i) {
        const V3f a(random.in_cube());
        const V3f b(random.in_cube());
        set.triangles.push_back({a, b, V3f(random.in_cube())});
    }
    for (int i = 0; i < groups * set.rays_in_group; ++i) {
        set.origins.emplace_back(random.in_cube());
        set.directions.emplace_back(random.direction());
    }
}

}  // namespace

TestSet make_random_set(int groups, std::uint64_t seed) {
    TestSet set;
    Random random(seed);
    add_random_groups(set, groups, random);
    return set;
}

TestSet make_streamed_set(int rays, int triangles, std::uint64_t seed) {
    TestSet set;
    set.rays_in_group = rays;
    set.triangles_in_group = triangles;
    Random random(seed);
    add_random_groups(set, 1, random);
    return set;
}

TestSet make_worst_set(int groups, std::uint64_t seed) {
    TestSet set;
    Random random(seed);
    for (int group = 0; group < groups; ++group) {
        const Frame frame(random.direction());
        const double length = kSpacing * (set.triangles_in_group + 1);
        const auto in_disk = [&] {
            const double radius = kBundleRadius * std::sqrt(random.between(0, 1));
            const double angle = random.between(0, 2 * std::numbers::pi);
            return radius * (std::cos(angle) * frame.x + std::sin(angle) * frame.y);
        };
        for (int i = 0; i < set.rays_in_group; ++i) {
            const Imath::V3d from = in_disk();
            set.origins.emplace_back(from);
            set.directions.emplace_back((in_disk() + length * frame.along - from).normalized());
        }
        for (int i = set.triangles_in_group; i > 0; --i) {
            const double steepness = kSteepest * random.between(0, 1);
            const double turn = random.between(0, 2 * std::numbers::pi);
            const auto corner = [&](int k) {
                const double angle =
                    turn + 2 * std::numbers::pi * (k + random.between(-0.1, 0.1)) / 3;
                const double radius = random.between(0.3, 0.6);
                const double x = radius * std::cos(angle);
                const double y = radius * std::sin(angle);
                const double depth = kSpacing * i + steepness * x;
                return V3f(x * frame.x + y * frame.y + depth * frame.along);
            };
            const V3f a = corner(0);
            const V3f b = corner(1);
            set.triangles.push_back({a, b, corner(2)});
        }
    }
    return set;
}

TestSet make_edge_set(int groups, std::uint64_t seed) {
    TestSet set;
    set.rays_in_group = 8;
    set.triangles_in_group = 8;
    Random random(seed);
    for (int group = 0; group < groups; ++group) {
        const V3f a(random.in_cube());
        const V3f b(random.in_cube());
        const V3f c(random.in_cube());
        const V3f other(random.in_cube());
        const V3f origin(random.in_cube());
        const V3f across = (a - origin).cross(b - origin);
        if (across.dot(c - origin) * across.dot(other - origin) >= 0) {
            continue;
        }
        set.triangles.insert(set.triangles.end(), 4, {a, b, c});
        set.triangles.insert(set.triangles.end(), 4, {b, a, other});
        for (int i = 0; i < set.rays_in_group; ++i) {
            const float fraction = (static_cast<float>(i) + 0.5f) / 8;
            set.origins.push_back(origin);
            set.directions.push_back((a + fraction * (b - a) - origin).normalized());
        }
    }
    return set;
}

TestSet set_for(Technique technique, TestSet set) {
    for (std::size_t i = 0; i < set.origins.size() && shares_rays(technique); ++i) {
        const std::size_t first = i - i % static_cast<unsigned>(set.rays_in_group);
        std::vector<V3f>& common =
            technique == Technique::common_origin ? set.origins : set.directions;
        common[i] = common[first];
    }
    return set;
}

}  // namespace carom::render::triangle
