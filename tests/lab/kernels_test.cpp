// Every kernel in every variant gives the hits of Möller and Trumbore's kernel.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lab/triangle/kernel_run.h"
#include "lab/triangle/measure.h"
#include "lab/triangle/test_set.h"
#include "lab/triangle/variants.h"

namespace carom::render::triangle {

/// A form with a technique, in all packings and precisions that exist.
struct Tested {
    Form form;
    Technique technique;

    friend bool operator==(const Tested&, const Tested&) = default;
};

void PrintTo(const Tested& tested, std::ostream* out) {
    *out << name(tested.form.kernel) << ' ' << name(tested.form.input) << ' '
         << name(tested.form.division) << ' ' << name(tested.technique);
}

namespace {

using Imath::V3d;

class Kernels : public testing::TestWithParam<Tested> {};

std::string name_of(const testing::TestParamInfo<Tested>& info) {
    const Form& form = info.param.form;
    return std::string(name(form.kernel)) + "_" + std::string(name(form.input)) + "_" +
           std::string(name(form.division)) + "_" + std::string(name(info.param.technique));
}

std::vector<Tested> all_tested() {
    std::vector<Tested> all;
    for_each_variant([&](const Variant& variant) {
        const Tested tested{variant.form, variant.technique};
        if (std::find(all.begin(), all.end(), tested) == all.end()) {
            all.push_back(tested);
        }
    });
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, Kernels, testing::ValuesIn(all_tested()), name_of);

std::vector<Variant> variants_of(const Tested& tested, Precision precision) {
    std::vector<Variant> variants;
    for (const Packing packing : kPackings) {
        const Variant variant{tested.form, packing, precision, tested.technique};
        if (exists(variant)) {
            variants.push_back(variant);
        }
    }
    return variants;
}

std::vector<Variant> variants_of(const Tested& tested) {
    std::vector<Variant> variants;
    for (const Precision precision : kPrecisions) {
        for (const Variant& variant : variants_of(tested, precision)) {
            variants.push_back(variant);
        }
    }
    return variants;
}

std::vector<NearestHit> hits_of(const Variant& variant, const TestSet& set) {
    const auto run = make_run(variant, set);
    if (run == nullptr) {
        ADD_FAILURE() << "no such variant";
        return {};
    }
    EXPECT_EQ(run->packing(), variant.packing);
    run->run();
    return run->hits();
}

/// The intersection of a ray and a triangle in double precision, with bounds on rounding errors.
struct Exact {
    double u, v, t;
    double weight_error;    // for one rounding
    double distance_error;  // for one rounding, relative
    double slack;           // of the sum of angles, in weights

