// Vector lanes give the bits of scalar code, on every instruction set.
#include "tests/render/texture/texture_lanes.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include <Imath/half.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <xmmintrin.h>

#include "tests/render/texture/every_texture.h"
#include "tests/render/texture/texture_values.h"

namespace carom::test {
namespace {

using render::SurfacePoint;
using render::Texture;
using render::V3f;

constexpr std::size_t kPoints = 4096;
static_assert(kPoints % kLaneMultiple == 0);

/// Numbers that denormals are flushed to zero with, as in a frame; or not.
class FlushMode {
  public:
    explicit FlushMode(bool flushes) : saved_(_mm_getcsr()) {
        _mm_setcsr(flushes ? saved_ | 0x8040u : saved_);
    }
    ~FlushMode() { _mm_setcsr(saved_); }
    FlushMode(const FlushMode&) = delete;
    FlushMode& operator=(const FlushMode&) = delete;

  private:
    unsigned saved_;
};

struct Points {
    std::vector<SurfacePoint> points;
    std::vector<float> footprints;
    PointLists lists;

    void add(const SurfacePoint& point, float footprint) {
        points.push_back(point);
        footprints.push_back(footprint);
        lists.add(point, footprint);
    }
};

/// Neighbours differ in level and in what they resolve.
Points mixed_points() {
    TestRandom random(23);
    Points made;
    while (made.points.size() < kPoints) {
        SurfacePoint point = random_texture_point(random);
        point.x_axis = {0.6f, 0.8f, 0};
        point.y_axis = {-0.8f, 0.6f, 0};
        made.add(point, random_footprint(random));
    }
    return made;
}

struct Channels {
    std::vector<float> values[3] = {std::vector<float>(kPoints), std::vector<float>(kPoints),
                                    std::vector<float>(kPoints)};
    float* pointers[3] = {values[0].data(), values[1].data(), values[2].data()};

    [[nodiscard]] V3f at(std::size_t i) const { return {values[0][i], values[1][i], values[2][i]}; }
};

std::array<std::uint32_t, 3> bits_of(const V3f& v) {
    return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
            std::bit_cast<std::uint32_t>(v.z)};
}

void expect_bits_of_scalar_code(const TextureLanes& lanes, const Points& points) {
    for (const NamedTexture& one : every_texture()) {
        Channels colour;
        lanes.colours(one.texture.data(), points.lists, colour.pointers);
        for (std::size_t i = 0; i < kPoints; ++i) {
            const float footprint = points.footprints[i];
            ASSERT_EQ(bits_of(colour.at(i)),
                      bits_of(test::colour_of(one.texture, points.points[i], footprint)))
                << one.name << " on " << lanes.target << ", point " << i << ", footprint "
                << footprint;
        }
        if (!one.texture.has_relief()) {
            continue;
        }
        Channels shift;
        lanes.reliefs(one.texture.data(), points.lists, colour.pointers, shift.pointers);
        for (std::size_t i = 0; i < kPoints; ++i) {
            const test::Relief relief =
                test::relief_of(one.texture, points.points[i], points.footprints[i]);
            ASSERT_EQ(bits_of(colour.at(i)), bits_of(relief.colour)) << one.name;
            ASSERT_EQ(bits_of(shift.at(i)), bits_of(relief.normal_shift))
                << one.name << " on " << lanes.target;
        }
    }
}

TEST(TextureLanes, EveryTarget_GivesTheBitsOfScalarCode) {
    const Points points = mixed_points();
    std::set<std::string_view> targets;
    for_every_target([&](const TextureLanes& lanes) {
        targets.insert(lanes.target);
        for (const bool flushes : {false, true}) {
            const FlushMode mode(flushes);
            expect_bits_of_scalar_code(lanes, points);
        }
    });
    // The lowest target and two kinds of SSE at least.
    EXPECT_GE(targets.size(), 3u) << testing::PrintToString(targets);
}

TEST(TextureLanes, Alone_ALaneGivesWhatItGivesBesideOthers) {
    const Points points = mixed_points();
    const TextureLanes& lanes = best_texture_lanes();
    for (const NamedTexture& one : every_texture()) {
        Channels together;
        lanes.colours(one.texture.data(), points.lists, together.pointers);
        for (std::size_t i = 0; i < kPoints; i += 41) {
            PointLists same;
            for (std::size_t lane = 0; lane < kLaneMultiple; ++lane) {
                same.add(points.points[i], points.footprints[i]);
            }
            Channels alone;
            lanes.colours(one.texture.data(), same, alone.pointers);
            ASSERT_EQ(bits_of(alone.at(0)), bits_of(together.at(i))) << one.name;
        }
    }
}

/// Lanes without a path hold any numbers; the address sanitizer sees a look-up outside.
TEST(TextureLanes, UnusableNumbers_ReadNothingOutsideAndSpareTheOtherLanes) {
    const float worst[] = {std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity(),
                           3e38f,
                           -3e38f,
                           1e-40f,
                           -0.0f};
    Points points = mixed_points();
    Points spoilt;
    for (std::size_t i = 0; i < kPoints; ++i) {
        SurfacePoint point = points.points[i];
        float footprint = points.footprints[i];
        const float bad = worst[i / 2 % std::size(worst)];
        if (i % 2 == 0) {
            const bool is_all = i % 4 == 0;
            point.object_position = is_all ? V3f(bad) : V3f(0.01f, bad, 0.02f);
            point.geometric_normal = is_all ? V3f(bad) : V3f(0, 0, 1);
            point.uv = is_all ? render::V2f(bad, bad) : render::V2f(0.3f, bad);
            point.uv_metres = is_all ? render::V2f(bad, bad) : point.uv_metres;
            footprint = i % 8 == 0 ? bad : footprint;
        }
        spoilt.add(point, footprint);
    }
    for_every_target([&](const TextureLanes& lanes) {
        for (const NamedTexture& one : every_texture()) {
            Channels colour;
            lanes.colours(one.texture.data(), spoilt.lists, colour.pointers);
            for (std::size_t i = 0; i < kPoints; ++i) {
                if (i % 2 == 0) {
                    // What is not limited to the picture is not a number.
                    ASSERT_TRUE(one.name.starts_with("checker") ||
                                std::isfinite(colour.at(i).length()))
                        << one.name << " on " << lanes.target << ", point " << i;
                    continue;
                }
                ASSERT_EQ(
                    bits_of(colour.at(i)),
                    bits_of(test::colour_of(one.texture, points.points[i], points.footprints[i])))
                    << one.name << " on " << lanes.target;
            }
        }
    });
}

/// Zeros that take no memory before they are changed.
class SparseBytes {
  public:
    explicit SparseBytes(std::size_t size)
        : size_(size),
          bytes_(static_cast<std::uint8_t*>(::mmap(nullptr, size, PROT_READ | PROT_WRITE,
                                                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1,
                                                   0))) {}
    ~SparseBytes() { ::munmap(bytes_, size_); }
    SparseBytes(const SparseBytes&) = delete;
    SparseBytes& operator=(const SparseBytes&) = delete;

