#include "render/sampling/sampler.h"

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "render/sampling/scalar_kernels.h"
#include "render/sampling/sobol_tables.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using Point = std::vector<float>;

std::vector<Point> camera_points(std::uint64_t seed, std::uint32_t pixel, int count) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        const CameraSample s =
            SampleStream(seed, pixel, 7, static_cast<std::uint32_t>(i)).camera_sample();
        points.push_back({s.pixel.x, s.pixel.y, s.lens.x, s.lens.y, s.time});
    }
    return points;
}

std::vector<Point> set_points(std::uint64_t seed, std::uint32_t pixel, int set, int count) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        SampleStream stream(seed, pixel, 7, static_cast<std::uint32_t>(i));
        std::array<float, 4> point{};
        for (int k = 0; k <= set; ++k) {
            point = stream.next_4d();
        }
        points.emplace_back(point.begin(), point.end());
    }
    return points;
}

/// The largest number of points in any box of the grid that has 2^bits[d] cells along dimension d.
int fullest_box(const std::vector<Point>& points, const std::vector<int>& bits) {
    int total = 0;
    for (const int b : bits) {
        total += b;
    }
    std::vector<int> counts(std::size_t{1} << total, 0);
    int fullest = 0;
    for (const Point& point : points) {
        std::size_t cell = 0;
        for (std::size_t d = 0; d < bits.size(); ++d) {
            const std::size_t cells = std::size_t{1} << bits[d];
            cell = cell * cells + static_cast<std::size_t>(point[d] * static_cast<float>(cells));
        }
        fullest = std::max(fullest, ++counts[cell]);
    }
    return fullest;
}

std::vector<Point> project(const std::vector<Point>& points, std::size_t a, std::size_t b) {
    std::vector<Point> result;
    for (const Point& point : points) {
        result.push_back({point[a], point[b]});
    }
    return result;
}

/// The quality t of a pair of dimensions over 2^m points: the smallest t such that every elementary
/// interval of 2^(t - m) holds exactly 2^t points.
int pair_quality(const std::vector<Point>& pair, int m) {
    for (int t = 0; t < m; ++t) {
        bool holds = true;
        for (int k = 0; k <= m - t && holds; ++k) {
            holds = fullest_box(pair, {k, m - t - k}) == (1 << t);
        }
        if (holds) {
            return t;
        }
    }
    return m;
}

// The worst t of each pair of Joe and Kuo's first five dimensions over 2^6, 2^8 and 2^10 points,
// computed by an independent program without scrambling; Owen's scrambling conserves it.
constexpr int kWorstPairQuality[5][5] = {
    {0, 0, 1, 2, 2}, {0, 0, 1, 2, 2}, {1, 1, 0, 1, 3}, {2, 2, 1, 0, 3}, {2, 2, 3, 3, 0}};

TEST(SampleStream, CameraPoint_EveryCoordinateIsStratified) {
    for (const int m : {4, 6, 10}) {
        const auto points = camera_points(11, 3, 1 << m);
        for (std::size_t d = 0; d < 5; ++d) {
            EXPECT_EQ(fullest_box(project(points, d, d), {m, 0}), 1) << "dimension " << d;
        }
    }
}

TEST(SampleStream, CameraPoint_PixelIsAPerfectNet) {
    for (int m = 1; m <= 12; ++m) {
        for (const std::uint32_t pixel : {0u, 1u, 500u}) {
            EXPECT_EQ(pair_quality(project(camera_points(5, pixel, 1 << m), 0, 1), m), 0);
        }
    }
}

TEST(SampleStream, CameraPoint_PairsKeepSobolsQuality) {
    for (const int m : {6, 8, 10}) {
        const auto points = camera_points(99, 8, 1 << m);
        for (std::size_t a = 0; a < 5; ++a) {
            for (std::size_t b = a + 1; b < 5; ++b) {
                EXPECT_LE(pair_quality(project(points, a, b), m), kWorstPairQuality[a][b])
                    << a << " " << b << " of 2^" << m;
            }
        }
    }
}

TEST(SampleStream, Sets_PairsKeepSobolsQuality) {
    for (int set = 0; set < 6; ++set) {
        const int m = 8;
        const auto points = set_points(42, 17, set, 1 << m);
        for (std::size_t a = 0; a < 4; ++a) {
            for (std::size_t b = a + 1; b < 4; ++b) {
                EXPECT_LE(pair_quality(project(points, a, b), m), kWorstPairQuality[a][b])
                    << a << " " << b << " of set " << set;
            }
        }
    }
}

TEST(SampleStream, AlignedRuns_AreNetsToo) {
    // Samples 64 to 127 of a pixel are as well distributed as the first 64.
    std::vector<Point> points;
    for (std::uint32_t i = 64; i < 128; ++i) {
        SampleStream stream(4, 5, 6, i);
        const auto p = stream.next_4d();
        points.push_back({p[0], p[1]});
    }
    EXPECT_EQ(pair_quality(points, 6), 0);
}