    /// How far inside, in weights; negative outside.
    [[nodiscard]] double depth() const { return std::min({u, v, 1 - u - v}); }
};

/// One rounding of numbers of size S moves the triangle's plane by eps S at the corners, and by L /
/// h times that elsewhere around it, where L is the longest edge and h the height over it: the
/// normal of a sliver is less accurate by that factor. Along a ray that hits the plane at an angle
/// with the sine s, a shift grows by 1 / s; in weights, by 1 / h. Products of edges lose as much.
/// Seen along an axis at an angle with the triangle's normal, both grow by its inverse cosine: once
/// in the plane's equation, once in the projected triangle.
Exact exact(const TestSet& set, std::size_t ray, std::int64_t in_group, double epsilon,
            Technique technique = Technique::plain) {
    const auto group = ray / static_cast<unsigned>(set.rays_in_group);
    const TriangleCorners& triangle =
        set.triangles[group * static_cast<unsigned>(set.triangles_in_group) +
                      static_cast<std::size_t>(in_group)];
    const V3d o(set.origins[ray]);
    const V3d d(set.directions[ray]);
    const V3d a(triangle.a);
    const V3d b(triangle.b);
    const V3d c(triangle.c);
    const V3d normal = (b - a).cross(c - a);
    const double along = normal.dot(d);
    Exact result{};
    result.t = normal.dot(a - o) / along;
    const V3d p = o + result.t * d - a;
    result.u = p.cross(c - a).dot(normal) / normal.dot(normal);
    result.v = (b - a).cross(p).dot(normal) / normal.dot(normal);
    const double longest = std::max({(b - a).length(), (c - a).length(), (c - b).length()});
    const double height = normal.length() / longest;
    const double size =
        std::max({o.length(), a.length(), b.length(), c.length()}) + std::abs(result.t);
    const double cosine =
        technique == Technique::axis_fixed ? std::abs(normal.z) / normal.length() : 1;
    const double shift = epsilon * size * (longest / height) / (std::abs(along) / normal.length()) /
                         (cosine * cosine);
    result.slack = 4 * std::sqrt(epsilon) * longest / height;
    result.weight_error = shift / height;
    result.distance_error = shift / result.t;
    return result;
}

/// Roundings that may add up; the largest observed value is less than half of this.
constexpr double kRoundings = 4;

double epsilon_of(Precision precision) {
    return precision == Precision::single_precision
               ? static_cast<double>(std::numeric_limits<float>::epsilon())
               : std::numeric_limits<double>::epsilon();
}

/// Whether it depends on rounding if the ray hits the triangle, or if it hits it first. The sum of
/// angles has a margin outside the edges.
bool is_borderline(const TestSet& set, std::size_t ray, std::int64_t triangle,
                   const NearestHit& other, const Variant& variant) {
    if (triangle < 0) {
        return false;
    }
    const Exact hit = exact(set, ray, triangle, epsilon_of(variant.precision), variant.technique);
    const double slack = variant.form.kernel == KernelName::angle_sum ? hit.slack : 0;
    return std::abs(hit.depth()) <= kRoundings * hit.weight_error + slack ||
           std::abs(hit.t) <= kRoundings * hit.distance_error * std::abs(hit.t) ||
           std::abs(hit.t - other.t) <= kRoundings * hit.distance_error * std::abs(hit.t);
}

/// One of so many rays may hit another triangle.
unsigned others_in(const Variant& variant) {
    if (variant.precision == Precision::single_precision &&
        variant.form.kernel == KernelName::angle_sum) {
        return 50;
    }
    return variant.technique == Technique::axis_fixed ? 200 : 1000;
}

void expect_hits_of_reference(const Variant& variant, const TestSet& set,
                              const std::vector<NearestHit>& reference) {
    const std::vector<NearestHit> hits = hits_of(variant, set);
    const double epsilon = epsilon_of(variant.precision);
    ASSERT_EQ(hits.size(), reference.size());
    int other_triangles = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const NearestHit& hit = hits[i];
        const NearestHit& expected = reference[i];
        const bool is_same = variant.technique == Technique::any_hit
                                 ? (hit.triangle < 0) == (expected.triangle < 0)
                                 : hit.triangle == expected.triangle;
        if (!is_same) {
            other_triangles += 1;
            EXPECT_TRUE(is_borderline(set, i, hit.triangle, expected, variant) ||
                        is_borderline(set, i, expected.triangle, hit, variant))
                << "ray " << i << ": " << hit.triangle << " not " << expected.triangle;
        } else if (hit.triangle >= 0 && variant.technique != Technique::any_hit) {
            const Exact exact_hit = exact(set, i, hit.triangle, epsilon, variant.technique);
            EXPECT_NEAR(hit.t / expected.t, 1, kRoundings * exact_hit.distance_error);
            EXPECT_NEAR(hit.u, expected.u, kRoundings * exact_hit.weight_error);
            EXPECT_NEAR(hit.v, expected.v, kRoundings * exact_hit.weight_error);
        }
    }
    EXPECT_LE(other_triangles, static_cast<int>(hits.size() / others_in(variant)));
}

TEST_P(Kernels, RandomRays_HitsOfMollerTrumboreInHigherPrecision) {
    const TestSet set = set_for(GetParam().technique, make_random_set(100, 1));
    for (const Precision precision : kPrecisions) {
        const std::vector<Variant> variants = variants_of(GetParam(), precision);
        if (!variants.empty()) {
            expect_hits_of_reference(variants.front(), set, reference_hits(precision, set));
        }
    }
}

TEST_P(Kernels, EveryRayHits_HitsOfMollerTrumboreInHigherPrecision) {
    const TestSet set = set_for(GetParam().technique, make_worst_set(10, 2));
    for (const Precision precision : kPrecisions) {
        const std::vector<Variant> variants = variants_of(GetParam(), precision);
        if (!variants.empty()) {
            expect_hits_of_reference(variants.front(), set, reference_hits(precision, set));
        }
    }
}

/// The scalar variant that computes the same numbers: that of the plain technique, unless the
/// technique changes the formulas or the order in which Badouel's adds.
Variant same_numbers(Variant variant) {
    variant.packing = Packing::single;
    if (variant.technique == Technique::any_hit) {
        return variant;
    }
    const bool is_other_order =
        variant.technique == Technique::axis_by_order && variant.form.kernel == KernelName::badouel;
    if (!changes_numbers(variant.technique) && !is_other_order) {
        variant.technique = Technique::plain;
    }
    return variant;
}

/// Every lane gives the same bits as a scalar, and wherever numbers lie, they are the same.
TEST_P(Kernels, Packed_SameBitsAsSingle) {
    for (const TestSet& whole : {make_random_set(50, 3), make_worst_set(3, 4)}) {
        const TestSet set = set_for(GetParam().technique, whole);
        for (const Variant& variant : variants_of(GetParam())) {
            const auto single = hits_of(same_numbers(variant), set);
            const auto packed = hits_of(variant, set);
            ASSERT_EQ(packed.size(), single.size());
            for (std::size_t i = 0; i < single.size(); ++i) {
                const auto where = std::string(name(variant.packing)) + " " + std::to_string(i);
                ASSERT_EQ(packed[i].triangle, single[i].triangle) << where;
                ASSERT_EQ(packed[i].t, single[i].t) << where;
                ASSERT_EQ(packed[i].u, single[i].u) << where;
                ASSERT_EQ(packed[i].v, single[i].v) << where;
            }
        }
    }
}

/// Groups of eight rays and eight triangles; each triangle is at all places of a group, with each
/// ray.
TestSet every_pair(const std::vector<TriangleCorners>& triangles,
                   const std::vector<std::pair<V3f, V3f>>& rays) {
    TestSet set;
    set.rays_in_group = 8;
    set.triangles_in_group = 8;
    for (const TriangleCorners& triangle : triangles) {
        for (std::size_t first = 0; first < rays.size(); first += 8) {
            set.triangles.insert(set.triangles.end(), 8, triangle);
            for (std::size_t i = first; i < first + 8; ++i) {
                set.origins.push_back(rays[std::min(i, rays.size() - 1)].first);
                set.directions.push_back(rays[std::min(i, rays.size() - 1)].second.normalized());
            }
        }
    }
    return set;
}

/// Points, lines, needles, the smallest and largest numbers; rays through the inside, along the
/// edges, in the plane and from a corner.
TestSet degenerate_set() {
    const V3f o(0, 0, 0);
    const V3f x(1, 0, 0);
    const V3f y(0, 1, 0);
    const V3f third(0.3f, 0.7f, 0.1f);
    std::vector<TriangleCorners> triangles{{o, o, o},
                                           {x, x, y},
                                           {x, y, x},
                                           {y, x, x},
                                           {o, x, 2.f * x},
                                           {o, third, 3.f * third},
                                           {x, x, x},
                                           {o, x, x + 1e-7f * y},
                                           {o, x, 0.5f * x + 1e-20f * y}};
    for (const float size : {1e-44f, 1e-38f, 1e-30f, 1e-20f, 1e-12f, 1e12f, 1e18f, 1e30f}) {
        triangles.push_back({size * x, size * y, size * third});
        triangles.push_back({x, x + size * y, x + size * third});
    }
    const std::vector<V3f> origins{
        o, x, 0.5f * x, V3f(0.2f, 0.2f, 1), V3f(0, 0, -3), V3f(-2, 0, 0)};
    const std::vector<V3f> directions{
        x, y, -x, V3f(0, 0, 1), V3f(0, 0, -1), third, V3f(1, 1, 0), V3f(0.1f, -0.2f, -1)};
    std::vector<std::pair<V3f, V3f>> rays;
    for (const V3f& origin : origins) {
        for (const V3f& direction : directions) {
            rays.emplace_back(origin, direction);
        }
    }
    return every_pair(triangles, rays);
}

TEST_P(Kernels, DegenerateTriangles_EveryHitIsOfNumbers) {
    const TestSet set = set_for(GetParam().technique, degenerate_set());
    for (const Variant& variant : variants_of(GetParam())) {
        for (const NearestHit& hit : hits_of(variant, set)) {
            if (hit.triangle < 0 || variant.technique == Technique::any_hit) {
                continue;
            }
            EXPECT_TRUE(hit.t > 0 && hit.t < std::numeric_limits<double>::infinity());
            if (variant.technique == Technique::sign_bits) {
                continue;  // also accepts weights that are not numbers
            }
            EXPECT_TRUE(hit.u >= 0 && hit.v >= 0 && hit.u + hit.v <= 1.001)
                << hit.u << ' ' << hit.v;
        }
    }
}

/// Whole numbers, so that nothing is rounded: an edge belongs to both of its triangles, a corner to
/// all around it, seen from both sides. Newton's step rounds, and sign bits tell 0 from -0.
TEST_P(Kernels, OnSharedEdge_BothTrianglesHit) {
    const Technique technique = GetParam().technique;
    if (technique == Technique::newton || technique == Technique::sign_bits ||
        shares_rays(technique)) {  // these rays have nothing in common
        return;
    }
    const V3f a(0, 0, 2);
    const V3f b(4, 0, 2);
    const V3f c(4, 4, 2);
    const V3f d(0, 4, 2);
    const TestSet set = every_pair({{a, b, c}, {c, d, a}}, {{V3f(2, 2, 0), V3f(0, 0, 1)},
                                                            {V3f(2, 2, 4), V3f(0, 0, -1)},
                                                            {V3f(0, 0, 0), V3f(0, 0, 1)},
                                                            {V3f(4, 4, 4), V3f(0, 0, -1)}});
    for (const Variant& variant : variants_of(GetParam())) {
        for (const NearestHit& hit : hits_of(variant, set)) {
            EXPECT_EQ(hit.triangle, 0);
            if (technique != Technique::any_hit) {
                EXPECT_EQ(hit.t, 2);
            }
        }
    }
}

/// Whether no ray slips between triangles even in float: the half-spaces at the origin have exactly
/// opposite numbers on the two sides of an edge, and the sum of angles has a margin.
bool is_tight(KernelName kernel) {
    return kernel == KernelName::origin_half_spaces || kernel == KernelName::angle_sum;
}

/// In other kernels, rays within a rounding of an edge may slip between its triangles, in float
/// about one in eight of those aimed at it. In double none is seen, because directions in float
/// miss the edge by more than roundings in double.
TEST_P(Kernels, TowardsSharedEdge_FewSlipThrough) {
    if (GetParam().technique == Technique::parallel_rays) {
        return;  // rays towards an edge are not parallel
    }
    const TestSet set = make_edge_set(3000, 7);
    ASSERT_GT(set.origins.size(), 10'000u);
    for (const Precision precision : kPrecisions) {
        const std::vector<Variant> variants = variants_of(GetParam(), precision);
        if (variants.empty()) {
            continue;
        }
        const auto hits = hits_of(variants.back(), set);
        const auto slipped = std::count_if(hits.begin(), hits.end(),
                                           [](const NearestHit& hit) { return hit.triangle < 0; });
        if (precision == Precision::double_precision || is_tight(GetParam().form.kernel)) {
            EXPECT_EQ(slipped, 0);
        } else {
            EXPECT_GT(slipped, 0);
            EXPECT_LT(slipped, static_cast<int>(set.origins.size()) / 4);
        }
    }
}

TEST(Sets, Worst_EveryRayHitsEveryTriangleNearerThanTheOneBefore) {
    const TestSet set = make_worst_set(20, 5);
    for (std::size_t ray = 0; ray < set.origins.size(); ++ray) {
        double nearest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < set.triangles_in_group; ++i) {
            const Exact hit = exact(set, ray, i, 0);
            ASSERT_GT(hit.depth(), 0.01);
            ASSERT_LT(hit.t, nearest);
            nearest = hit.t;
        }
        ASSERT_GT(nearest, 0);
    }
}

TEST(Sets, Random_HasHitsAndMisses) {
    const TestSet set = make_random_set(20, 5);
    const auto hits = reference_hits(Precision::single_precision, set);
    const auto hit_count = std::count_if(hits.begin(), hits.end(),
                                         [](const NearestHit& hit) { return hit.triangle >= 0; });
    EXPECT_GT(hit_count, 400);
    EXPECT_LT(hit_count, 900);
}

TEST(Names, KernelsAndTechniques_HaveTheirOwn) {
    std::set<KernelName> kernels;
    std::set<std::string_view> names;
    for (const Form& form : all_forms()) {
        kernels.insert(form.kernel);
        names.insert(name(form.kernel));
    }
    EXPECT_EQ(kernels.size(), static_cast<std::size_t>(kKernelCount));
    EXPECT_EQ(names.size(), kernels.size());
    for (const Technique technique : kTechniques) {
        names.insert(name(technique));
    }
    EXPECT_EQ(names.size(), kernels.size() + kTechniques.size());
}

TEST(Variants, WithoutTheInput_NoRun) {
    const Variant variant{{KernelName::wald, Input::corners, Division::early}};
    EXPECT_FALSE(exists(variant));
    EXPECT_EQ(make_run(variant, make_random_set(1, 1)), nullptr);
}

}  // namespace
}  // namespace carom::render::triangle