    [[nodiscard]] std::uint8_t* data() const { return bytes_; }
    [[nodiscard]] std::size_t size() const { return size_; }

  private:
    std::size_t size_;
    std::uint8_t* bytes_;
};

TEST(TextureLanes, LargestPicture_IsReadUpToItsLastByte) {
    constexpr int kSide = 26'754;  // 3 * kSide^2 is just below 2^31
    constexpr std::size_t kBytes = std::size_t{3} * kSide * kSide;
    const SparseBytes codes(kBytes + render::kReadBeyond);
    ASSERT_NE(codes.data(), MAP_FAILED);
    codes.data()[kBytes - 2] = 1;  // green of the last texel
    std::vector<float> values(256);
    values[1] = 1;
    render::TextureData texture;
    texture.kind = render::TextureKind::image;
    render::ImageParameters& image = texture.image;
    image.picture.codes = render::List<std::uint8_t>(codes);
    image.picture.values = render::List<float>(values);
    image.picture.width = kSide;
    image.picture.height = kSide;
    image.picture.levels.longest_side = 0.5f * kSide;
    PointLists points;
    for (std::size_t i = 0; i < kLaneMultiple; ++i) {
        SurfacePoint point;
        // The centre of the last texel, and in other lanes of the one above it.
        point.uv = render::V2f((kSide - 0.5f) / kSide, (i % 2 == 0 ? 0.5f : 1.5f) / kSide);
        points.add(point, 0);
    }
    for_every_target([&](const TextureLanes& lanes) {
        Channels colour;
        lanes.colours(texture, points, colour.pointers);
        for (std::size_t i = 0; i < kLaneMultiple; ++i) {
            EXPECT_NEAR(colour.at(i).y, i % 2 == 0 ? 1 : 0, 0.01f) << lanes.target;
            EXPECT_EQ(colour.at(i).x, 0) << lanes.target;
        }
    });
}

/// Decoded by Imath without flushing; NaN as 0x7fc00000.
std::vector<std::uint32_t> halves_by_imath() {
    std::vector<std::uint32_t> bits;
    for (std::uint32_t half = 0; half < 0x10000; ++half) {
        const float value = imath_half_to_float(static_cast<std::uint16_t>(half));
        bits.push_back(std::isnan(value) ? 0x7fc00000u : std::bit_cast<std::uint32_t>(value));
    }
    return bits;
}

TEST(HalfValue, EveryHalfFloat_IsThatOfImathInEveryLaneAndMode) {
    const std::vector<std::uint32_t> expected = halves_by_imath();
    std::vector<std::uint32_t> words;
    for (std::uint32_t half = 0; half < 0x10000; ++half) {
        words.push_back(half | (half * 40503u << 16));  // the upper half is ignored
    }
    const auto check = [&](float value, std::size_t half, std::string_view target) {
        const std::uint32_t bits =
            std::isnan(value) ? 0x7fc00000u : std::bit_cast<std::uint32_t>(value);
        ASSERT_EQ(bits, expected[half]) << std::hex << half << " on " << target;
    };
    for (const bool flushes : {false, true}) {
        const FlushMode mode(flushes);
        for (std::size_t half = 0; half < words.size(); ++half) {
            const auto texel = static_cast<std::uint16_t>(half);
            const auto colour = render::HalfColourCodec::decode({0, texel, texel, 0});
            check(colour.y, half, "scalar code");
            check(colour.z, half, "scalar code");
        }
        for_every_target([&](const TextureLanes& lanes) {
            std::vector<float> values(words.size());
            lanes.halves(words, values.data());
            for (std::size_t half = 0; half < words.size(); ++half) {
                check(values[half], half, lanes.target);
            }
        });
    }
}

}  // namespace
}  // namespace carom::test