TEST(SampleStream, DifferentSets_AreIndependent) {
    // First coordinates of camera point and two sets against each other: a 16 x 16 table of counts
    // over many pixels must not deviate from uniform.
    const int pixels = 4'000;
    for (int pair = 0; pair < 3; ++pair) {
        std::vector<double> observed(256, 0.0);
        for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
            for (std::uint32_t i = 0; i < 4; ++i) {
                SampleStream stream(1, pixel, 0, i);
                const float c = stream.camera_sample().pixel.x;
                const float s0 = stream.next_4d()[0];
                const float s1 = stream.next_4d()[0];
                const float x = pair == 2 ? s0 : c;
                const float y = pair == 0 ? s0 : s1;
                observed[static_cast<std::size_t>(x * 16) * 16 +
                         static_cast<std::size_t>(y * 16)] += 1;
            }
        }
        const std::vector<double> expected(256, pixels * 4 / 256.0);
        EXPECT_GT(test::chi_square_p_value(observed, expected), 1e-4);
    }
}

TEST(SampleStream, DifferentPixelsAndSeeds_AreIndependent) {
    std::vector<double> by_pixel(256, 0.0);
    std::vector<double> by_seed(256, 0.0);
    const auto cell = [](float x, float y) {
        return static_cast<std::size_t>(x * 16) * 16 + static_cast<std::size_t>(y * 16);
    };
    const int count = 20'000;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float here = SampleStream(8, i, 2, 0).next_4d()[0];
        by_pixel[cell(here, SampleStream(8, i, 3, 0).next_4d()[0])] += 1;
        by_seed[cell(here, SampleStream(9, i, 2, 0).next_4d()[0])] += 1;
    }
    const std::vector<double> expected(256, count / 256.0);
    EXPECT_GT(test::chi_square_p_value(by_pixel, expected), 1e-4);
    EXPECT_GT(test::chi_square_p_value(by_seed, expected), 1e-4);
}

TEST(SampleStream, EveryNumber_LiesInHalfOpenUnitInterval) {
    for (std::uint32_t i = 0; i < 200'000; ++i) {
        SampleStream stream(i, i * 7, i * 13, i * 2654435761u);
        const CameraSample camera = stream.camera_sample();
        const auto set = stream.next_4d();
        for (const float x : {camera.pixel.x, camera.pixel.y, camera.lens.x, camera.lens.y,
                              camera.time, set[0], set[1], set[2], set[3]}) {
            ASSERT_GE(x, 0.f);
            ASSERT_LT(x, 1.f);
        }
    }
}

TEST(SampleStream, SameArguments_SameNumbers) {
    SampleStream a(123456789012345ull, 4, 5, 6);
    SampleStream b(123456789012345ull, 4, 5, 6);
    EXPECT_EQ(a.camera_sample().time, b.camera_sample().time);
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(a.next_4d(), b.next_4d());
    }
    SampleStream copy = a;
    EXPECT_EQ(copy.next_4d(), a.next_4d());
}

TEST(SampleStream, FixedArguments_FixedBits) {
    // Pictures depend on these numbers: a change here requires a new kRendererRevision.
    SampleStream stream(1, 2, 3, 4);
    const CameraSample camera = stream.camera_sample();
    const auto set = stream.next_4d();
    std::vector<std::uint32_t> bits;
    for (const float x : {camera.pixel.x, camera.time, set[0], set[3]}) {
        bits.push_back(static_cast<std::uint32_t>(x * 0x1p24f));
    }
    EXPECT_EQ(bits, (std::vector<std::uint32_t>{7076218, 9500771, 5000550, 7602071}));
}

TEST(SampleStream, SmoothIntegrand_ErrorFallsFasterThanByChance) {
    // Integral over [0, 1]^5 of the product of (2/3 + x): exact value (7/6)^5.
    const double exact = std::pow(7.0 / 6, 5);
    const auto error = [&](int count) {
        double sum = 0;
        for (std::uint32_t pixel = 0; pixel < 32; ++pixel) {
            double mean = 0;
            for (const Point& p : camera_points(3, pixel, count)) {
                double product = 1;
                for (const float x : p) {
                    product *= 2.0 / 3 + static_cast<double>(x);
                }
                mean += product / count;
            }
            sum += (mean - exact) * (mean - exact);
        }
        return std::sqrt(sum / 32);
    };
    // Independent numbers would give a factor of 4 from 64 to 1024 samples; Owen scrambling on
    // smooth functions approaches 16^1.5 = 64 (Owen 1997).
    EXPECT_GT(error(64) / error(1024), 20);
}

TEST(SampleStream, SquareBlocks_AreOneSequenceOfFourTimesAsMany) {
    for (const int samples : {1, 4, 16, 64}) {
        std::vector<Point> points;
        for (int i = 0; i < samples; ++i) {
            const SampleStream stream(3, 5, 7, static_cast<std::uint32_t>(i));
            float x[4], y[4];
            scalar::SamplerOf<scalar::One>(stream.pixel_hash(), stream.reversed_sample())
                .get_2d_block(9, x, y);
            for (int k = 0; k < 4; ++k) {
                points.push_back({x[k], y[k]});
            }
        }
        // All divisions of the square into as many boxes as there are points.
        int bits = 0;
        while (1 << bits < 4 * samples) {
            ++bits;
        }
        for (int across = 0; across <= bits; ++across) {
            EXPECT_EQ(fullest_box(points, {across, bits - across}), 1) << samples << ' ' << across;
        }
    }
}

}  // namespace
}  // namespace carom::render
