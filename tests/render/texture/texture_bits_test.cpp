// The bits of textures are pinned: a change that means to change pictures changes these sums.
#include <bit>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "tests/render/texture/every_texture.h"
#include "tests/render/texture/texture_values.h"

namespace carom::render {
namespace {

constexpr int kPoints = 20'000;

/// A sum of bits that depends on their order (Fowler, Noll and Vo's hash FNV-1a by words).
class BitSum {
  public:
    void add(const V3f& v) {
        for (const float x : {v.x, v.y, v.z}) {
            // -0 and 0 are the same colour.
            const std::uint32_t bits = x == 0 ? 0 : std::bit_cast<std::uint32_t>(x);
            sum_ = (sum_ ^ bits) * 0x100000001b3ull;
        }
    }
    [[nodiscard]] std::uint64_t value() const { return sum_; }

  private:
    std::uint64_t sum_ = 0xcbf29ce484222325ull;
};

TEST(Texture, EveryKind_HasThePinnedBits) {
    const std::map<std::string, std::uint64_t> pinned{
        {"constant", 0x10e6bb89f55562e5u},
        {"image by uv", 0x5cb33d9d88f9367du},
        {"image by size", 0x9e4b45fca69d8684u},
        {"grey of 8 bits", 0x46bca9fff15a519bu},
        {"grey of 16 bits", 0x134862d06bd061dfu},
        {"colours of 8 bits", 0xd9f29b8939fd1042u},
        {"colours of 16 bits", 0x84a2bddbbc63ffa1u},
        {"transparent grey", 0x98e2531c4c205318u},
        {"transparent colours", 0x5148bb641ce65d3eu},
        {"planar image", 0x73150bb2e66076ebu},
        {"image around a box", 0x23f52657d33c8fceu},
        {"image around a sphere", 0xdee677b6c5fe3519u},
        {"plain ball", 0xea5ea71cc1401405u},
        {"ball with a number", 0x32ac29206c0e4877u},
        {"striped ball with spots", 0xf8ba417e5222bed2u},
        {"cloth", 0x54fa787c8e3758d9u},
        {"coarse cloth", 0x3d666b243c92754du},
        {"wood", 0x6fb0afd6d487372bu},
        {"oblique wood", 0x1575c949bc772adeu},
        {"checker", 0xc5a2623f5e0bd29cu},
        {"checker by uv", 0xd2f1812402ad1e5bu},
        {"turned cloth around a box", 0xf0802b6f77f43b0du},
        {"turned wood", 0x65b129b5b0fa6b5du},
        {"worn cloth", 0x2e226569ed63bc8fu},
        {"worn cloth of a table", 0x2c9508f35c1afb5au},
        {"smudges", 0x8e93c81200eb66a8u},
    };
    for (const test::NamedTexture& one : test::every_texture()) {
        test::TestRandom random(11);
        BitSum sum;
        for (int i = 0; i < kPoints; ++i) {
            const SurfacePoint point = test::random_texture_point(random);
            const float footprint = test::random_footprint(random);
            if (one.texture.has_relief()) {
                const test::Relief relief = test::relief_of(one.texture, point, footprint);
                sum.add(relief.colour);
                sum.add(relief.normal_shift);
                ASSERT_EQ(test::colour_of(one.texture, point, footprint), relief.colour);
            } else {
                sum.add(test::colour_of(one.texture, point, footprint));
            }
        }
        EXPECT_TRUE(pinned.contains(one.name)) << one.name;
        EXPECT_EQ(sum.value(), pinned.contains(one.name) ? pinned.at(one.name) : 0)
            << one.name << " " << std::hex << sum.value();
    }
}

}  // namespace
}  // namespace carom::render
