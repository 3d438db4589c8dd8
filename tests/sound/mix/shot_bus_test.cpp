// Where the sounds of a shot come together.
#include "sound/mix/shot_bus.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/sound/named_room.h"

namespace carom::sound {
namespace {

using Samples = std::array<double, kBlock + 1>;

/// What is heard of one sample of 1, which is the `at`-th of a block.
struct Response {
    std::vector<double> left, right;
};
Response response(ShotBus& bus, const BusInput& input, std::size_t at, int blocks) {
    Response heard;
    for (int i = 0; i < blocks; ++i) {
        Samples samples{};
        if (i == 0) {
            samples[at + 1] = 1;
        }
        if (i == 1 && at + 1 == kBlock) {
            samples[0] = 1;  // the block before ended with it
        }
        if (i < 2) {
            bus.add(input, samples);
        }
        std::array<double, kBlock> left{};
        std::array<double, kBlock> right{};
        bus.take(left, right);
        heard.left.insert(heard.left.end(), left.begin(), left.end());
        heard.right.insert(heard.right.end(), right.begin(), right.end());
    }
    return heard;
}

TEST(ShotBus, Input_GoesToItsChannelAfterItsDelay) {
    ShotBus bus(room_named("none"), false);
    const Response heard =
        response(bus, {BusInput::To::right, false, false, 0.5, 0.25, 1000}, 239, 8);
    for (std::size_t n = 0; n < heard.left.size(); ++n) {
        EXPECT_EQ(heard.left[n], 0);
        EXPECT_EQ(heard.right[n], n == 1239 ? 0.5 : n == 1240 ? 0.25 : 0) << n;
    }
}

TEST(ShotBus, LongestDelay_IsKeptAndALongerOneLeftOut) {
    ShotBus bus(room_named("none"), false);
    const BusInput longest{BusInput::To::left, false, false, 1, 0, ShotBus::kLongestDelay};
    const Response heard = response(bus, longest, 7, 104);
    EXPECT_EQ(heard.left[ShotBus::kLongestDelay + 7], 1);
    BusInput longer = longest;
    ++longer.delay;
    for (const double sample : response(bus, longer, 7, 104).left) {
        EXPECT_EQ(sample, 0);
    }
}

// Both halves of an ear's filter are the ear's filter.
TEST(ShotBus, FilteredInput_IsThatOfTheEar) {
    const Ear ear = ears_of(Stereo::sphere, Width::real, {}, {1, 1, 0}).left;
    ShotBus bus(room_named("none"), false);
    const Response heard =
        response(bus, {BusInput::To::left, false, true, ear.b0, ear.b1, 0}, 10, 2);
    EarFilter filter;
    for (std::size_t n = 0; n < heard.left.size(); ++n) {
        EXPECT_NEAR(heard.left[n], filter.run(ear, n == 10 ? 1 : 0), 1e-15);
    }
}

TEST(ShotBus, ReflectedInput_PassesTheWalls) {
    RoomSettings room = room_named("club");
    const double pole = reflections_of(room, {0, 0, 0}, {1, 1, 0})[0].pole;
    ASSERT_GT(pole, 0.01);
    ShotBus bus(room, false);
    const Response heard = response(bus, {BusInput::To::left, true, false, 1, 0, 0}, 0, 1);
    for (int n = 0; n < 20; ++n) {
        EXPECT_NEAR(heard.left[static_cast<std::size_t>(n)], (1 - pole) * std::pow(pole, n), 1e-15);
    }
}

TEST(ShotBus, Reverberation_InMono_IsTheSameInBothChannels) {
    for (const bool is_mono : {true, false}) {
        ShotBus bus(room_named("club"), is_mono);
        const Response heard = response(bus, {BusInput::To::room, false, false, 1, 0, 0}, 0, 40);
        EXPECT_EQ(heard.left == heard.right, is_mono);
        EXPECT_NE(heard.left[5000], 0);
    }
}

TEST(ShotBus, Silence_ComesWhenNothingIsLeft) {
    ShotBus bus(room_named("none"), false);
    EXPECT_EQ(response(bus, {BusInput::To::left, false, false, 1, 0, 20'000}, 0, 50).left.back(),
              0);
    EXPECT_FALSE(bus.is_silent());
    std::array<double, kBlock> left{};
    std::array<double, kBlock> right{};
    for (int i = 0; i < 60; ++i) {
        bus.take(left, right);
    }
    EXPECT_TRUE(bus.is_silent());
}

}  // namespace
}  // namespace carom::sound
